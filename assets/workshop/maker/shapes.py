"""Mesh makers: lathe, box, ring plate, tube, lump. Metres, Blender's frame. Each returns the new object.

`fineness` scales how finely round things are cut: 1 for plates, less for the room that goes into a GLB.
"""
import math

import bmesh
import bpy

fineness = 1.0


def segments(count, least=12):
    return max(least, int(round(count * fineness / 2)) * 2)


def _finish(name, builder, material, at, turn, smooth_deg):
    mesh = bpy.data.meshes.new(name)
    builder.normal_update()
    builder.to_mesh(mesh)
    builder.free()
    mesh.materials.append(material)
    if smooth_deg:
        for polygon in mesh.polygons:
            polygon.use_smooth = True
        mesh.use_auto_smooth = True
        mesh.auto_smooth_angle = math.radians(smooth_deg)
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(thing)
    thing.location = at
    thing.rotation_euler = turn
    return thing


def lathe(name, profile, material, at=(0, 0, 0), turn=(0, 0, 0), cuts=72, smooth_deg=40):
    """Turns a profile of (radius, z) about the z axis. A radius of 0 closes the surface. The profile runs
    with the solid on its left: up the outside, over the rim, down the inside."""
    cuts = segments(cuts)
    builder = bmesh.new()
    rings = []
    for radius, z in profile:
        if radius <= 0:
            rings.append([builder.verts.new((0, 0, z))])
        else:
            rings.append([builder.verts.new((radius * math.cos(2 * math.pi * k / cuts),
                                             radius * math.sin(2 * math.pi * k / cuts), z))
                          for k in range(cuts)])
    for low, high in zip(rings, rings[1:]):
        for k in range(cuts):
            n = (k + 1) % cuts
            corners = [low[k % len(low)], low[n % len(low)], high[n % len(high)], high[k % len(high)]]
            face = list(dict.fromkeys(corners))
            if len(face) > 2:
                builder.faces.new(face)
    return _finish(name, builder, material, at, turn, smooth_deg)


def box(name, size, material, at=(0, 0, 0), turn=(0, 0, 0), bevel=0.002):
    """A box with its centre at `at`; the edges are broken, for no edge in a workshop is sharp."""
    builder = bmesh.new()
    bmesh.ops.create_cube(builder, size=1.0)
    for vertex in builder.verts:
        vertex.co.x *= size[0]
        vertex.co.y *= size[1]
        vertex.co.z *= size[2]
    if bevel:
        bmesh.ops.bevel(builder, geom=builder.edges[:], offset=bevel, segments=2, affect="EDGES", profile=0.6)
    return _finish(name, builder, material, at, turn, 30)


def plate_with_hole(name, half_width, front, back, hole_radius, thickness, material, at=(0, 0, 0), cuts=128):
    """A board from x = -half_width to half_width and y = front to back with a round hole about the origin;
    its top is at z = 0."""
    cuts = segments(cuts, 32)
    angles = sorted({2 * math.pi * k / cuts for k in range(cuts)} |
                    {math.atan2(y, x) % (2 * math.pi) for x in (-half_width, half_width) for y in (front, back)})
    builder = bmesh.new()
    loops = []
    for radius, z in ((hole_radius, -thickness), (hole_radius, -0.003), (hole_radius + 0.003, 0), (None, 0),
                      (None, -thickness)):
        loop = []
        for angle in angles:
            c, s = math.cos(angle), math.sin(angle)
            reach = radius
            if reach is None:
                limits = [half_width / abs(c)] if abs(c) > 1e-9 else []
                if abs(s) > 1e-9:
                    limits.append((back if s > 0 else -front) / abs(s))
                reach = min(limits)
            loop.append(builder.verts.new((reach * c, reach * s, z)))
        loops.append(loop)
    for inner, outer in zip(loops, loops[1:]):
        for k in range(len(angles)):
            n = (k + 1) % len(angles)
            builder.faces.new((inner[k], outer[k], outer[n], inner[n]))
    return _finish(name, builder, material, at, (0, 0, 0), 30)


def tube(name, points, radius, material, at=(0, 0, 0), turn=(0, 0, 0), cuts=20, taper=1.0):
    """A round rod along a line of points; `taper` is the radius at its end over that at its beginning."""
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    curve.bevel_depth = radius
    curve.bevel_resolution = max(1, int(cuts * fineness) // 4 - 1)
    curve.use_fill_caps = True
    spline = curve.splines.new("POLY")
    spline.points.add(len(points) - 1)
    for k, (slot, point) in enumerate(zip(spline.points, points)):
        slot.co = (*point, 1.0)
        slot.radius = 1.0 + (taper - 1.0) * k / max(1, len(points) - 1)
    pattern = bpy.data.objects.new(name, curve)
    bpy.context.scene.collection.objects.link(pattern)
    mesh = bpy.data.meshes.new_from_object(pattern.evaluated_get(bpy.context.evaluated_depsgraph_get()))
    bpy.data.objects.remove(pattern)
    bpy.data.curves.remove(curve)
    builder = bmesh.new()
    builder.from_mesh(mesh)
    bpy.data.meshes.remove(mesh)
    return _finish(name, builder, material, at, turn, 40)


def lump(name, size, material, rng, at=(0, 0, 0), roughness=0.12, flat_below=-0.7, detail=4):
    """Something soft: a ball pushed about by a few waves and set down flat. `size` are half widths."""
    builder = bmesh.new()
    bmesh.ops.create_icosphere(builder, subdivisions=max(2, detail - (1 if fineness < 0.8 else 0)), radius=1.0)
    waves = [([rng.uniform(-3.5, 3.5) for _ in range(3)], rng.uniform(0, 6.28)) for _ in range(9)]
    for vertex in builder.verts:
        p = vertex.co.copy()
        push = sum(math.sin(w[0] * p.x + w[1] * p.y + w[2] * p.z + phase) for w, phase in waves) / len(waves)
        p *= 1.0 + roughness * 2.2 * push
        p.z = max(p.z, flat_below)
        vertex.co = (p.x * size[0], p.y * size[1], (p.z - flat_below) * size[2])
    return _finish(name, builder, material, at, (0, 0, rng.uniform(0, 6.28)), 180)


def smooth_line(points, count):
    """A curve through the points (Catmull and Rom, 1974), as `count` points; tuples of any length."""
    line = []
    last = len(points) - 1
    for k in range(count):
        t = k / (count - 1) * last
        i = min(int(t), last - 1)
        u = t - i
        a, b, c, d = (points[max(i - 1, 0)], points[i], points[i + 1], points[min(i + 2, last)])
        line.append(tuple(0.5 * (2 * q + (r - p) * u + (2 * p - 5 * q + 4 * r - s) * u * u +
                                 (3 * q - p - 3 * r + s) * u ** 3) for p, q, r, s in zip(a, b, c, d)))
    return line
