#!/usr/bin/env bash
# with_display.sh FOLDER COMMAND...: runs a command with a display of its own; FOLDER takes what the server says.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
folder=$1
shift
rm -rf "$folder"
mkdir -p "$folder"
server=
trap 'kill $server 2>/dev/null || true' EXIT
open_display "$folder" 1280x720
"$@"
