"""The pots that are thrown to be shown. Each is the moves of throwing.py with its own lengths."""
import math
from dataclasses import dataclass, field
from typing import Callable

import throwing as t


@dataclass
class Demonstration:
    hands: Callable
    options: list = field(default_factory=list)
    pots: dict = field(default_factory=dict)  # --on and --join: sessions that come first


def start():
    hands = t.Hands(radius=12.0, wheel_rev_min=150.0)
    t.centre(hands, 62.0, 22.0, 34.0, 0.5)
    return hands


def cylinder():
    hands = start()
    hands.wheel = 120.0
    t.open_up(hands, 52.0, 12.0, 45.0)
    t.foot(hands, 57.0, 12.0)
    hands.wheel = 100.0
    wall = t.between((15.0, 56.0), (80.0, 55.0), (160.0, 55.0))
    for gap, top in ((13.0, 85.0), (10.0, 112.0), (8.0, 145.0), (6.5, 170.0), (5.8, 182.0)):
        t.pull(hands, 15.0, wall, gap, 28.0, top)
    t.fair(hands, "sponge", wall, 14.0, 160.0, 5.0)
    return hands


def wide_open(hands, base, pulls, passes, wide, clear):
    """A bowl from a lump that runs true: thrown up as a cylinder, then opened from the rim down, which keeps
    the wall leaning out and the rim in one piece."""
    hands.wheel = 120.0
    t.open_up(hands, base + 2.0, 12.0, base - 12.0)
    t.foot(hands, base, 12.0)
    hands.wheel = 100.0
    wall = t.between((15.0, base), (70.0, base + 4.0), (150.0, base + 4.0))
    for gap, top in pulls:
        t.pull(hands, 15.0, wall, gap, 28.0, top)
    hands.wheel = 80.0
    thrown = t.between((20.0, base - 7.0), (150.0, base - 4.0))
    for share, rim in passes:
        t.shape_inside(hands, t.towards(thrown, wide, share), rim, 23.0, 5.0, clear)


def round_to(inner, outer, height):
    """An inner face that rises from one radius to another and stands upright at that height."""
    return lambda y: inner + (outer - inner) * math.sin(0.5 * math.pi * min(1.0, max(0.0, y - 8.0) / height))


def bowl():
    hands = start()
    wide_open(hands, 50.0, ((11.0, 105.0), (8.0, 130.0)), ((0.3, 130.0), (0.65, 156.0), (1.0, 152.0)),
              round_to(33.0, 97.0, 120.0), 175.0)
    hands.cut("rim", 118.0)
    return hands


def half_a_jar():
    hands = t.Hands(radius=12.0, wheel_rev_min=150.0)
    t.centre(hands, 57.0, 20.0, 31.0, 0.5)
    wide_open(hands, 48.0, ((11.0, 95.0), (8.0, 115.0)), ((0.35, 105.0), (0.7, 122.0), (1.0, 118.0)),
              round_to(35.0, 75.0, 82.0), 150.0)
    hands.cut("rim", 90.0)
    return hands


def moon_jar():
    """On the two halves, joined: the mouth drawn in and set upright, the belly faired over the seam."""
    hands = t.Hands(radius=9.0, wheel_rev_min=70.0)
    hands.hold(1.5)
    rim = t.between((130.0, 74.0), (166.0, 50.0), (190.0, 50.0))
    mouth = t.between((130.0, 74.0), (165.0, 44.5), (190.0, 44.0))
    for share in (0.4, 0.7, 1.0):
        t.shape_outside(hands, t.towards(rim, mouth, share), 140.0, 186.0, 4.0)
    t.fair(hands, "rib", t.between((14.0, 51.0), (50.0, 73.0), (90.0, 84.8), (130.0, 73.0), (166.0, 45.0)),
           30.0, 145.0, 9.0)
    t.fair(hands, "sponge", mouth, 150.0, 176.0, 3.0)
    return hands


def collapse():
    """A bowl drawn too wide, and then the pedal down."""
    hands = start()
    wide_open(hands, 50.0, ((11.0, 105.0), (8.0, 130.0)), ((0.3, 130.0), (0.65, 156.0), (1.0, 152.0)),
              round_to(33.0, 107.0, 112.0), 175.0)
    hands.wheel = 300.0
    hands.hold(2.0)
    return hands


def vase():
    hands = start()
    hands.wheel = 120.0
    t.open_up(hands, 52.0, 12.0, 40.0)
    t.foot(hands, 52.0, 12.0)
    hands.wheel = 100.0
    wall = t.between((15.0, 51.0), (80.0, 51.0), (180.0, 50.0))
    for gap, top in ((10.0, 105.0), (7.0, 150.0)):
        t.pull(hands, 15.0, wall, gap, 32.0, top)
    hands.wheel = 80.0
    thrown = t.between((20.0, 43.0), (200.0, 43.0))
    belly = t.between((20.0, 43.0), (75.0, 62.0), (130.0, 43.0), (200.0, 43.0))
    for share in (0.5, 1.0):
        t.shape_inside(hands, t.towards(thrown, belly, share), 26.0, 122.0, 3.6, 195.0)
    straight = t.between((100.0, 50.0), (200.0, 50.0))
    neck = t.between((90.0, 64.0), (150.0, 31.0), (190.0, 36.0))
    for share in (0.5, 1.0):
        t.shape_outside(hands, t.towards(straight, neck, share), 112.0, 198.0, 3.2)
    shoulder = t.between((40.0, 57.0), (70.0, 69.0), (105.0, 55.0), (140.0, 34.0))
    t.fair(hands, "rib", shoulder, 90.0, 135.0, 3.5)
    return hands


ALL = {
    "cylinder": Demonstration(cylinder),
    "bowl": Demonstration(bowl),
    "vase": Demonstration(vase),
    "moon_jar_half": Demonstration(half_a_jar, ["--clay-mass", 800, "--body", "porcelain"]),
    "moon_jar": Demonstration(moon_jar, ["--mouth", 80], {"--on": "moon_jar_half", "--join": "moon_jar_half"}),
    "collapse": Demonstration(collapse),
}
