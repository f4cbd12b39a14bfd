#!/usr/bin/env bash
# Package: assimp-utils, libassimp5 5.2.5~ds0-1+b1 (Debian 12).
# Behaviour: a GLB whose corners are 16-bit numbers, by KHR_mesh_quantization, which it lists as required, is imported with
# exit code 0 and no warning: the numbers' bits are taken for floats, so that a part 100 mm wide has no width at all.
# The same part in floats comes in right.
# Expected: the shape, or a refusal: glTF says that a reader that lacks a required extension must not go on.
# Why it matters: gltfpack and other optimisers write this form unasked; a viewer or converter built on this library then
# shows nothing or dust, and a script that trusts the exit code passes it on. Offer the file as it was before.
# Seen:
#   floats: exit code 0, 100 mm wide; 16 bits: exit code 0, 0 mm wide
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7 libminizip1 libpugixml1v5 libpolyclipping22; do
    apt-get -qq -o APT::Sandbox::User=root download "$package"
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >make.py <<'CODE'
import json, struct
corners = ((0, 0, 0), (1000, 0, 0), (0, 1000, 0))  # in tenths of a millimetre
required = ["KHR_mesh_quantization"]
for name, kind, stride, extensions in (("floats", 5126, 12, {}),
                                       ("shorts", 5123, 8, {"extensionsUsed": required, "extensionsRequired": required})):
    packed = b"".join(struct.pack("<3f" if kind == 5126 else "<3H2x", *corner) for corner in corners)
    scene = {
        "asset": {"version": "2.0"}, **extensions, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "scale": [0.0001] * 3}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": kind, "count": 3, "type": "VEC3", "min": [0, 0, 0],
                       "max": [1000, 1000, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": len(packed), "byteStride": stride, "target": 34962}],
        "buffers": [{"byteLength": len(packed)}]}
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    with open(name + ".glb", "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(packed)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(packed), b"BIN\0") + packed)
CODE
python3 make.py
# width NAME: what a conversion to STL gives.
width() {
    local status=0
    LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu usr/bin/assimp export "$1.glb" "$1.stl" >/dev/null 2>&1 || status=$?
    python3 - "$1.stl" "$status" <<'CODE'
import re, sys
across = [float(x) for x in re.findall(r"vertex +(\S+)", open(sys.argv[1]).read())]
print(f"exit code {sys.argv[2]}, {1000 * (max(across) - min(across)):.0f} mm wide")
CODE
}
saw="floats: $(width floats); 16 bits: $(width shorts)"
echo "saw: $saw"
[ "$saw" = "floats: exit code 0, 100 mm wide; 16 bits: exit code 0, 0 mm wide" ]
