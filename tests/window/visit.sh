#!/usr/bin/env bash
# A visitor at the window, from attract to a kept pot: visit.sh ONGGI FOLDER [HAND [LANGUAGE [WIDTHxHEIGHT]]]
# HAND: mouse, keys or switch (the space bar alone). It brings a display of its own and leaves a picture of each screen
# in FOLDER.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
onggi=$1
hand=${3:-mouse}
language=${4:-en}
size=${5:-1280x720}
width=${size%x*}
rm -rf "$2"
mkdir -p "$2"
cd "$2"

kiosk=
server=
trap 'kill $kiosk $server 2>/dev/null || true' EXIT
open_display . "$size"

cat >kiosk.toml <<TOML
[languages]
first = "$language"
[gallery]
folder = "gallery"
least_free_mb = 1
TOML
"$onggi" kiosk --config kiosk.toml --size "$size" --device mouse >kiosk.log 2>&1 &
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
# A screen is there when the title says so; its cross-fade is over a quarter of a second later.
on_screen() {
    wait_for "screen '$1'" xdotool search --name "^Onggi - $1( .[0-9]+.)?\$"
    sleep 0.6
    shot=$((shot + 1))
    command -v import >/dev/null && import -window root "$(printf '%02d' "$shot")-$1.png" || true
}
shot=0

# Places are those of the 1280 x 720 screens; Arabic is mirrored.
click() {
    local x=$1
    [ "$language" = ar ] && x=$((width - x))
    xdotool mousemove "$x" "$2" sleep 0.1 mousedown 1 sleep 0.1 mouseup 1
}
press_in() {
    xdotool mousemove 760 470 sleep 0.2 mousedown 1
    for x in $(seq 760 -4 716); do
        xdotool mousemove "$x" 470 sleep 0.03
    done
    xdotool mouseup 1
}
# take PLACE: walks the ring there, or waits for it, and takes what it is on; places count from 0.
take() {
    if [ "$hand" = keys ]; then
        for _ in $(seq 40); do
            xdotool search --name "^Onggi - .*\[$1\]\$" >/dev/null 2>&1 && break
            xdotool key Tab
            sleep 0.15
        done
        xdotool key Return
    else
        wait_for "the ring on target $1" xdotool search --name "^Onggi - .*\[$1\]\$"
        xdotool key space
    fi
}

wait_for "window" xdotool search --name '^Onggi'
on_screen attract
case $hand in
mouse)
    click 640 360; on_screen choose
    click 140 500; on_screen throw
    press_in
    click 640 630; on_screen throw
    click 1170 630; on_screen firing; on_screen glaze
    click 740 620; sleep 0.5; on_screen glaze
    click 1138 413; on_screen your-pot
    click 1128 650; on_screen keep
    ;;
keys)
    xdotool key Tab; on_screen choose
    take 1; on_screen throw
    for _ in $(seq 14); do xdotool key Left sleep 0.1; done
    for _ in $(seq 6); do xdotool key Up sleep 0.1; done
    take 0; on_screen firing; on_screen glaze
    take 1; on_screen your-pot
    take 2; on_screen keep
    ;;
switch)
    xdotool key space; on_screen choose
    take 1; on_screen throw
    take 0; on_screen firing; on_screen glaze
    take 1; on_screen your-pot
    take 2; on_screen keep
    ;;
esac
pot=gallery/$(date +%F)/pot-001
wait_for "kept pot" test -s "$pot/pot.png"
for file in pot.onggi pot.glb pot.stl pot.png; do
    [ -s "$pot/$file" ] || fail "expected $pot/$file, found none"
done
[ "$(head -c 4 "$pot/pot.glb")" = glTF ] || fail "expected a GLB, found something else"
"$onggi" replay "$pot/pot.onggi" --validate || fail "the session that was kept does not replay"
sleep 0.6
[ "$hand" = mouse ] && { on_screen keep; click 870 629; on_screen attract; }
xdotool key Escape
status=0
wait "$kiosk" || status=$?
[ "$status" -eq 0 ] || fail "the kiosk ended with exit code $status"
printf 'kept by %s in %s: %s\n' "$hand" "$language" "$pot"
