"""Solids as distance functions: a function takes points, an array of n x 3 in mm, and gives n distances to the
surface, negative inside. Soft unions make flesh of bones: what no box of polygons does well."""
import numpy as np


def vector(*xyz):
    return np.array(xyz, dtype=np.float64)


def bone(a, b, radius_a, radius_b=None, flat=None):
    """A rod from a to b with rounded ends. flat: (direction, factor): thinner along that direction."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    radius_b = radius_a if radius_b is None else radius_b
    along = b - a
    length2 = max(along @ along, 1e-9)

    def distance(points):
        offset = points - a
        share = np.clip(offset @ along / length2, 0.0, 1.0)
        across = offset - share[:, None] * along
        if flat is not None:
            direction, factor = flat
            direction = np.asarray(direction, float) / np.linalg.norm(direction)
            across = across + (across @ direction)[:, None] * direction * (1.0 / factor - 1.0)
        return np.linalg.norm(across, axis=1) - (radius_a + (radius_b - radius_a) * share)

    return distance


def chain(points, radii):
    """Bones through these points, softly joined."""
    links = [bone(points[i], points[i + 1], radii[i], radii[i + 1]) for i in range(len(points) - 1)]
    return soft_union(links, 2.0)


def ball(centre, radii):
    """An ellipsoid; the distance is right at the surface only, which is all the mesher asks."""
    centre, radii = np.asarray(centre, float), np.broadcast_to(np.asarray(radii, float), 3)

    def distance(points):
        scaled = np.linalg.norm((points - centre) / radii, axis=1)
        return (scaled - 1.0) * radii.min()

    return distance


def soft_union(solids, softness):
    """Their union, with a fillet of about this width where they meet."""
    def distance(points):
        nearest = solids[0](points)
        for solid in solids[1:]:
            other = solid(points)
            bridge = np.maximum(softness - np.abs(nearest - other), 0.0) / softness
            nearest = np.minimum(nearest, other) - bridge * bridge * softness * 0.25
        return nearest

    return distance


def soft_intersection(solids, softness):
    turned_out = soft_union([lambda points, s=s: -s(points) for s in solids], softness)
    return lambda points: -turned_out(points)


def without(solid, hole, softness):
    return soft_intersection([solid, lambda points: -hole(points)], softness)


def half_space(normal, offset):
    """What lies below the plane normal . p = offset."""
    normal = np.asarray(normal, float) / np.linalg.norm(normal)
    return lambda points: points @ normal - offset


def uneven(solid, depth_mm, pitch_mm, seed):
    """The solid with a lumpy surface: a few plane waves across each other."""
    random = np.random.default_rng(seed)
    directions = random.normal(size=(7, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    pitches = pitch_mm * random.uniform(0.6, 1.6, 7)
    phases = random.uniform(0.0, 2.0 * np.pi, 7)

    def distance(points):
        waves = np.sin(points @ directions.T * (2.0 * np.pi / pitches) + phases).mean(axis=1)
        return solid(points) + depth_mm * waves

    return distance


def turned(solid, rotation, origin=(0, 0, 0)):
    """The solid turned by a 3 x 3 matrix about a point."""
    rotation, origin = np.asarray(rotation, float), np.asarray(origin, float)
    return lambda points: solid((points - origin) @ rotation + origin)


def moved(solid, offset):
    offset = np.asarray(offset, float)
    return lambda points: solid(points - offset)


def rotation(axis, degrees):
    """The matrix that turns by this much about an axis, counter-clockwise seen from its tip."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
                     [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
                     [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)]])


def gradient(solid, points, step=0.05):
    """Outward unit normals of the surface at these points."""
    slope = np.stack([solid(points + step * axis) - solid(points - step * axis) for axis in np.eye(3)], axis=1)
    return slope / np.maximum(np.linalg.norm(slope, axis=1, keepdims=True), 1e-9)


def open_sky(solid, points, normals, reach_mm=28.0, steps=6):
    """How much of the half space over each point is free, 0 to 1: the distance function sampled along the normal."""
    closed = np.zeros(len(points))
    weights = 0.0
    for step in range(1, steps + 1):
        along = reach_mm * (step / steps) ** 1.5
        weight = 1.0 / step
        closed += weight * np.clip(1.0 - solid(points + along * normals) / along, 0.0, 1.0)
        weights += weight
    return np.clip(1.0 - 1.05 * closed / weights, 0.05, 1.0)
