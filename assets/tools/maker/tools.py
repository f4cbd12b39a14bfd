"""Rib, sponge, trimming tool, wire, and the sponge on a stick that goes where no hand does."""
import numpy as np

from . import skin, solid
from .solid import bone, rotation, soft_intersection, soft_union, vector


def _box(centre, halves, rounding):
    centre, halves = np.asarray(centre, float), np.asarray(halves, float)

    def distance(points):
        outside = np.abs(points - centre) - (halves - rounding)
        return (np.linalg.norm(np.maximum(outside, 0.0), axis=1) +
                np.minimum(outside.max(axis=1), 0.0) - rounding)

    return distance


def _ring(centre, radius, thickness, normal):
    centre = np.asarray(centre, float)
    normal = np.asarray(normal, float) / np.linalg.norm(normal)

    def distance(points):
        offset = points - centre
        up = offset @ normal
        across = np.linalg.norm(offset - up[:, None] * normal, axis=1)
        return np.hypot(across - radius, up) - thickness

    return distance


def _wet_end(length_mm):
    """Clay where the tool meets it, thinning out away from it."""
    return lambda points: np.clip(1.0 - np.linalg.norm(points, axis=1) / length_mm, 0.0, 1.0) * 0.9


def _grain(points):
    return 0.5 + 0.07 * np.sin(points[:, 1] * 0.55 + 1.4 * np.sin(points[:, 2] * 0.21)) + 0.05 * np.sin(points[:, 1] * 1.7)


def rib():
    """A kidney of boxwood, its straight edge upright against the wall, its face under the finger tips."""
    kidney = soft_intersection([solid.ball((21, 0, 0), (26, 38, 60)), _box((23, 0, 0), (23, 44, 3.2), 2.4),
                                lambda p: 12.0 - np.hypot(p[:, 0] - 55.0, p[:, 1])], 3.0)
    tilted = solid.turned(kidney, rotation((0, 1, 0), -55) @ rotation((0, 0, 1), -8))
    return [skin.part("boxwood", tilted, vector(-20, -60, -45), vector(80, 60, 45), 1.1, 1100, _wet_end(46), _grain)]


def sponge():
    shape = solid.uneven(solid.ball((13, 2, 0), (13.5, 24, 28)), 1.5, 13, 5)
    shape = solid.uneven(shape, 0.9, 4.5, 6)
    return [skin.part("sponge", shape, vector(-8, -32, -36), vector(48, 36, 36), 1.2, 1500, _wet_end(34),
                      lambda p: 0.5 + 0.10 * np.sin(p[:, 0] * 1.3) * np.sin(p[:, 1] * 1.1) * np.sin(p[:, 2] * 1.2))]


def trimmer():
    """A loop of steel band in a turned handle; the loop cuts, the handle comes from the visitor's right."""
    along = rotation((0, 1, 0), -30) @ rotation((0, 0, 1), -24) @ vector(-1, 0, 0)
    out = -along
    loop = soft_union([_ring(out * 13.0, 12.0, 1.25, np.cross(out, vector(0, 1, 0))),
                       bone(out * 24.0, out * 34.0, 1.9)], 2.0)
    ferrule = bone(out * 33.0, out * 47.0, 4.3, 5.0)
    handle = solid.chain([out * 47.0, out * 66.0, out * 110.0, out * 158.0], (5.2, 6.9, 7.6, 5.4))
    low, high = vector(-30, -80, -20), vector(160, 20, 110)  # the handle hangs down, and is not cut off
    return [skin.part("steel", loop, low, vector(60, 60, 60), 0.7, 900, _wet_end(26)),
            skin.part("brass", ferrule, low, high, 1.3, 220),
            skin.part("dark timber", handle, low, high, 1.8, 520, lambda p: 0.06 * np.ones(len(p)), _grain)]


def stick():
    """For necks too narrow for a hand: a sponge tied to a slim stick, pointing down, the sponge against the wall."""
    head = solid.uneven(solid.ball((11, 0, 0), (11, 15, 11)), 0.9, 6, 9)
    rod = solid.chain([vector(12, 10, 0), vector(14, 120, 6), vector(20, 300, 22)], (3.6, 3.9, 4.6))
    tie = _ring((11.6, 13, 0), 4.6, 1.4, (0.02, 1, 0.05))
    return [skin.part("sponge", head, vector(-6, -20, -16), vector(28, 20, 16), 0.9, 380, _wet_end(24)),
            skin.part("boxwood", soft_union([rod, tie], 1.0), vector(0, 6, -12), vector(32, 312, 36), 1.3, 300,
                      lambda p: 0.5 * np.clip(1.0 - p[:, 1] / 90.0, 0.0, 1.0), _grain)]


def wire():
    """The cutting wire, stretched along Z through the origin, with a wooden toggle at each end. Long enough to pass
    under any foot; the hands that hold it are out of the picture."""
    line = bone((0, 0, -190), (0, 0, 190), 0.9)
    parts = [skin.part("steel", line, vector(-3, -3, -194), vector(3, 3, 194), 0.8, 260)]
    for side in (-1, 1):
        toggle = solid.chain([vector(0, -24, side * 194), vector(0, 0, side * 194), vector(0, 24, side * 194)], (5.0, 6.2, 5.0))
        parts.append(skin.part("boxwood", toggle, vector(-9, -33, side * 194 - 9), vector(9, 33, side * 194 + 9), 1.1, 240,
                               lambda p: 0.2 * np.ones(len(p)), _grain))
    return parts
