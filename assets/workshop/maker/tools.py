"""Tools within reach, and the small things that say somebody works here."""
import math

from . import furniture, pots, shapes
from .frame import dice


def build(paint):
    _deck_things(paint)
    _bench_things(paint)


def _deck_things(paint):
    deck = furniture.DECK_TOP
    rng = dice("deck")
    # Water within reach of the right hand: an onggi bowl, a sponge beside it.
    pots.pot("water bowl", "crock", 0.082, paint["onggi glaze"], (0.325, 0.105, deck), wall=0.006,
             rings=0.0002, pitch=0.012, cuts=112)
    shapes.lathe("water", [(0.0355, 0.0), (0, 0.0)], paint["slip water"], (0.325, 0.105, deck + 0.066))
    shapes.lump("sponge", (0.033, 0.025, 0.017), paint["sponge"], rng, (0.300, -0.045, deck), roughness=0.22)
    _rib(paint, (0.385, -0.065, deck), 0.5)
    _needle(paint, (-0.315, -0.055, deck), 1.25)
    _loop_tool(paint, (-0.352, -0.045, deck), 1.38)
    _wire(paint, (-0.335, 0.135, deck))


def _rib(paint, at, angle):
    """A kidney-shaped rib of boxwood."""
    shape = shapes.box("rib", (0.076, 0.040, 0.006), paint["boxwood"], (at[0], at[1], at[2] + 0.003), (0, 0, angle),
                       bevel=0.0028)
    for vertex in shape.data.vertices:  # bend the block into a kidney
        x = vertex.co.x / 0.038
        vertex.co.y += 0.011 * (1 - x * x) * (1 if vertex.co.y > 0 else 0.35)
        if vertex.co.y < 0:
            vertex.co.x *= 0.86


def _needle(paint, at, angle):
    turn = (0, 0, angle)
    shapes.tube("needle handle", [(0, 0, 0.0052), (0.045, 0, 0.0058), (0.085, 0, 0.0052)], 0.0055, paint["boxwood"],
                at, turn)
    shapes.tube("needle ferrule", [(0.085, 0, 0.0052), (0.094, 0, 0.0050)], 0.0036, paint["brass"], at, turn)
    shapes.tube("needle", [(0.094, 0, 0.0050), (0.138, 0, 0.0040)], 0.0011, paint["steel"], at, turn, taper=0.3)


def _loop_tool(paint, at, angle):
    turn = (0, 0, angle)
    shapes.tube("loop handle", [(0, 0, 0.006), (0.05, 0, 0.0064), (0.105, 0, 0.0056)], 0.006, paint["dark timber"], at, turn)
    shapes.tube("loop ferrule", [(0.103, 0, 0.0056), (0.118, 0, 0.0056)], 0.0048, paint["brass"], at, turn)
    loop = [(0.118 + 0.0165 * (1 - math.cos(a)), 0.0125 * math.sin(a), 0.0056)
            for a in (2 * math.pi * k / 24 for k in range(25))]
    shapes.tube("loop", loop, 0.0012, paint["steel"], at, turn)


def _wire(paint, at):
    """The cutting wire with its two toggles, dropped as it fell."""
    line = shapes.smooth_line([(-0.055, 0.03, 0.002), (-0.03, 0.055, 0.0015), (0.02, 0.045, 0.001), (0.03, 0.0, 0.001),
                               (-0.01, -0.015, 0.002), (-0.03, 0.02, 0.003), (0.012, 0.07, 0.0015), (0.06, 0.06, 0.002)], 60)
    shapes.tube("cutting wire", line, 0.0008, paint["steel"], at)
    for end, angle in ((line[0], 0.9), (line[-1], 2.2)):
        c, s = math.cos(angle) * 0.026, math.sin(angle) * 0.026
        rod = [(end[0] + k * c, end[1] + k * s, 0.0062) for k in (-1.0, -0.97, 0.97, 1.0)]
        shapes.tube("toggle", rod, 0.0062, paint["boxwood"], at)


def _bench_things(paint):
    bench = furniture.BENCH_TOP
    rng = dice("bench")
    jar = (0.395, 0.72)
    for k in range(7):  # brushes and tools standing in the ash-glazed jar
        angle = 2 * math.pi * k / 7 + rng.uniform(-0.3, 0.3)
        lean = rng.uniform(0.018, 0.028)
        tall = rng.uniform(0.165, 0.215)
        foot = (0.018 * math.cos(angle + 3.1), 0.018 * math.sin(angle + 3.1), 0.008)
        head = (lean * 1.5 * math.cos(angle), lean * 1.5 * math.sin(angle), tall)
        wood = paint["boxwood" if k % 2 else "dark timber"]
        shapes.tube("handle", [foot, head], 0.0034, wood, (*jar, bench), taper=1.35)
        if k % 3 == 0:
            tip = tuple(h + (h - f) * 0.16 for h, f in zip(head, foot))
            shapes.tube("brush tip", [head, tip], 0.0062, paint["bristle"], (*jar, bench), taper=0.35)
    # A block of clay cut from the bag, with a lump pulled off it.
    shapes.box("clay block", (0.15, 0.11, 0.085), paint["wet clay"], (0.575, 0.715, bench + 0.0425), (0, 0, 0.22), bevel=0.008)
    shapes.lump("wedged clay", (0.052, 0.046, 0.043), paint["wet clay"], rng, (0.475, 0.615, bench), roughness=0.07)
    shapes.lump("small lump", (0.030, 0.027, 0.026), paint["wet clay"], rng, (0.395, 0.605, bench), roughness=0.09)
    _twig(paint, (-0.325, 0.80, bench + 0.13))


def _twig(paint, at):
    """A branch of plum before it flowers, in the small bottle: the one thing here that is not for work."""
    rng = dice("twig")
    trunk = shapes.smooth_line([(0, 0, -0.09), (0.004, 0.0, 0.02), (0.022, -0.008, 0.085), (0.020, -0.004, 0.15),
                                (0.052, -0.015, 0.215), (0.062, -0.006, 0.270)], 30)
    shapes.tube("twig", trunk, 0.0026, paint["twig"], at, taper=0.35)
    for start, along in ((9, (-0.055, 0.012, 0.085)), (14, (0.052, 0.006, 0.060)), (20, (-0.034, -0.006, 0.062))):
        base = trunk[start]
        side = shapes.smooth_line([base, tuple(b + 0.5 * d + rng.uniform(-0.008, 0.008) for b, d in zip(base, along)),
                                   tuple(b + d for b, d in zip(base, along))], 12)
        shapes.tube("side twig", side, 0.0016, paint["twig"], at, taper=0.4)
        for point in side[4::3]:
            shapes.lump("bud", (0.0042, 0.0042, 0.005), paint["bud"], rng, tuple(a + p for a, p in zip(at, point)), detail=2)
    for point in trunk[17::4]:
        shapes.lump("bud", (0.0042, 0.0042, 0.005), paint["bud"], rng, tuple(a + p for a, p in zip(at, point)), detail=2)
