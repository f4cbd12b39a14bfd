#!/usr/bin/env bash
# Package: libocct-modeling-algorithms-7.6 7.6.3+dfsg1-7 and its neighbours (Debian 12).
# Behaviour: BRepBndLib::Add gives the box of a solid. Once the solid has been meshed, the box is that of the triangles,
# widened on every side by the mesh's allowed deviation, also where the two agree: the flat ends of a cylinder. A finer
# mesh that is asked for is made; a coarser one is not, the solid keeps the finer.
# Expected: the solid is what it was; a mesh lies inside a cylinder, so at most its box is a little narrower.
# Why it matters: a preview changes the height that a label states: 300 mm becomes 300.7. Measure before the mesh is made, or
# with useTriangulation off.
# Seen:
#   height 300.00; meshed: 300.73, exact 300.00; meshed finer: 300.10; asked for the coarser again: 300.10
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
cat >height.cpp <<'CODE'
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Bnd_Box.hxx>
#include <cstdio>
static double height_mm(const TopoDS_Shape& solid, bool by_triangles = true) {
    Bnd_Box box;
    BRepBndLib::Add(solid, box, by_triangles);
    double least[3], most[3];
    box.Get(least[0], least[1], least[2], most[0], most[1], most[2]);
    return most[2] - least[2];
}
int main() {
    const TopoDS_Shape solid = BRepPrimAPI_MakeCylinder(50., 300.).Shape();
    std::printf("height %.2f", height_mm(solid));
    BRepMesh_IncrementalMesh(solid, 1.);
    std::printf("; meshed: %.2f, exact %.2f", height_mm(solid), height_mm(solid, false));
    BRepMesh_IncrementalMesh(solid, 0.1);
    std::printf("; meshed finer: %.2f", height_mm(solid));
    BRepMesh_IncrementalMesh(solid, 1.);
    std::printf("; asked for the coarser again: %.2f", height_mm(solid));
}
CODE
libs=()
for name in TKMesh TKPrim TKTopAlgo TKBRep TKMath TKernel; do libs+=("$libraries/lib$name.so.7"); done
g++ -w -Iusr/include/opencascade height.cpp -o height "${libs[@]}" -Wl,--unresolved-symbols=ignore-in-shared-libs
saw=$(LD_LIBRARY_PATH=$libraries ./height)
echo "saw: $saw"
[ "$saw" = "height 300.00; meshed: 300.73, exact 300.00; meshed finer: 300.10; asked for the coarser again: 300.10" ]
