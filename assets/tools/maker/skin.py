"""Triangles over a solid: surface nets on a grid, thinned out by Blender, then laid back onto the surface."""
import bmesh
import bpy
import numpy as np

from . import solid as solids


def _grid(solid, low, high, cell_mm):
    counts = np.ceil((np.asarray(high, float) - low) / cell_mm).astype(int) + 1
    axes = [low[k] + cell_mm * np.arange(counts[k]) for k in range(3)]
    values = np.empty(counts)
    for i, x in enumerate(axes[0]):  # a slice at a time, so that a fine grid needs little memory
        y, z = np.meshgrid(axes[1], axes[2], indexing="ij")
        values[i] = solid(np.stack([np.full(y.size, x), y.ravel(), z.ravel()], axis=1)).reshape(y.shape)
    return values


def surface_nets(solid, low, high, cell_mm):
    """Vertices (n x 3, mm) and quads (m x 4, counter-clockwise from outside) of the surface in a box."""
    low = np.asarray(low, float)
    values = _grid(solid, low, high, cell_mm)
    inside = values < 0.0
    corners = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    size = np.array(values.shape) - 1

    def at(array, corner):
        return array[tuple(slice(corner[k], corner[k] + size[k]) for k in range(3))]

    # One vertex a cell that the surface passes: the mean of where it cuts the cell's edges.
    total, cuts = np.zeros((*size, 3)), np.zeros(size)
    for corner in corners:
        for axis in range(3):
            if corner[axis]:
                continue
            other = tuple(c + (k == axis) for k, c in enumerate(corner))
            here, there = at(values, corner), at(values, other)
            cut = at(inside, corner) != at(inside, other)
            share = np.where(cut, here / np.where(cut, here - there, 1.0), 0.0)
            for k in range(3):
                total[..., k] += np.where(cut, corner[k] + (share if k == axis else 0.0), 0.0)
            cuts += cut
    is_crossed = cuts > 0
    index = np.full(size, -1)
    index[is_crossed] = np.arange(is_crossed.sum())
    cells = np.argwhere(is_crossed)
    vertices = low + cell_mm * (cells + total[is_crossed] / cuts[is_crossed][:, None])

    # One quad a grid edge that the surface cuts: the four cells round it.
    quads = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        unit = np.eye(3, dtype=int)
        edges = np.diff(inside.astype(np.int8), axis=axis)
        places = np.argwhere(edges)
        places = places[(places[:, u] > 0) & (places[:, v] > 0) & (places[:, u] < size[u]) & (places[:, v] < size[v])]
        round_it = [places - unit[u] - unit[v], places - unit[v], places, places - unit[u]]
        four = np.stack([index[tuple(cell.T)] for cell in round_it], axis=1)
        leaves = edges[tuple(places.T)] < 0  # from inside to outside along the axis
        quads.append(np.where(leaves[:, None], four, four[:, ::-1]))
    return vertices, np.concatenate(quads)


def _thinned(vertices, quads, triangles, kept):
    """About so many triangles, by collapsing the edges that matter least; kept: of each vertex, how much it resists."""
    mesh = bpy.data.meshes.new("skin")
    mesh.from_pydata(vertices.tolist(), [], quads.tolist())
    thing = bpy.data.objects.new("skin", mesh)
    bpy.context.scene.collection.objects.link(thing)
    modifier = thing.modifiers.new("thin", "DECIMATE")
    modifier.ratio = min(1.0, triangles / (2.0 * len(quads)))
    modifier.use_collapse_triangulate = True
    group = thing.vertex_groups.new(name="thinned")
    for index, share in enumerate(kept):
        group.add([index], 1.0 - share, "REPLACE")
    modifier.vertex_group, modifier.vertex_group_factor = group.name, 4.0
    result = bpy.data.meshes.new_from_object(thing.evaluated_get(bpy.context.evaluated_depsgraph_get()))
    builder = bmesh.new()
    builder.from_mesh(result)
    bmesh.ops.triangulate(builder, faces=builder.faces[:])
    builder.verts.index_update()
    points = np.array([v.co[:] for v in builder.verts])
    faces = np.array([[v.index for v in face.verts] for face in builder.faces])
    builder.free()
    bpy.data.objects.remove(thing)
    return points, faces


class Part:
    """Triangles with what the engine's shader wants of each vertex. tone: brightness of the colour about 0.5;
    smear: how much clay lies on it; open_sky: ambient light that gets there. All 0 to 1."""

    def __init__(self, material, points, faces, normals, tone, smear, open_sky):
        self.material, self.points, self.faces, self.normals = material, points, faces, normals
        self.tone, self.smear, self.open_sky = tone, smear, open_sky


def part(material, solid, low, high, cell_mm, triangles, smear=None, tone=None, around=None, detail=None):
    """around: the solid that shades it, where it is more than itself; smear, tone, detail: functions of points;
    detail: where small triangles stay, 0 to 1."""
    vertices, quads = surface_nets(solid, low, high, cell_mm)
    points, faces = _thinned(vertices, quads, triangles, np.zeros(len(vertices)) if detail is None else detail(vertices))
    for _ in range(2):  # the grid and the thinning moved them off the surface
        normals = solids.gradient(solid, points)
        step = np.clip(solid(points), -cell_mm, cell_mm)
        points = points - step[:, None] * normals
    normals = solids.gradient(solid, points)
    return Part(material, points, faces, normals,
                np.full(len(points), 0.5) if tone is None else np.clip(tone(points), 0.0, 1.0),
                np.zeros(len(points)) if smear is None else np.clip(smear(points), 0.0, 1.0),
                solids.open_sky(around or solid, points, normals))
