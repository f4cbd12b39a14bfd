#!/usr/bin/env bash
# where_there_is.sh swiftshader|gpu ONGGI COMMAND...: runs a command if Vulkan has that driver, or any GPU;
# otherwise prints a message and exits with 77.
set -euo pipefail
driver=$1 onggi=$2
shift 2
case $driver in
swiftshader)
    manifest=${VK_DRIVER_FILES}
    [ -e "$manifest" ] || { echo "expected SwiftShader of Debian's chromium, found none in $manifest"; exit 77; }
    ;;
gpu)
    found=$("$onggi" doctor | grep -E ' vulkan +(device|Vulkan)' || true)
    grep -qE '(discrete|integrated|virtual) GPU,.*, chosen$' <<<"$found" || { echo "expected a GPU, found: $found"; exit 77; }
    echo "$found"
    ;;
esac
exec "$@"
