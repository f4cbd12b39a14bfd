#!/usr/bin/env bash
# Package: lib3mf-dev, lib3mf1 1.8.1+ds-4 (Debian 12).
# Behaviour: of one title, "Salt & pepper", lib3mf writes the object's name escaped and the model's metadata as it is: the
# part is then no well-formed XML, and no call reports it. Its own reader takes that file back without an error, so a
# round trip passes. A caller who escapes both himself gets "&amp;amp;" in the name.
# Expected: a library that writes XML escapes all texts, or none; and its reader refuses what XML forbids.
# Why it matters: a visitor's pot named with an ampersand prints from no slicer that has a real XML parser. Escape
# metadata only.
# Seen:
#   name &amp;, metadata &; own reader: 0; XML: not well-formed
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download lib3mf-dev=1.8.1+ds-4 lib3mf1=1.8.1+ds-4
for package in *.deb; do dpkg-deb -x "$package" .; done
headers=$(dirname "$(dirname "$(dirname "$(find . -name NMR_DLLInterfaces.h | head -1)")")")
libraries=$(dirname "$(find . -name 'lib3MF.so.1' | head -1)")
cat >title.cpp <<'CODE'
#include <Model/COM/NMR_DLLInterfaces.h>
#include <cstdio>
using namespace NMR;
int main() {
    const char* title = "Salt & pepper";
    PLib3MFModel* model;
    PLib3MFModelMeshObject* mesh;
    PLib3MFModelBuildItem* item;
    PLib3MFModelWriter* writer;
    MODELMESHVERTEX corners[]{{{0, 0, 0}}, {{9, 0, 0}}, {{0, 9, 0}}, {{0, 0, 9}}};
    MODELMESHTRIANGLE sides[]{{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}};
    if (lib3mf_createmodel(&model) || lib3mf_model_addmetadatautf8(model, "Title", title) ||
        lib3mf_model_addmeshobject(model, &mesh) || lib3mf_object_setnameutf8(mesh, title) ||
        lib3mf_meshobject_setgeometry(mesh, corners, 4, sides, 4) ||
        lib3mf_model_addbuilditem(model, mesh, nullptr, &item) || lib3mf_model_querywriter(model, "3mf", &writer) ||
        lib3mf_writer_writetofileutf8(writer, "title.3mf"))
        return 2;
    PLib3MFModel* again;
    PLib3MFModelReader* reader;
    if (lib3mf_createmodel(&again) || lib3mf_model_queryreader(again, "3mf", &reader)) return 3;
    std::printf("%d", lib3mf_reader_readfromfileutf8(reader, "title.3mf"));
}
CODE
g++ -std=c++17 -w -I"$headers" title.cpp -o title -L"$libraries" -l3MF
own=$(LD_LIBRARY_PATH=$libraries ./title)
cat >look.py <<'CODE'
import re, xml.parsers.expat, zipfile
text = zipfile.ZipFile("title.3mf").read("3D/3dmodel.model").decode()
name = re.search(r'<object [^>]*name="Salt (.*?) pepper"', text)[1]
metadata = re.search(r">Salt (.*?) pepper</metadata>", text)[1]
try:
    xml.parsers.expat.ParserCreate().Parse(text, True)
    kind = "well-formed"
except xml.parsers.expat.ExpatError:
    kind = "not well-formed"
print(f"name {name}, metadata {metadata}; XML: {kind}")
CODE
looked=$(python3 look.py)
saw="${looked%; XML*}; own reader: $own; XML${looked#*XML}"
echo "saw: $saw"
[ "$saw" = "name &amp;, metadata &; own reader: 0; XML: not well-formed" ]
