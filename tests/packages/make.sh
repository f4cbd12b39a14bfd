#!/usr/bin/env bash
# Makes both packages from a build: make.sh BUILD INTO
set -euo pipefail
rm -f "$2"/onggi*.deb
cpack --config "$1/CPackConfig.cmake" -B "$2"
rm -rf "$2/_CPack_Packages"
ls -l "$2"
