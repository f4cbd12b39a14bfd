#!/usr/bin/env bash
# A visitor at the window: keeps the fresh lump, presses the tool into the turning clay with the mouse, keeps what came
# of it and its picture, leaves. It brings a display of its own: throw_by_mouse.sh ONGGI FOLDER
set -euo pipefail
onggi=$1
rm -rf "$2"
mkdir -p "$2"
cd "$2"

# The server itself picks a free number and tells it once it listens; guessing one would race with other tests. Without
# -noreset it starts anew whenever its last client leaves, and turns away who comes just then.
Xvfb -displayfd 1 -noreset -screen 0 1280x720x24 -nolisten tcp >display 2>display.log &
server=$!
kiosk=
trap 'kill $kiosk "$server" 2>/dev/null || true' EXIT
for _ in $(seq 300); do
    [ -s display ] && break
    sleep 0.1
done
[ -s display ] || { echo "no display after half a minute"; cat display.log; exit 1; }
DISPLAY=:$(cat display)
export DISPLAY
unset WAYLAND_DISPLAY

"$onggi" kiosk >kiosk.log 2>&1 &
kiosk=$!
fail() { printf '%s\n' "$*"; cat kiosk.log; exit 1; }

# wait_for WHAT COMMAND...: up to a minute; a software driver under a sanitizer takes ten seconds to its first frame.
wait_for() {
    local what=$1
    shift
    for _ in $(seq 600); do
        "$@" >/dev/null 2>&1 && return
        kill -0 "$kiosk" 2>/dev/null || fail "the window closed while waiting for $what"
        sleep 0.1
    done
    fail "no $what after a minute"
}
volume_of() { grep -a -o '"volume_mm3":[0-9]*' "$1" | cut -d: -f2; }

wait_for "window" xdotool search --name '^Onggi'
wait_for "title that tells the tool" xdotool search --name 'tool 10 mm'
xdotool mousemove 1000 300
xdotool key e
wait_for "fresh lump" test -s out/pot-1.glb

xdotool keydown space
for x in $(seq 900 -10 740); do
    xdotool mousemove "$x" 300
    sleep 0.05
done
sleep 1
xdotool key e
wait_for "thrown pot" test -s out/pot-2.glb
xdotool keyup space
xdotool key bracketright
wait_for "larger tool in the title" xdotool search --name 'tool 11 mm'
xdotool key s
wait_for "picture" test -s out/pot-1.png

fresh=$(volume_of out/pot-1.glb)
thrown=$(volume_of out/pot-2.glb)
[ "$thrown" -lt "$((fresh - 1000))" ] || fail "the mouse did not move the clay: $fresh mm3 before, $thrown mm3 after"

xdotool key Escape
status=0
wait "$kiosk" || status=$?
[ "$status" -eq 0 ] || fail "the kiosk ended with exit code $status"
printf 'thrown by mouse: %s mm3 of %s mm3 left\n' "$thrown" "$fresh"
