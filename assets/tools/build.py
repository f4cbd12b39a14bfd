"""Builds the hand's tools. Run by Blender 3.4:

  blender -b --factory-startup -P assets/tools/build.py -- [--only NAME ...] [--out FOLDER] [--preview FOLDER]

README.md says more.
"""
import argparse
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))

import bpy  # noqa: E402

from maker import glb, hand, preview, tools  # noqa: E402

MAKERS = {
    "hand_outer": lambda: hand.build(hand.OUTER),
    "hand_inner": lambda: hand.build(hand.INNER),
    "rib": tools.rib,
    "sponge": tools.sponge,
    "trimmer": tools.trimmer,
    "wire": tools.wire,
    "stick": tools.stick,
}


def options():
    words = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    parser = argparse.ArgumentParser(prog="build.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", choices=sorted(MAKERS), action="append", help="may be repeated")
    parser.add_argument("--out", default=str(HERE), help="where the GLB files go")
    parser.add_argument("--preview", metavar="FOLDER", help="also a picture of each, at the wall of a stand-in pot")
    return parser.parse_args(words)


def main():
    chosen = options()
    out = pathlib.Path(chosen.out)
    out.mkdir(parents=True, exist_ok=True)
    for name in chosen.only or MAKERS:
        bpy.ops.wm.read_factory_settings(use_empty=True)
        parts = MAKERS[name]()
        glb.write(parts, out / (name + ".glb"))
        print("%s: %d triangles" % (name, sum(len(part.faces) for part in parts)))
        if chosen.preview:
            preview.picture(parts, pathlib.Path(chosen.preview) / (name + ".png"))


main()
