"""Small things that say somebody works here. The tools that a hand takes, rib, sponge, wire and trimmer, are not
among them: the program draws them, on the bench or in a hand."""
import math

from . import furniture, pots, shapes
from .frame import dice


def build(paint):
    _deck_things(paint)
    _bench_things(paint)


def _deck_things(paint):
    deck = furniture.DECK_TOP
    # Water within reach of the right hand: an onggi bowl.
    pots.pot("water bowl", "crock", 0.082, paint["onggi glaze"], (0.325, 0.105, deck), wall=0.006,
             rings=0.0002, pitch=0.012, cuts=112)
    shapes.lathe("water", [(0.0355, 0.0), (0, 0.0)], paint["slip water"], (0.325, 0.105, deck + 0.066))
    _needle(paint, (-0.315, -0.055, deck), 1.25)


def _needle(paint, at, angle):
    turn = (0, 0, angle)
    shapes.tube("needle handle", [(0, 0, 0.0052), (0.045, 0, 0.0058), (0.085, 0, 0.0052)], 0.0055, paint["boxwood"],
                at, turn)
    shapes.tube("needle ferrule", [(0.085, 0, 0.0052), (0.094, 0, 0.0050)], 0.0036, paint["brass"], at, turn)
    shapes.tube("needle", [(0.094, 0, 0.0050), (0.138, 0, 0.0040)], 0.0011, paint["steel"], at, turn, taper=0.3)


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
