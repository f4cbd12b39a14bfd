"""The room itself: plastered walls, floor, posts and beam, and the paper window that fills the shadows."""
from . import shapes

FLOOR = -0.60       # the wheel head stands 0.60 m above the floor: one sits at it
BACK = 0.95         # face of the back wall
WINDOW = {"left": -0.86, "right": -0.34, "low": 0.005, "high": 0.66}
CEILING = 1.75
SIDE = 1.55
FRONT = -2.2


def build(paint):
    wall, timber = paint["plaster"], paint["dark timber"]
    thick = 0.12
    middle = BACK + thick / 2

    def piece(name, x0, x1, z0, z1):
        shapes.box(name, (x1 - x0, thick, z1 - z0), wall, ((x0 + x1) / 2, middle, (z0 + z1) / 2), bevel=0)

    w = WINDOW
    piece("wall left of window", -SIDE, w["left"], FLOOR, CEILING)
    piece("wall right of window", w["right"], SIDE, FLOOR, CEILING)
    piece("wall under window", w["left"], w["right"], FLOOR, w["low"])
    piece("wall over window", w["left"], w["right"], w["high"], CEILING)
    depth = BACK - FRONT
    height = CEILING - FLOOR
    for side, name in ((-1, "left wall"), (1, "right wall")):
        shapes.box(name, (0.1, depth, height), wall, (side * (SIDE + 0.05), (BACK + FRONT) / 2, (CEILING + FLOOR) / 2),
                   bevel=0)
    shapes.box("floor", (2 * SIDE, depth, 0.04), paint["earth"], (0, (BACK + FRONT) / 2, FLOOR - 0.02), bevel=0)
    shapes.box("ceiling", (2 * SIDE, depth, 0.04), wall, (0, (BACK + FRONT) / 2, CEILING + 0.02), bevel=0)

    shapes.box("beam", (0.13, 2 * SIDE, 0.15), timber, (0.0, BACK - 0.02, 1.02), (0, 0, 1.5708), bevel=0.006)
    for x in (-1.02, 1.02):
        shapes.box("post", (height, 0.11, 0.10), timber, (x, BACK - 0.015, (CEILING + FLOOR) / 2), (0, 1.5708, 0),
                   bevel=0.006)
    _window(paint)


def _bar(name, paint, width, depth, length, at, upright):
    turn = (0, 1.5708, 0) if upright else (0, 0, 0)
    size = (length, depth, width) if not upright else (length, depth, width)
    return shapes.box(name, size, paint["dark timber"], at, turn, bevel=0.0012)


def _window(paint):
    """Two leaves of a lattice in the way of Korean houses: uprights all along, cross bars in three bands."""
    w = WINDOW
    x0, x1, z0, z1 = w["left"], w["right"], w["low"], w["high"]
    wide, high = x1 - x0, z1 - z0
    y = BACK - 0.004
    frame = 0.034
    for x in (x0 - frame / 2, x1 + frame / 2):
        _bar("window jamb", paint, frame, 0.06, high + 2 * frame, (x, y, (z0 + z1) / 2), True)
    for z in (z0 - frame / 2, z1 + frame / 2):
        _bar("window head", paint, frame, 0.064, wide + 3.2 * frame, ((x0 + x1) / 2, y - 0.004, z), False)
    leaf = wide / 2
    stile = 0.020
    for left in (x0, x0 + leaf):
        right = left + leaf
        for x in (left + stile / 2, right - stile / 2):
            _bar("leaf stile", paint, stile, 0.026, high, (x, y + 0.012, (z0 + z1) / 2), True)
        for z in (z0 + stile / 2, z1 - stile / 2):
            _bar("leaf rail", paint, stile, 0.026, leaf, ((left + right) / 2, y + 0.0125, z), False)
        uprights = 5
        for k in range(1, uprights + 1):
            x = left + stile + (leaf - 2 * stile) * k / (uprights + 1)
            _bar("lattice upright", paint, 0.0065, 0.013, high - 2 * stile, (x, y + 0.014, (z0 + z1) / 2), True)
        pitch = 0.036
        bands = [z0 + 0.115, (z0 + z1) / 2, z1 - 0.115]
        for centre in bands:
            for k in (-1, 0, 1):
                _bar("lattice cross bar", paint, 0.0065, 0.012, leaf - 2 * stile,
                     ((left + right) / 2, y + 0.0135, centre + k * pitch), False)
    shapes.box("window paper", (wide, 0.002, high), paint["hanji"], ((x0 + x1) / 2, y + 0.024, (z0 + z1) / 2), bevel=0)
    shapes.box("window board", (wide + 0.16, 0.075, 0.02), paint["oak"], ((x0 + x1) / 2, BACK - 0.03, z0 - frame - 0.01),
               bevel=0.003)
