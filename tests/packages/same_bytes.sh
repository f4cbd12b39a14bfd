#!/usr/bin/env bash
# Builds of one commit are reproducible: built again from a copy elsewhere, without cached objects, the
# packages have the same bytes. same_bytes.sh PACKAGES FOLDER
set -euo pipefail
packages=$1 folder=$2
rm -rf "$folder"
mkdir -p "$folder"
# The commit, and uncommitted changes.
git clone -q --shared . "$folder/elsewhere"
git diff --binary HEAD >"$folder/changes"
[ ! -s "$folder/changes" ] || git -C "$folder/elsewhere" apply "$folder/changes"
cd "$folder/elsewhere"
export CCACHE_DISABLE=1 TZ=Asia/Seoul
umask 027
cmake --preset release -DONGGI_TESTS=OFF >"$folder/configure.log"
cmake --build build/release --target package >"$folder/build.log" 2>&1 || { tail -40 "$folder/build.log"; exit 1; }
for package in "$packages"/onggi*.deb; do
    cmp "$package" "build/release/packages/$(basename "$package")" || { echo "expected the same bytes"; exit 1; }
    sha256sum "$package" "build/release/packages/$(basename "$package")"
done
rm -rf "$folder/elsewhere"
