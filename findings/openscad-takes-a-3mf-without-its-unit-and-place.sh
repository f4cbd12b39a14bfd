#!/usr/bin/env bash
# Package: openscad 2021.01-6 with lib3mf1 1.8.1+ds-4 (Debian 12).
# Behaviour: import() of a 3MF takes the corners of each object as they are. The model's unit (here inch) and the build
# item's transform (here twice as wide, and 5 to the side) have no effect, without a warning. lib3mf, by which it reads,
# hands over both.
# Expected: the part as the format says that it is printed: the build places objects, in a stated unit.
# Why it matters: a jar and its lid that the build sets side by side come in one inside the other; a model in inches
# is 25 times too small. For such readers write millimetres, and the transform into the corners.
# Seen:
#   cube of 10 in inches: 10 x 10 x 10; with a transform: from 0 to 10 in x
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir partial
apt-get -qq -y -o APT::Sandbox::User=root -o Debug::NoLocking=1 -o Dir::Cache::archives="$PWD" --download-only \
    --no-install-recommends install openscad=2021.01-6 lib3mf1=1.8.1+ds-4 >/dev/null
for package in *.deb; do [ ! -f "$package" ] || dpkg-deb -x "$package" .; done
cat >make.py <<'CODE'
import sys, zipfile
unit, transform, path = sys.argv[1:]
corners = [(x, y, z) for z in (0, 10) for y in (0, 10) for x in (0, 10)]
faces = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
         (1, 3, 7), (1, 7, 5)]
core = "http://schemas.microsoft.com/3dmanufacturing"
model = f'<model unit="{unit}" xmlns="{core}/core/2015/02"><resources><object id="1" type="model"><mesh><vertices>'
model += "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in corners) + "</vertices><triangles>"
model += "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in faces) + "</triangles></mesh></object>"
model += f'</resources><build><item objectid="1" transform="{transform}"/></build></model>'
package = "http://schemas.openxmlformats.org/package/2006"
with zipfile.ZipFile(path, "w") as archive:
    archive.writestr("[Content_Types].xml", f'<Types xmlns="{package}/content-types"><Default Extension="rels" '
                     'ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" '
                     'ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>')
    archive.writestr("_rels/.rels", f'<Relationships xmlns="{package}/relationships"><Relationship Id="model" '
                     f'Type="{core}/2013/01/3dmodel" Target="/3D/3dmodel.model"/></Relationships>')
    archive.writestr("3D/3dmodel.model", model)
CODE
cat >size.py <<'CODE'
import re, sys
corners = [tuple(map(float, found)) for found in re.findall(r"vertex (\S+) (\S+) (\S+)", open(sys.argv[1]).read())]
low, high = [[f(axis) for axis in zip(*corners)] for f in (min, max)]
print(" x ".join(f"{b - a:g}" for a, b in zip(low, high)) if sys.argv[2] == "size" else f"from {low[0]:g} to {high[0]:g} in x")
CODE
# read UNIT TRANSFORM size|x: what OpenSCAD makes of such a cube.
read_3mf() {
    python3 make.py "$1" "$2" part.3mf
    echo 'import("part.3mf");' >part.scad
    LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu usr/bin/openscad -o part.stl part.scad 2>/dev/null
    python3 size.py part.stl "$3"
}
saw="cube of 10 in inches: $(read_3mf inch '1 0 0 0 1 0 0 0 1 0 0 0' size); \
with a transform: $(read_3mf millimeter '2 0 0 0 1 0 0 0 1 5 0 0' x)"
echo "saw: $saw"
[ "$saw" = "cube of 10 in inches: 10 x 10 x 10; with a transform: from 0 to 10 in x" ]
