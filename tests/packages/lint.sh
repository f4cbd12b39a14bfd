#!/usr/bin/env bash
# Debian's own reader of packages has no error and no warning that is not answered. lint.sh PACKAGES FOLDER
set -euo pipefail
packages=$1 folder=$2
for tool in lintian; do
    command -v "$tool" >/dev/null || { echo "SKIPPED: no $tool"; exit 77; }
done
rm -rf "$folder"
mkdir -p "$folder"
lintian --fail-on error,warning "$packages"/onggi*.deb
# It would see one: a package whose program may be written by everybody, and which has lost its copyright.
dpkg-deb -R "$packages"/onggi_*.deb "$folder/wrong"
chmod 777 "$folder/wrong/usr/bin/onggi"
rm "$folder/wrong/usr/share/doc/onggi/copyright"
dpkg-deb --root-owner-group -b "$folder/wrong" "$folder/wrong.deb" >/dev/null
if lintian --fail-on error,warning "$folder/wrong.deb" >"$folder/wrong.txt" 2>&1; then
    echo "expected lintian to see what is wrong with $folder/wrong.deb"
    exit 1
fi
grep -q no-copyright-file "$folder/wrong.txt"
echo "lintian: no error, no warning"
