#!/usr/bin/env bash
# What `cmake --install` lays down: the program, and the udev rules where udev looks for them. install.sh BUILD FOLDER
set -euo pipefail
build=$1 folder=$2
rm -rf "$folder"
cmake --install "$build" --prefix "$folder/usr" >/dev/null
"$folder/usr/bin/onggi" --version
cmp assets/udev/70-onggi.rules "$folder/usr/lib/udev/rules.d/70-onggi.rules"
