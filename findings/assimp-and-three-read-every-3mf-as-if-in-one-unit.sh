#!/usr/bin/env bash
# Package: assimp-utils, libassimp5 5.2.5~ds0-1+b1 (Debian 12); three 0.183.2 with linkedom 0.18.12 (npm); manifold-3d 3.5.4
# (npm) for comparison.
# Behaviour: one cube, stated as 20 millimetres, as 0.02 metres and as 2 centimetres, is three cubes of other sizes for
# assimp and for three.js's 3MFLoader: neither applies the unit, nor warns. manifold-3d gives
# 0.02 m each time.
# Expected: one size: the unit is an attribute of the format's first element, and each object has a real size.
# Why it matters: a viewer or converter built on either shows a pot in metres a thousandth as large as in millimetres,
# beside others. Write millimetres, the unit that a reader without units takes for granted.
# Seen:
#   assimp: 20, 0.02, 2; three: 20, 0.02, 2; manifold-3d: 0.02, 0.02, 0.02
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7 libminizip1 libpugixml1v5 libpolyclipping22; do
    apt-get -qq -o APT::Sandbox::User=root download "$package"
done
for package in *.deb; do dpkg-deb -x "$package" .; done
npm install --prefix . --silent --ignore-scripts --no-audit --no-fund three@0.183.2 linkedom@0.18.12 manifold-3d@3.5.4
cat >make.py <<'CODE'
import zipfile
faces = ((0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
         (1, 3, 7), (1, 7, 5))
core = "http://schemas.microsoft.com/3dmanufacturing"
package = "http://schemas.openxmlformats.org/package/2006"
parts = {
    "[Content_Types].xml": f'<Types xmlns="{package}/content-types"><Default Extension="rels" ContentType='
    '"application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType='
    '"application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>',
    "_rels/.rels": f'<Relationships xmlns="{package}/relationships"><Relationship Id="model" '
    f'Type="{core}/2013/01/3dmodel" Target="/3D/3dmodel.model"/></Relationships>'}
for unit, side in (("millimeter", 20), ("meter", 0.02), ("centimeter", 2)):
    places = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for z in (0, side) for y in (0, side) for x in (0, side))
    corners = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in faces)
    with zipfile.ZipFile(unit + ".3mf", "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in parts.items():
            archive.writestr(name, text)
        archive.writestr("3D/3dmodel.model", f'<model unit="{unit}" xmlns="{core}/core/2015/02"><resources><object id="1" '
                         f'type="model"><mesh><vertices>{places}</vertices><triangles>{corners}</triangles></mesh>'
                         '</object></resources><build><item objectid="1"/></build></model>')
CODE
python3 make.py
cat >read.mjs <<'CODE'
import { readFileSync } from 'node:fs';
import { DOMParser } from 'linkedom';
import { Box3 } from 'three';
import { ThreeMFLoader } from 'three/examples/jsm/loaders/3MFLoader.js';
import { getBounds } from '@gltf-transform/core';
import { fromArrayBuffer } from 'manifold-3d/lib/import-3mf.js';
globalThis.DOMParser = class { parseFromString(text) { return new DOMParser().parseFromString(text, 'text/xml'); } };
const three = [], manifold = [];
const shown = (length) => String(Number(length.toPrecision(4)));
for (const unit of ['millimeter', 'meter', 'centimeter']) {
    const file = new Uint8Array(readFileSync(`${unit}.3mf`)).buffer;
    const box = new Box3().setFromObject(new ThreeMFLoader().parse(file), true);
    three.push(shown(box.max.x - box.min.x));
    const { min, max } = getBounds((await fromArrayBuffer(file)).getRoot().listScenes()[0]);
    manifold.push(shown(max[0] - min[0]));
}
console.log(`three: ${three.join(', ')}; manifold-3d: ${manifold.join(', ')}`);
CODE
cat >size.py <<'CODE'
import re, sys
across = [float(x) for x in re.findall(r"vertex (\S+) ", open(sys.argv[1]).read())]
print(f"{max(across) - min(across):.4g}")
CODE
sizes=()
for unit in millimeter meter centimeter; do
    LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu usr/bin/assimp export "$unit.3mf" "$unit.stl" >/dev/null
    sizes+=("$(sed 's/  */ /g' "$unit.stl" >plain.stl; python3 size.py plain.stl)")
done
saw="assimp: ${sizes[0]}, ${sizes[1]}, ${sizes[2]}; $(node read.mjs)"
echo "saw: $saw"
[ "$saw" = "assimp: 20, 0.02, 2; three: 20, 0.02, 2; manifold-3d: 0.02, 0.02, 0.02" ]
