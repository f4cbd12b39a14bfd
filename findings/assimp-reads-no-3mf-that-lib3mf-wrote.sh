#!/usr/bin/env bash
# Package: lib3mf-dev, lib3mf1 1.8.1+ds-4; assimp-utils, libassimp5 5.2.5~ds0-1+b1 (Debian 12).
# Behaviour: assimp refuses each 3MF that lib3mf writes ("A node of the scene-graph is nullptr"), and takes the same
# parts from an archive of another writer. lib3mf writes the archive's directory in ZIP64 form however small the file
# is, which the format allows; assimp does not read it. lib3mf also dates every part on day 0 of month 0.
# Expected: two libraries that both know 3MF read each other's files; a date that exists, or the first one.
# Why it matters: a print file that slicers take does not open in programs built on assimp, and a strict reader of dates
# refuses the archive. Write the directory again in its plain form, with the first of January 1980.
# Seen:
#   lib3mf: assimp 3, month 0; the same parts, packed again: assimp 0, month 1
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in lib3mf-dev=1.8.1+ds-4 lib3mf1=1.8.1+ds-4 assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 \
    libdraco7 libminizip1 libpugixml1v5 libpolyclipping22; do
    # A user other than apt's own may own the folder.
    apt-get -qq -o APT::Sandbox::User=root download "$package"
done
for package in *.deb; do dpkg-deb -x "$package" .; done
headers=$(dirname "$(dirname "$(dirname "$(find . -name NMR_DLLInterfaces.h | head -1)")")")
libraries=$(dirname "$(find . -name 'lib3MF.so.1' | head -1)")
export LD_LIBRARY_PATH=$folder/$libraries
cat >write.cpp <<'CODE'
#include <Model/COM/NMR_DLLInterfaces.h>
using namespace NMR;
int main() {
    PLib3MFModel* model;
    PLib3MFModelMeshObject* mesh;
    PLib3MFModelBuildItem* item;
    PLib3MFModelWriter* writer;
    MODELMESHVERTEX corners[]{{{0, 0, 0}}, {{9, 0, 0}}, {{0, 9, 0}}, {{0, 0, 9}}};
    MODELMESHTRIANGLE sides[]{{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}};
    return lib3mf_createmodel(&model) || lib3mf_model_addmeshobject(model, &mesh) ||
           lib3mf_meshobject_setgeometry(mesh, corners, 4, sides, 4) ||
           lib3mf_model_addbuilditem(model, mesh, nullptr, &item) || lib3mf_model_querywriter(model, "3mf", &writer) ||
           lib3mf_writer_writetofileutf8(writer, "own.3mf");
}
CODE
g++ -std=c++17 -w -I"$headers" write.cpp -o write -L"$libraries" -l3MF
./write
cat >pack.py <<'CODE'
import zipfile
with zipfile.ZipFile("own.3mf") as own, zipfile.ZipFile("again.3mf", "w", zipfile.ZIP_DEFLATED) as again:
    for name in own.namelist():
        again.writestr(zipfile.ZipInfo(name), own.read(name))
for file in ("own.3mf", "again.3mf"):
    print(zipfile.ZipFile(file).infolist()[0].date_time[1])
CODE
mapfile -t months < <(python3 pack.py)
codes=()
for file in own again; do
    ./usr/bin/assimp info "$file.3mf" >"$file.txt" 2>&1 && codes+=(0) || codes+=($?)
done
saw="lib3mf: assimp ${codes[0]}, month ${months[0]}; the same parts, packed again: assimp ${codes[1]}, month ${months[1]}"
echo "saw: $saw"
[ "$saw" = "lib3mf: assimp 3, month 0; the same parts, packed again: assimp 0, month 1" ]
