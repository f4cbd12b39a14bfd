#!/usr/bin/env bash
# Package: prusa-slicer 2.5.0+dfsg-4 (Debian 12).
# Behaviour: a 3MF with a title, a designer, a copyright and licence terms that is saved again as 3MF states all of them
# anew: the title is the new file's name, and designer, copyright and licence are there and empty. The mesh is the same.
# Expected: the statements are kept, or left out like other metadata that a program does not know; not a licence of "".
# Why it matters: a museum's pot that somebody arranged for printing and passed on says itself that it has no licence,
# under a name such as "plate 2". Say the licence on the page and in the file's name too; a 3MF carries it once.
# Seen:
#   before: Moon jar | A visitor | A Museum | CC BY 4.0; after: again | "" | "" | ""
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir partial
apt-get -qq -o APT::Sandbox::User=root download prusa-slicer=2.5.0+dfsg-4
apt-get -qq -y -o APT::Sandbox::User=root -o Debug::NoLocking=1 -o Dir::Cache::archives="$PWD" --download-only \
    --no-install-recommends install prusa-slicer=2.5.0+dfsg-4 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >make.py <<'CODE'
import zipfile
core = "http://schemas.microsoft.com/3dmanufacturing"
package = "http://schemas.openxmlformats.org/package/2006"
said = {"Title": "Moon jar", "Designer": "A visitor", "Copyright": "A Museum", "LicenseTerms": "CC BY 4.0"}
corners = ((0, 0, 0), (9, 0, 0), (0, 9, 0), (0, 0, 9))
faces = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
model = f'<model unit="millimeter" xmlns="{core}/core/2015/02">'
model += "".join(f'<metadata name="{name}">{text}</metadata>' for name, text in said.items())
model += '<resources><object id="1" type="model"><mesh><vertices>'
model += "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in corners) + "</vertices><triangles>"
model += "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in faces)
model += '</triangles></mesh></object></resources><build><item objectid="1"/></build></model>'
with zipfile.ZipFile("own.3mf", "w", zipfile.ZIP_DEFLATED) as archive:
    archive.writestr("[Content_Types].xml", f'<Types xmlns="{package}/content-types"><Default Extension="rels" '
                     'ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" '
                     'ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>')
    archive.writestr("_rels/.rels", f'<Relationships xmlns="{package}/relationships"><Relationship Id="model" '
                     f'Type="{core}/2013/01/3dmodel" Target="/3D/3dmodel.model"/></Relationships>')
    archive.writestr("3D/3dmodel.model", model)
CODE
python3 make.py
LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu usr/bin/prusa-slicer --export-3mf own.3mf -o again.3mf >/dev/null 2>&1
cat >look.py <<'CODE'
import sys, zipfile
import xml.etree.ElementTree as xml
model = xml.fromstring(zipfile.ZipFile(sys.argv[1]).read("3D/3dmodel.model"))
said = {part.get("name"): part.text or '""' for part in model if part.tag.endswith("}metadata")}
print(" | ".join(said.get(name, "absent") for name in ("Title", "Designer", "Copyright", "LicenseTerms")))
CODE
saw="before: $(python3 look.py own.3mf); after: $(python3 look.py again.3mf)"
echo "saw: $saw"
[ "$saw" = 'before: Moon jar | A visitor | A Museum | CC BY 4.0; after: again | "" | "" | ""' ]
