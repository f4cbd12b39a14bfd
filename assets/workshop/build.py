"""Builds the potter's workshop and everything the program needs of it. Run by Blender 3.4:

  blender -b --factory-startup -P assets/workshop/build.py -- [options]

Without options: light.json, room.glb, and the plates of every camera in cameras.json. README.md says more.
"""
import argparse
import pathlib
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))

import bpy  # noqa: E402

from maker import (building, cameras, cameras_file, develop, furniture, lights, paint, plates, pots, probe,  # noqa: E402
                   room_glb, shapes, tools, wheel)

ROOM_FINENESS = 0.36  # of the round things in room.glb


def options():
    words = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    parser = argparse.ArgumentParser(prog="build.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", choices=("plates", "light", "room"), action="append", help="may be repeated")
    parser.add_argument("--camera", action="append", help="plates of this camera only, which may be a larger one; may be repeated")
    parser.add_argument("--room", metavar="GLB", help="a room of your own instead of ours (metres, +Y up)")
    parser.add_argument("--out", default=str(HERE), help="where plates/, light.json and room.glb go")
    parser.add_argument("--work", default=str(pathlib.Path(tempfile.gettempdir()) / "onggi-workshop"),
                        help="folder for the unfinished renderings; "
                        "passes found in it are not rendered again: empty it after a change")
    parser.add_argument("--samples", type=int, default=10, help="a pixel in each pass")
    parser.add_argument("--passes", type=int, default=3, help="two or more, for the denoiser")
    parser.add_argument("--scale", type=float, default=1.0, help="of the picture's size; 0.5 for a preview")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--stand-in", action="store_true", help="preview: put a pot on the wheel")
    chosen = parser.parse_args(words)
    unknown = sorted(set(chosen.camera or []) - set(cameras_file.load()))
    if unknown:
        parser.error("--camera: expected one of %s, found %s" % (", ".join(cameras_file.load()), ", ".join(unknown)))
    if chosen.room and not pathlib.Path(chosen.room).is_file():
        parser.error("--room: expected a GLB file, found none at %s" % chosen.room)
    return chosen


def build_scene(chosen, fineness):
    """Returns (paint, the key light's object)."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    shapes.fineness = fineness
    colours = paint.Paint()
    if chosen.room:
        parts = [] if room_glb.load(chosen.room) else [wheel]
    else:
        parts = [building, furniture, wheel, pots, tools]
    for part in parts:
        part.build(colours)
    if chosen.stand_in:
        pots.pot("stand-in", "jar", 0.21, colours["wet clay"], (0, 0, 0))
    return colours, lights.build(colours)


def main():
    chosen = options()
    wanted = set(chosen.only or ("light", "room", "plates"))
    out, work = pathlib.Path(chosen.out), pathlib.Path(chosen.work)
    out.mkdir(parents=True, exist_ok=True)
    work.mkdir(parents=True, exist_ok=True)
    if "light" in wanted:
        colours, key = build_scene(chosen, 1.0)
        probe.measure(colours, key, work, out / "light.json", chosen.threads)
    if "room" in wanted and not chosen.room:
        colours, _ = build_scene(chosen, ROOM_FINENESS)
        room_glb.export(colours, out / "room.glb")
    chosen_cameras = [(name, spec) for name, spec in cameras_file.load().items()
                      if (name in chosen.camera if chosen.camera else "larger_than" not in spec)]
    if "plates" in wanted:
        build_scene(chosen, 1.0)
        for name, spec in chosen_cameras:
            source = spec.get("middle_of", name)
            plates.set_up(chosen.samples, chosen.threads, cameras_file.load()[source]["size"], chosen.scale)
            cameras.place(spec)
            plates.render(source, work, chosen.passes)
            develop.develop(work, out / "plates", [name])


main()
