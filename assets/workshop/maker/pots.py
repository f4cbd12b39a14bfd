"""Pots that others threw before: on the shelves, on the bench, under the window. All lathed from outlines."""
import math

from . import building, furniture, shapes
from .frame import dice

# Outlines as radius over height, evenly spaced from foot to lip, in units of the pot's height.
OUTLINES = {
    "moon jar": [0.24, 0.40, 0.485, 0.505, 0.485, 0.40, 0.265, 0.245],
    "bottle": [0.17, 0.26, 0.295, 0.265, 0.165, 0.078, 0.062, 0.070, 0.105],
    "maebyeong": [0.165, 0.155, 0.170, 0.215, 0.262, 0.285, 0.255, 0.120, 0.105, 0.125],
    "jar": [0.26, 0.36, 0.42, 0.44, 0.425, 0.37, 0.29, 0.265, 0.30],
    "onggi": [0.25, 0.34, 0.395, 0.425, 0.432, 0.415, 0.365, 0.295, 0.275, 0.31],
    "bowl": [0.34, 0.36, 0.62, 0.80, 0.93, 1.02, 1.08],
    "tea bowl": [0.36, 0.50, 0.64, 0.71, 0.74, 0.745, 0.77],
    "cylinder": [0.36, 0.372, 0.375, 0.372, 0.366, 0.362, 0.368],
    "crock": [0.40, 0.47, 0.505, 0.515, 0.51, 0.49, 0.50],
    "cup": [0.36, 0.44, 0.47, 0.475, 0.47, 0.485],
}


def pot(name, outline, height, material, at, wall=0.0042, rings=0.00035, pitch=0.0085, turn=(0, 0, 0), cuts=72):
    """One thrown pot: an outline with throwing rings, a rounded lip and a hollow inside."""
    rng = dice(name)
    steps = max(24, int(90 * shapes.fineness))
    line = shapes.smooth_line([(r,) for r in OUTLINES[outline]], steps)
    phase = rng.uniform(0, 6.28)
    outside = []
    for k, (share,) in enumerate(line):
        z = height * k / (steps - 1)
        wobble = math.sin(z / pitch * 2 * math.pi + phase + 1.7 * math.sin(z * 70 + phase))
        calm = min(1.0, 6 * k / steps, 5 * (steps - 1 - k) / steps)
        outside.append((share * height + rings * wobble * calm, z))
    radius, top = outside[-1]
    lip = [(radius - wall / 2 + wall / 2 * math.cos(a), top + wall / 2 * math.sin(a))
           for a in (0.35, 0.8, 1.25, 1.57, 1.9, 2.35, 2.8)]
    inside = [(max(r - wall, 0.002), z) for r, z in reversed(outside) if z > 2 * wall]
    foot = outside[0][0]
    profile = [(0, 0.002), (foot * 0.86, 0.002), (foot * 0.9, 0.0)] + outside + lip + inside + [(0, 2 * wall)]
    return shapes.lathe(name, profile, material, at, turn, cuts)


def lid(name, radius, material, at):
    """The lid of an onggi jar: a shallow dish upside down with a knob."""
    r = radius
    shapes.lathe(name, [(r, 0.0), (r + 0.004, 0.004), (r + 0.002, 0.012), (r * 0.75, 0.026), (r * 0.3, 0.034),
                        (0.016, 0.036), (0.013, 0.044), (0.019, 0.051), (0.017, 0.057), (0, 0.059)], material, at, cuts=72)


def build(paint):
    shelf, high, bench = furniture.SHELF_TOP, furniture.HIGH_SHELF_TOP, furniture.BENCH_TOP
    deep = building.BACK - 0.10

    def put(name, outline, height, material, x, y, z, **more):
        pot(name, outline, height, paint[material], (x, y, z), **more)

    put("celadon maebyeong", "maebyeong", 0.205, "celadon", 0.245, deep, shelf)
    for k in range(4):  # tea bowls stacked in fours as they come out of the kiln
        put("white bowl %d" % k, "tea bowl", 0.062, "moon white", 0.365, deep - 0.01, shelf + 0.0185 * k)
    put("buncheong bottle", "bottle", 0.195, "buncheong", 0.478, deep + 0.01, shelf)
    put("moon jar", "moon jar", 0.150, "moon white", 0.605, deep, shelf, rings=0.0004)
    put("ash jar", "jar", 0.125, "ash", 0.745, deep, shelf)
    put("shelf cup a", "cup", 0.080, "onggi glaze", 0.850, deep - 0.03, shelf)
    put("shelf cup b", "cup", 0.082, "celadon", 0.930, deep + 0.01, shelf)
    put("shelf bottle", "bottle", 0.190, "bisque", 1.030, deep, shelf)

    for k in range(3):
        put("drying bowl %d" % k, "bowl", 0.066, "greenware", -0.105 + 0.168 * k, deep - 0.01, high)
    put("high moon jar", "moon jar", 0.215, "moon white", 0.425, deep, high, rings=0.0004)
    put("high onggi", "onggi", 0.165, "onggi glaze", 0.615, deep, high)
    put("high celadon bottle", "bottle", 0.235, "celadon", 0.77, deep, high)
    for k in range(3):
        put("drying cup %d" % k, "cup", 0.085, "greenware", 0.885 + 0.095 * k, deep - 0.02, high)

    # Under the window: jars for soy and water, the ones the program is named after.
    put("great onggi", "onggi", 0.265, "onggi glaze", -0.665, 0.77, bench, wall=0.008, rings=0.0007, pitch=0.016, cuts=112)
    lid("great lid", 0.094, paint["onggi glaze"], (-0.665, 0.77, bench + 0.266))
    put("small onggi", "onggi", 0.165, "onggi glaze", -0.455, 0.70, bench, wall=0.006, rings=0.0005, pitch=0.012)
    put("bud vase", "bottle", 0.150, "ash", -0.325, 0.80, bench)

    put("bench bowl", "bowl", 0.075, "buncheong", 0.245, 0.665, bench)
    put("brush jar", "cylinder", 0.105, "ash", 0.395, 0.72, bench)
    for k in range(3):
        put("bisque cup %d" % k, "cup", 0.078, "bisque", 0.80 + 0.088 * k, 0.78 - 0.03 * (k % 2), bench)
