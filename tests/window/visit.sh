#!/usr/bin/env bash
# A visitor at the window, from attract to a kept pot: visit.sh ONGGI TARGETS FOLDER [HAND [LANGUAGE [WIDTHxHEIGHT]]]
# TARGETS: the program screen_targets, which knows where the buttons are. HAND: mouse, touch, keys or switch (the space
# bar alone). It brings a display of its own and leaves a picture of each screen in FOLDER.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
onggi=$1
targets=$2
hand=${4:-mouse}
language=${5:-en}
size=${6:-1280x720}
width=${size%x*}
height=${size#*x}
clay_level=54  # per cent of the height: low on the lump
[ "$height" -gt "$width" ] && clay_level=60
rm -rf "$3"
mkdir -p "$3"
cd "$3"
# lay_out LANGUAGE [low]: where the buttons are from now on.
lay_out() { "$targets" "$1" "$width" "$height" 1 "${2:-}" >targets; }
lay_out "$language"

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
open_kiosk() {
    "$onggi" kiosk --config kiosk.toml --size "$size" --device mouse >>kiosk.log 2>&1 &
    kiosk=$!
}
open_kiosk
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
throwing=throw-0  # as the layout calls it: with one switch there are more targets on it
[ "$hand" = switch ] && throwing=throw-scan-0

# Where a screen has a button, by the layout itself: at SCREEN BUTTON [VALUE]; sets x, y and place (in the ring).
at() {
    local value=${3:-}
    local line
    line=$(awk -v screen="$1" -v button="$2" -v value="$value" \
        '$1 == screen && $2 == button && (value == "" || $3 == value) { print $4, $5, $6; exit }' targets)
    [ -n "$line" ] || fail "expected a button '$2' on '$1', found none"
    read -r place x y <<<"$line"
}
# A mouse comes, hovers and clicks; a finger is there at once, as X11 tells of it.
click() {
    if [ "$hand" = touch ]; then
        xdotool mousemove "$1" "$2" mousedown 1 sleep 0.08 mouseup 1
    else
        xdotool mousemove "$1" "$2" sleep 0.1 mousedown 1 sleep 0.1 mouseup 1
    fi
}
# press SCREEN BUTTON [VALUE], with whatever hand the visitor has.
press() {
    at "$@"
    case $hand in
    mouse | touch) click "$x" "$y" ;;
    *) take "$place" ;;
    esac
}
# Presses the clay in from the right, low down. The first key brings the hand beside the clay, each one then takes it a
# step; the single switch finds the same four steps on the screen.
press_in() {
    case $hand in
    mouse | touch)
        local from=$((width * 59 / 100)) to=$((width * 55 / 100)) level=$((height * clay_level / 100))
        xdotool mousemove "$from" "$level" sleep 0.2 mousedown 1
        for x in $(seq "$from" -4 "$to"); do
            xdotool mousemove "$x" "$level" sleep 0.05
        done
        sleep 0.8
        xdotool mouseup 1
        ;;
    keys)
        for _ in $(seq 5); do xdotool key Left sleep 0.15; done
        for _ in $(seq 4); do xdotool key Up sleep 0.15; done
        ;;
    switch)
        at $throwing hand-left
        take "$place"
        for _ in $(seq 4); do  # the ring stays where it is pressed again
            sleep 0.6
            xdotool key space
        done
        ;;
    esac
}
# Another language, its own again, and all controls in the lower half: from the choice of pots and back to it.
through_languages() {
    local own other=ko value=0
    own=$(case $language in ko) echo 0 ;; en) echo 1 ;; *) echo 2 ;; esac)  # as screen_targets numbers them
    [ "$language" = ko ] && other=en && value=1
    press choose languages; on_screen "choose - language $language"
    press language language "$value"; on_screen "choose - language $other"
    lay_out "$other"
    press language language "$own"; on_screen "choose - language $language"
    lay_out "$language"
    press language reach; on_screen "choose - language $language low"
    lay_out "$language" low
    press language comfort-done; on_screen choose
}
# The power goes while somebody throws, and comes back.
through_a_failure_of_power() {
    wait_for "journal of the visit" bash -c 'grep -qs . gallery/state/visit-*'
    sleep 1.5  # it is on the disk once a second
    kill -9 "$kiosk"
    wait "$kiosk" 2>/dev/null || true
    open_kiosk
    wait_for "window" xdotool search --name '^Onggi'
    on_screen attract
    wait_for "interrupted visit" grep -q 'interrupted visit: .* wait to be picked up' kiosk.log
    click $((width / 2)) $((height / 2))
    on_screen resume
    press resume resume-go; on_screen throw
}
title() { xdotool search --name '^Onggi' getwindowname 2>/dev/null | tail -1; }
# take PLACE: walks the ring there, or waits for it, and takes what it is on; places count from 0.
take() {
    local before
    if [ "$hand" = keys ]; then
        for _ in $(seq 40); do
            xdotool search --name "^Onggi - .*\[$1\]\$" >/dev/null 2>&1 && break
            # A frame may be slow: a second step before the first is shown would go past the place.
            before=$(title)
            xdotool key Tab
            for _ in $(seq 50); do
                [ "$(title)" = "$before" ] || break
                sleep 0.1
            done
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
mouse | touch) click $((width / 2)) $((height / 2)) ;;
keys) xdotool key Tab ;;
switch) xdotool key space ;;
esac
on_screen choose
[ "$hand" = keys ] && through_languages
case $hand in
touch)  # the pot itself, above its card
    at choose target 0
    click "$x" $((height * 42 / 100))
    ;;
keys) press choose target 1 ;;
*) press choose free ;;
esac
on_screen throw
press_in
sleep 0.5
on_screen throw
least_mm=51
most_mm=999
case $hand in
mouse)  # all of it is taken back, and nothing is pressed in again
    press throw-0 undo
    sleep 1
    on_screen throw
    least_mm=49
    most_mm=50
    ;;
touch) through_a_failure_of_power ;;
esac
if [ "$hand" != switch ]; then  # whom it takes half a minute
    press $throwing look-in
    sleep 2
    on_screen throw
    press throw-look-in look-in
    sleep 2
    on_screen throw
fi
press $throwing done
on_screen firing; on_screen glaze
press glaze-0 glaze 2; sleep 0.5; on_screen glaze
press glaze-2 take-glaze; on_screen your-pot
press your-pot keep; on_screen keep
pot=gallery/$(date +%F)/pot-001
wait_for "kept pot" test -s "$pot/pot.png"
for file in pot.onggi pot.glb pot.stl pot.png; do
    [ -s "$pot/$file" ] || fail "expected $pot/$file, found none"
done
[ "$(head -c 4 "$pot/pot.glb")" = glTF ] || fail "expected a GLB, found something else"
# Clay that was pressed in low down stands higher; a lump that nobody touched is 49.6 mm high, and one from which the
# touch was taken back.
height_mm=$(grep -ao '"wet_height_mm":[0-9]*' "$pot/pot.glb" | cut -d: -f2)
[ "${height_mm:-0}" -ge "$least_mm" ] && [ "$height_mm" -le "$most_mm" ] ||
    fail "expected clay of $least_mm mm or more as the hand has left it, $most_mm at most, found $height_mm mm"
"$onggi" replay "$pot/pot.onggi" --validate || fail "the session that was kept does not replay"
sleep 0.6
on_screen keep
press keep finish; on_screen attract
xdotool key Escape
status=0
wait "$kiosk" || status=$?
[ "$status" -eq 0 ] || fail "the kiosk ended with exit code $status"
printf 'kept by %s in %s: %s\n' "$hand" "$language" "$pot"
