#!/usr/bin/env bash
# memory.sh refuses a program that leaks, and no other: memory_test.sh FOLDER
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
source "$(dirname "${BASH_SOURCE[0]}")/waiting.sh"
source "$here/memory.sh"
rm -rf "$1"
mkdir -p "$1"
cd "$1"
: >kiosk.log
kiosk=
trap 'kill $kiosk 2>/dev/null || true' EXIT

# keeps BYTES: runs a program that allocates that many more bytes each tenth of a second.
keeps() {
    local kept=()
    while sleep 0.1; do kept+=("$(printf "%$1s" '')"); done
}
# is_refused BYTES: whether the check refuses that program.
is_refused() {
    local status=0
    keeps "$1" &
    kiosk=$!
    (holds_no_more sleep 1) >said 2>&1 || status=$?
    kill "$kiosk"
    wait "$kiosk" 2>/dev/null || true
    [ "$status" -ne 0 ] && grep -q '^expected the same memory' said
}
is_refused 100000 || { cat said; echo "expected a leak of a megabyte a second to be refused, found it let through"; exit 1; }
if is_refused 0; then cat said; echo "expected a program that keeps nothing to be let through, found it refused"; exit 1; fi
grep -q '^memory of its own' said || { cat said; exit 1; }
