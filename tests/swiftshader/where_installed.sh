#!/usr/bin/env bash
# where_installed.sh MANIFEST COMMAND...: runs a command where that driver's manifest is there; else says so, and 77.
set -euo pipefail
manifest=$1
shift
if [ ! -e "$manifest" ]; then
    echo "expected SwiftShader of Debian's chromium, found none in $manifest"
    exit 77
fi
exec "$@"
