#!/usr/bin/env bash
# with_display.sh [--touch] FOLDER COMMAND...: runs a command with a display of its own; FOLDER takes what the server
# says. --touch: the display has a touch screen and a pen, whose sockets TOUCH_SCREEN and PEN name from FOLDER, where the
# command then runs.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
touch=
if [ "$1" = --touch ]; then touch=1; shift; fi
folder=$1
shift
rm -rf "$folder"
mkdir -p "$folder"
server=
trap 'kill $server 2>/dev/null || true' EXIT
if [ -n "$touch" ]; then
    open_touch_display "$folder" 1280x720
    cd "$folder"
    export TOUCH_SCREEN=touch-screen PEN=pen
else
    open_display "$folder" 1280x720
fi
"$@"
