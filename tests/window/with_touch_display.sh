#!/usr/bin/env bash
# with_touch_display.sh FOLDER COMMAND...: runs a command with a display that has a touch screen and a pen.
# TOUCH_SCREEN and PEN are their sockets; FOLDER takes what the server says.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
folder=$1
shift
rm -rf "$folder"
mkdir -p "$folder"
server=
trap 'kill $server 2>/dev/null || true' EXIT
open_touch_display "$folder" 1280x720
cd "$folder"
TOUCH_SCREEN=touch-screen PEN=pen "$@"
