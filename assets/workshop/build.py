"""Builds the potter's workshop and everything the program needs of it. Run by Blender 3.4, see README.md:

  blender -b --factory-startup -P assets/workshop/build.py -- [options]
"""
import argparse
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import bpy  # noqa: E402

from maker import building, cameras, cameras_file, develop, furniture, lights, paint, plates, pots, shapes, tools, wheel  # noqa: E402


def options():
    words = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    parser = argparse.ArgumentParser(prog="build.py", description=__doc__)
    parser.add_argument("--camera", action="append", help="only this camera of cameras.json (may be repeated)")
    parser.add_argument("--work", default="/tmp/onggi-workshop", help="folder for the unfinished renderings")
    parser.add_argument("--out", default=str(HERE / "plates"), help="folder for the plates")
    parser.add_argument("--samples", type=int, default=12, help="samples a pixel in each pass")
    parser.add_argument("--passes", type=int, default=4)
    parser.add_argument("--scale", type=float, default=1.0, help="of the picture's size; 0.5 for a preview")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--stand-in", action="store_true", help="preview only: put a pot on the wheel")
    return parser.parse_args(words)


def build_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    colours = paint.Paint()
    for part in (building, furniture, wheel, pots, tools):
        part.build(colours)
    return colours


def main():
    chosen = options()
    colours = build_scene()
    lights.build(colours)
    if chosen.stand_in:
        pots.pot("stand-in", "jar", 0.21, colours["wet clay"], (0, 0, 0))
    pathlib.Path(chosen.work).mkdir(parents=True, exist_ok=True)
    print("objects %d, triangles %d" % (len(bpy.data.objects), sum(
        len(p.vertices) - 2 for o in bpy.data.objects if o.type == "MESH" for p in o.data.polygons)))
    for name, spec in cameras_file.load().items():
        if chosen.camera and name not in chosen.camera:
            continue
        plates.set_up(chosen.samples, chosen.threads, spec["size"], chosen.scale)
        cameras.place(spec)
        plates.render(name, chosen.work, chosen.passes)
        develop.develop(chosen.work, chosen.out, [name])


main()
