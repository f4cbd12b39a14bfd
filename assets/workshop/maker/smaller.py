"""Plates from those of a larger camera (`NAME_x2`): at their own size the denoiser leaves steps at the rims of
wheel and pan, which many pixels of a larger plate make smooth. Needs numpy and PIL, not Blender.

  /usr/bin/python3 -m maker.smaller PLATES_FOLDER [camera...]

Without cameras: all for which the larger plates are there.
"""
import pathlib
import sys

import numpy as np
from PIL import Image

from . import cameras_file, develop, tone


def smaller(folder, names):
    """Rewrites the plates of these cameras; returns the names of those that it did."""
    folder, cameras, done = pathlib.Path(folder), cameras_file.load(), []
    for name in names:
        spec = cameras[name]
        larger = spec.get("middle_of", name) + "_x2"
        for plate in ("_key.jpg", "_ambient.jpg"):
            if not (folder / (larger + plate)).is_file():
                break
            with Image.open(folder / (larger + plate)) as image:
                seen = tone.from_bytes(np.asarray(image))
            tone.save(folder / (name + plate), tone.dithered(tone.transfer(develop.middle_of(seen, spec["size"]))))
        else:
            done.append(name)
            print("made smaller", name, flush=True)
    return done


if __name__ == "__main__":
    smaller(sys.argv[1], sys.argv[2:] or [name for name, spec in cameras_file.load().items() if "larger_than" not in spec])
