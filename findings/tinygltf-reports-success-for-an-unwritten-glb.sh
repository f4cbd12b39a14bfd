#!/usr/bin/env bash
# Package: libtinygltf-dev, libtinygltf2d 2.7.0+dfsg-2 (Debian 12).
# Behaviour: WriteGltfSceneToFile returns true for a binary file (GLB) that it could not open, and for one that
# the full disk did not take. For the same unopened path it returns false if the text form is asked for.
# Expected: false in each case, as for the text form; the return value is the only report of an error.
# Why it matters: an exporter that trusts it tells a visitor that a pot is saved, and no pot is there. Write to a
# stream in memory and check the file's own errors instead.
# Seen:
#   no folder: text 0, binary 1; full disk: binary 1
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=2.7.0+dfsg-2
# A user other than apt's own may own the folder.
apt-get -qq -o APT::Sandbox::User=root download "libtinygltf-dev=$version" "libtinygltf2d=$version"
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >write.cpp <<'CODE'
#include <cstdio>
#include <tiny_gltf.h>
int main() {
    tinygltf::Model model;
    model.asset.version = "2.0";
    tinygltf::TinyGLTF gltf;
    const auto write = [&](const char* path, bool binary) {
        return static_cast<int>(gltf.WriteGltfSceneToFile(&model, path, true, true, true, binary));
    };
    std::printf("no folder: text %d, binary %d; ", write("absent/pot.gltf", false), write("absent/pot.glb", true));
    std::printf("full disk: binary %d\n", write("/dev/full", true));
}
CODE
libraries=$(dirname "$(find . -name 'libtinygltf.so*' | head -1)")
g++ -std=c++17 -w -Iusr/include write.cpp -o write -L"$libraries" -ltinygltf
saw=$(LD_LIBRARY_PATH=$libraries ./write)
echo "saw: $saw"
[ "$saw" = "no folder: text 0, binary 1; full disk: binary 1" ]
