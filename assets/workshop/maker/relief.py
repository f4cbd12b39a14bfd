"""How far everything on a plate is from its camera, as a coarse grid: with it the engine can move the camera a little
and bend the plate along.

plates/NAME_relief.png, 8-bit RGB, a texel for each corner of a grid that covers the plate: 65535 * 200 mm / depth,
depth along the view, red the high byte and green the low one.
"""
import pathlib

import bpy
import numpy as np
from PIL import Image

from . import cameras, exr, plates

CELL_PX = 16       # of the plate
FINER = 4          # depth is rendered at a quarter of the plate's size
NEAREST_M = 0.2
FARTHEST_M = 12.0


def _depth(name, spec, work, threads):
    """Depth in metres at a quarter of the plate's size."""
    width, height = spec["size"]
    plates.set_up(1, threads, (width // FINER, height // FINER))
    scene = bpy.context.scene
    scene.cycles.max_bounces = 0
    cameras.place(spec)
    path = pathlib.Path(work) / (name + ".depth.exr")
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    return exr.stack(exr.read(path), "Depth", "Z")[..., 0]


def _corners(depth, columns, rows):
    """At each corner of the grid the nearest thing within half a cell: where something near ends, the stretch
    between near and far then lies on what is far, and the near thing keeps its outline."""
    height, width = depth.shape
    reach = CELL_PX // FINER // 2 + 1
    grid = np.empty((rows, columns))
    for row in range(rows):
        for column in range(columns):
            x, y = column * width // (columns - 1), row * height // (rows - 1)
            grid[row, column] = depth[max(y - reach, 0):min(y + reach, height), max(x - reach, 0):min(x + reach, width)].min()
    return grid


def make(name, spec, work, out, threads):
    columns, rows = (-(-side // CELL_PX) + 1 for side in spec["size"])
    depth = np.clip(_corners(_depth(name, spec, work, threads), columns, rows), NEAREST_M, FARTHEST_M)
    value = np.round(65535.0 * NEAREST_M / depth).astype(np.uint32)
    pathlib.Path(out).mkdir(parents=True, exist_ok=True)
    texels = np.stack([value >> 8, value & 255, np.zeros_like(value)], -1).astype(np.uint8)
    Image.fromarray(texels).save(pathlib.Path(out) / (name + "_relief.png"), optimize=True)
    print("relief", name, flush=True)
