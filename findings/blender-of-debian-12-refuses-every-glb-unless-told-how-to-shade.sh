#!/usr/bin/env bash
# Package: blender, blender-data 3.4.1+dfsg-2+b1 with python3-numpy 1:1.24.2-1+deb12u1 (Debian 12).
# Behaviour: the release's Blender imports no GLB with a mesh at the importer's own settings, with normals or without: to
# look at the normals it asks NumPy for a name that the release's NumPy has dropped. With "smooth" or "flat" shading
# chosen in the import, the same files come in.
# Expected: two packages of one stable release, of which one needs the other, work together on the format's common case.
# Why it matters: "it opens in Blender" is said of every exported model; a museum on Debian 12 sees an error for each, and
# the choice that helps looks unrelated.
# Seen:
#   positions alone: refused; with normals: refused; smooth shading chosen: 1 mesh
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir partial
numpy=1:1.24.2-1+deb12u1
apt-get -qq -o APT::Sandbox::User=root download blender=3.4.1+dfsg-2+b1 blender-data=3.4.1+dfsg-2 "python3-numpy=$numpy"
apt-get -qq -y -o APT::Sandbox::User=root -o Debug::NoLocking=1 -o Dir::Cache::archives="$PWD" --download-only \
    --no-install-recommends install blender=3.4.1+dfsg-2+b1 "python3-numpy=$numpy" >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >make.py <<'CODE'
import json, struct
corners = struct.pack("<9f", 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0) + struct.pack("<9f", *(0, 0, 1) * 3)
for name, attributes in (("positions", {"POSITION": 0}), ("normals", {"POSITION": 0, "NORMAL": 1})):
    scene = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": attributes}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0],
                       "max": [0.1, 0.1, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"}][:len(attributes)],
        "bufferViews": [{"buffer": 0, "byteOffset": 36 * i, "byteLength": 36} for i in range(len(attributes))],
        "buffers": [{"byteLength": 72}]}
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    with open(name + ".glb", "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(corners)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(corners), b"BIN\0") + corners)
CODE
python3 make.py
cat >read.py <<'CODE'
import sys
import bpy
name, shading = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
try:
    bpy.ops.import_scene.gltf(filepath=name + ".glb", **({} if shading == "unset" else {"import_shading": shading}))
    print(f"result: {len(bpy.data.meshes)} mesh")
except RuntimeError:
    print("result: refused")
CODE
# read_glb NAME SHADING|unset: what the importer makes of it.
read_glb() {
    LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu BLENDER_SYSTEM_SCRIPTS=$PWD/usr/share/blender/scripts \
        BLENDER_SYSTEM_DATAFILES=$PWD/usr/share/blender/datafiles PYTHONPATH=$PWD/usr/lib/python3/dist-packages \
        usr/bin/blender --background --factory-startup --python read.py -- "$@" 2>/dev/null | sed -n 's/.*result: //p'
}
saw="positions alone: $(read_glb positions unset); with normals: $(read_glb normals unset); \
smooth shading chosen: $(read_glb normals SMOOTH)"
echo "saw: $saw"
[ "$saw" = "positions alone: refused; with normals: refused; smooth shading chosen: 1 mesh" ]
