"""What the pots and tools stand on: the bench along the wall, two shelves, the deck of the wheel."""
from . import building, shapes

BENCH_TOP = -0.115
BENCH_FRONT = 0.56
SHELF_TOP = 0.072
SHELF_LEFT = 0.17
HIGH_SHELF_TOP = 0.345
HIGH_SHELF_LEFT = -0.20
DECK_TOP = -0.058   # the timber deck around the splash pan
DECK = {"half_width": 0.60, "front": -0.36, "back": 0.27}


def build(paint):
    _bench(paint)
    _shelf("shelf", paint, SHELF_LEFT, 1.28, SHELF_TOP, 0.185)
    _shelf("high shelf", paint, HIGH_SHELF_LEFT, 1.28, HIGH_SHELF_TOP, 0.20)
    _deck(paint)


def _bench(paint):
    back, floor = building.BACK, building.FLOOR
    deep = back - BENCH_FRONT
    thick = 0.042
    wide = 2.5
    shapes.box("bench top", (wide, deep, thick), paint["oak boards"],
               (0.05, back - deep / 2, BENCH_TOP - thick / 2), bevel=0.004)
    for x in (-1.0, -0.1, 0.75):
        shapes.box("bench leg", (BENCH_TOP - thick - floor, 0.065, 0.065), paint["dark timber"],
                   (x, BENCH_FRONT + 0.06, (BENCH_TOP - thick + floor) / 2), (0, 1.5708, 0))
    shapes.box("bench rail", (wide - 0.1, 0.03, 0.07), paint["dark timber"],
               (0.05, BENCH_FRONT + 0.06, BENCH_TOP - thick - 0.036))
    shapes.box("bench foot board", (wide - 0.1, deep - 0.08, 0.028), paint["dark timber"],
               (0.05, back - deep / 2, floor + 0.14))


def _shelf(name, paint, left, right, top, deep):
    back = building.BACK
    thick = 0.026
    shapes.box(name, (right - left, deep, thick), paint["oak"], ((left + right) / 2, back - deep / 2, top - thick / 2),
               bevel=0.003)
    for x in (left + 0.12, (left + right) / 2, right - 0.12):
        shapes.box(name + " bracket", (0.024, deep * 0.82, 0.030), paint["dark timber"],
                   (x, back - deep * 0.41, top - thick - 0.015))
        shapes.box(name + " strut", (0.15, 0.022, 0.022), paint["dark timber"],
                   (x, back - deep * 0.36, top - thick - 0.065), (0, 0.82, 1.5708))


def _deck(paint):
    thick = 0.036
    shapes.plate_with_hole("wheel deck", DECK["half_width"], DECK["front"], DECK["back"], 0.2245, thick,
                           paint["deck boards"], (0, 0, DECK_TOP))
    for x in (-DECK["half_width"] + 0.05, DECK["half_width"] - 0.05):
        for y in (DECK["front"] + 0.05, DECK["back"] - 0.05):
            high = DECK_TOP - thick - building.FLOOR
            shapes.box("deck leg", (high, 0.06, 0.06), paint["dark timber"], (x, y, building.FLOOR + high / 2),
                       (0, 1.5708, 0))
    for y in (DECK["front"] + 0.05, DECK["back"] - 0.05):
        shapes.box("deck rail", (2 * DECK["half_width"] - 0.1, 0.03, 0.06), paint["dark timber"],
                   (0, y, DECK_TOP - thick - 0.03))
