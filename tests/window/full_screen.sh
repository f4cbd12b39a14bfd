#!/usr/bin/env bash
# Tests that full screen covers the display: full_screen.sh ONGGI FOLDER. Servers: with RandR; without it, where GLFW
# places the window off the display (findings/glfw-full-screen-is-off-the-display-without-randr.sh); without shared
# memory, where the driver sends the pictures. F11 must cover the display and restore the window, twice;
# `--full-screen` must cover it from the start, with a picture.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
source "$(dirname "${BASH_SOURCE[0]}")/waiting.sh"
onggi=$1
work_in "$2"

# geometry: the window's place and size, as "X,Y WIDTHxHEIGHT".
geometry() {
    local X Y WIDTH HEIGHT
    eval "$(xdotool search --name '^Onggi' getwindowgeometry --shell 2>/dev/null)"
    echo "$X,$Y ${WIDTH}x$HEIGHT"
}
is_at() { [ "$(geometry)" = "$1" ]; }
# expect GEOMETRY WHAT: waits until the window is there.
expect() {
    within 600 "$2" is_at "$1" || fail "$server_kind: expected $2 at $1, found $(geometry)"
}
# Whether the lower half of the display is drawn: most of its bytes are not zero.
is_drawn() {
    local half=$((960 * 540 * 2))
    [ "$(tail -c "$half" "$server_kind/Xvfb_screen0" | tr -d '\0' | wc -c)" -gt $((half / 2)) ]
}
# start_kiosk OPTION...
start_kiosk() {
    "${as_usual[@]}" "$onggi" kiosk "$@" --device mouse --volume 0 --gallery gallery >>kiosk.log 2>&1 &
    kiosk=$!
    wait_for "window" xdotool search --name '^Onggi - attract$'
}
end_kiosk() {
    kill "$kiosk"
    wait "$kiosk" || fail "$server_kind: expected exit code 0, found $?"
}

covered="0,0 960x540"
# covers SERVER-KIND [SERVER-OPTION...]
covers() {
    server_kind=$1
    mkdir "$1"
    open_display "$1" 960x540 "${@:2}"
    start_kiosk --size 640x360
    local window
    window=$(geometry)
    for _ in 1 2; do
        xdotool key F11
        expect "$covered" "the full screen"
        xdotool key F11
        expect "$window" "the window"
    done
    end_kiosk
    start_kiosk --full-screen
    expect "$covered" "the full screen"
    within 600 "a picture" is_drawn || fail "$server_kind: expected a picture, found a black display"
    end_kiosk
    kill "$server"
    wait "$server" 2>/dev/null || true
}
listen_for_life
covers with_randr
covers without_randr -extension RANDR
covers without_shared_memory -extension MIT-SHM
echo "a full screen covers the display"
