"""From renderings to plates: denoise, depth of field, tone curve, file. Needs numpy and PIL, not Blender.

By hand, without rendering again:  /usr/bin/python3 -m maker.develop WORK_FOLDER OUT_FOLDER [camera...]
"""
import math
import pathlib
import sys

import numpy as np
from PIL import Image

from . import cameras_file, denoise, exr, lens, tone


def _passes(work, name):
    files = sorted(p for p in pathlib.Path(work).glob(name + ".[0-9]*.exr") if ".part" not in p.name)
    if not files:
        raise ValueError("%s: expected renderings %s.0.exr and so on, found none" % (work, name))
    return [exr.read(path) for path in files]


def light_of(work, name, spec):
    """(key-lit, ambient) plates of one camera: linear light, height x width x 3."""
    passes = _passes(work, name)
    middle = lambda layer, letters: np.mean([exr.stack(p, layer, letters) for p in passes], 0)
    albedo, normal = middle("Denoising Albedo", "RGB"), middle("Denoising Normal", "XYZ")
    depth = np.minimum(np.median([exr.stack(p, "Depth", "Z")[..., 0] for p in passes], 0), 20.0)
    groups = [denoise.denoise(np.stack([exr.stack(p, "Combined_" + group, "RGB") for p in passes]), albedo, normal, depth)
              for group in ("key", "rest")]
    focus = math.dist(spec["eye_mm"], (0.0, 60.0, 0.0)) * 1e-3
    ambient = groups[1]
    return lens.blur([groups[0] + ambient, ambient], depth, focus)


def middle_of(light, size):
    """The middle of a plate at another size: what a camera in the same place sees that shows as much from top
    to bottom and less to the sides. Lanczos, in linear light."""
    width, height = size
    used = light.shape[0] * width / height
    left = (light.shape[1] - used) / 2
    box = (left, 0, left + used, light.shape[0])
    planes = [Image.fromarray(np.ascontiguousarray(light[..., k])).resize((width, height), Image.LANCZOS, box)
              for k in range(3)]
    return np.maximum(np.stack([np.asarray(plane) for plane in planes], -1), 0.0)


def develop(work, out, names, suffix=".jpg"):
    pathlib.Path(out).mkdir(parents=True, exist_ok=True)
    for name in names:
        spec = cameras_file.load()[name]
        wider = spec.get("middle_of")
        lit, ambient = light_of(work, wider or name, spec)
        if wider:
            lit, ambient = middle_of(lit, spec["size"]), middle_of(ambient, spec["size"])
        tone.write(pathlib.Path(out) / (name + "_key" + suffix), lit)
        tone.write(pathlib.Path(out) / (name + "_ambient" + suffix), ambient)
        print("developed", name, flush=True)


if __name__ == "__main__":
    develop(sys.argv[1], sys.argv[2], sys.argv[3:] or list(cameras_file.load()))
