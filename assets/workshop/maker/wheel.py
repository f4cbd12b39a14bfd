"""The wheel: head (radius 150 mm, its top at z = 0), shaft, splash pan and the slip in it.

The head and what lies on it is symmetrical about the axis: on a plate it stands still while the wheel turns.
Nothing here rises above z = 0 in front of the pot, so the engine may draw the pot over the plate.
"""
import math

from . import shapes
from .frame import dice

HEAD_RADIUS = 0.150
PAN_RADIUS = 0.205     # inside, at the rim
PAN_BOTTOM = -0.060
RIM_TOP = -0.004


def build(paint):
    r = HEAD_RADIUS
    shapes.lathe("wheel head", [(0, -0.022), (0.120, -0.022), (r - 0.006, -0.020), (r - 0.001, -0.0165), (r, -0.014),
                                (r, -0.0035), (r - 0.0012, -0.0012), (r - 0.004, 0.0), (0.100, 0.0), (0.050, 0.0), (0, 0.0)],
                 paint["wheel head"], cuts=192)
    shapes.lathe("shaft", [(0.028, PAN_BOTTOM), (0.028, -0.030), (0.045, -0.022)], paint["steel"], cuts=48)
    p = PAN_RADIUS
    depth = RIM_TOP - PAN_BOTTOM
    profile = [(0.03, -0.003), (p - 0.020, -0.003), (p + 0.004, 0.006), (p + 0.0065, depth - 0.014), (p + 0.013, depth - 0.011),
               (p + 0.0155, depth - 0.006), (p + 0.0145, depth - 0.001), (p + 0.010, depth), (p + 0.004, depth - 0.002),
               (p + 0.001, depth - 0.008), (p - 0.003, 0.016), (p - 0.010, 0.006), (p - 0.022, 0.001), (0.03, 0.0)]
    shapes.lathe("splash pan", profile, paint["pan"], (0, 0, PAN_BOTTOM), cuts=192)
    shapes.lathe("slip in the pan", [(p - 0.0125, 0.0), (0.03, 0.0)], paint["slip water"], (0, 0, PAN_BOTTOM + 0.0042), cuts=96)

    rng = dice("trimmings")  # clay thrown off while trimming and throwing
    for _ in range(26):
        angle = rng.uniform(0, 2 * math.pi)
        reach = rng.uniform(0.158, p - 0.012)
        size = rng.uniform(0.003, 0.011)
        shapes.lump("clay in the pan", (size * rng.uniform(0.7, 1.6), size, size * 0.45), paint["wet clay"], rng,
                    (reach * math.cos(angle), reach * math.sin(angle), PAN_BOTTOM + 0.002), roughness=0.3, detail=3)
