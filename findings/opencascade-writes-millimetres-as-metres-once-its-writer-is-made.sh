#!/usr/bin/env bash
# Package: libocct-data-exchange-7.6 7.6.3+dfsg1-7 and its neighbours (Debian 12).
# Behaviour: the unit of a STEP file is a setting of the whole process, write.step.unit. Set to metres before the writer is
# made, a box of 10 mm is written as 0.01. Set after that, and still before anything is handed over or written, the
# file says metres and the numbers stay: 10.
# Expected: one moment at which the setting counts, for the unit's name and for the numbers.
# Why it matters: a cup becomes ten metres wide in the reader, which is right by the file; every call succeeded. Set the
# units before the first writer is made, and read a file back once.
# Seen:
#   set before: METRE, read back as 10 mm; set after: METRE, read back as 10000 mm
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download libocct-foundation-7.6=7.6.3+dfsg1-7 libocct-modeling-data-7.6=7.6.3+dfsg1-7 \
    libocct-modeling-algorithms-7.6=7.6.3+dfsg1-7 libocct-data-exchange-7.6=7.6.3+dfsg1-7 libocct-foundation-dev=7.6.3+dfsg1-7 \
    libocct-modeling-data-dev=7.6.3+dfsg1-7 libocct-modeling-algorithms-dev=7.6.3+dfsg1-7 \
    libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-visualization-dev=7.6.3+dfsg1-7 libtbb12=2021.8.0-2+deb12u1 libtbbmalloc2=2021.8.0-2+deb12u1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >box.cpp <<'CODE'
// box before|after: sets metres before or after the writer is made; prints the width that is read back.
#include <BRepBndLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Bnd_Box.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <cstdio>
#include <cstring>
int main(int, char** words) {
    STEPControl_Controller::Init();  // knows the setting
    const bool before = std::strcmp(words[1], "before") == 0;
    if (before && !Interface_Static::SetCVal("write.step.unit", "M")) return 2;
    STEPControl_Writer writer;
    if (!before && !Interface_Static::SetCVal("write.step.unit", "M")) return 2;
    if (writer.Transfer(BRepPrimAPI_MakeBox(10., 20., 30.).Shape(), STEPControl_AsIs) != IFSelect_RetDone) return 2;
    if (writer.Write("box.step") != IFSelect_RetDone) return 2;
    STEPControl_Reader reader;
    if (reader.ReadFile("box.step") != IFSelect_RetDone) return 2;
    reader.TransferRoots();
    Bnd_Box box;
    BRepBndLib::Add(reader.OneShape(), box);
    double least[3], most[3];
    box.Get(least[0], least[1], least[2], most[0], most[1], most[2]);
    std::fprintf(stderr, "%.0f mm", most[0] - least[0]);
}
CODE
libs=()
for name in TKSTEP TKXSBase TKPrim TKTopAlgo TKBRep TKMath TKernel; do libs+=("$libraries/lib$name.so.7"); done
g++ -w -Iusr/include/opencascade box.cpp -o box "${libs[@]}" -Wl,--unresolved-symbols=ignore-in-shared-libs
# box WHEN: the unit that the file names, and the width that is read back.
box() {
    local width
    width=$(LD_LIBRARY_PATH=$libraries ./box "$1" 2>&1 >/dev/null)
    printf '%s, read back as %s' "$(grep -ao 'LENGTH_UNIT.*SI_UNIT([^)]*' box.step | grep -o '[A-Z]*\.$' | tr -d .)" "$width"
}
saw="set before: $(box before); set after: $(box after)"
echo "saw: $saw"
[ "$saw" = "set before: METRE, read back as 10 mm; set after: METRE, read back as 10000 mm" ]
