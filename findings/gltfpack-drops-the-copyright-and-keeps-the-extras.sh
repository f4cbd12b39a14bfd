#!/usr/bin/env bash
# Package: gltfpack 1.3.0 (npm), with its options for keeping: -kn (names), -km (materials), -ke (extras).
# Behaviour: a GLB's asset.copyright is not in the output, whatever is to be kept; nor is the rights statement in
# KHR_xmp_json_ld. Of the same object the extras are there, even without -ke.
# Expected: the one field that glTF's core has for rights stays where free-form extras stay; at least with an option.
# Why it matters: a museum's model under an attribution licence loses its credit in the web shop's or viewer's build step.
# Write the credit into the asset's extras as well.
# Seen:
#   before: copyright yes, rights yes, extras yes; after: copyright no, rights no, extras yes
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --prefix . --silent --ignore-scripts --no-audit --no-fund gltfpack@1.3.0
cat >make.py <<'CODE'
import json, struct
corners = struct.pack("<9f", 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0)
xmp = "KHR_xmp_json_ld"
scene = {
    "asset": {"version": "2.0", "copyright": "CC BY 4.0 A Museum", "extras": {"credit": "A Museum"},
              "extensions": {xmp: {"packet": 0}}},
    "extensionsUsed": [xmp],
    "extensions": {xmp: {"packets": [{"@context": {"dc": "http://purl.org/dc/elements/1.1/"}, "@id": "",
                                      "dc:rights": "CC BY 4.0"}]}},
    "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0],
                   "max": [0.1, 0.1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": len(corners)}], "buffers": [{"byteLength": len(corners)}]}
text = json.dumps(scene).encode()
text += b" " * (-len(text) % 4)
with open("pot.glb", "wb") as file:
    file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(corners)))
    file.write(struct.pack("<I4s", len(text), b"JSON") + text)
    file.write(struct.pack("<I4s", len(corners), b"BIN\0") + corners)
CODE
cat >look.py <<'CODE'
import json, struct, sys
data = open(sys.argv[1], "rb").read()
scene = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])
has = {"copyright": "copyright" in scene["asset"], "rights": "dc:rights" in json.dumps(scene),
       "extras": "credit" in scene["asset"].get("extras", {})}
print(", ".join(f"{name} {'yes' if is_there else 'no'}" for name, is_there in has.items()))
CODE
python3 make.py
node node_modules/gltfpack/cli.js -kn -km -ke -i pot.glb -o packed.glb
saw="before: $(python3 look.py pot.glb); after: $(python3 look.py packed.glb)"
echo "saw: $saw"
[ "$saw" = "before: copyright yes, rights yes, extras yes; after: copyright no, rights no, extras yes" ]
