#!/usr/bin/env bash
# The staff at a locked kiosk, with real X events: staff.sh ONGGI ASK_TO_CLOSE FOLDER. First everything a
# visitor might try to leave the kiosk; then the corner, the PIN, the panel, its tests, a pot deleted, a code
# withdrawn, a restart, the panel left alone; finally an unlocked window, which closes like any other. It
# starts its own display and leaves pictures in FOLDER.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
source "$(dirname "${BASH_SOURCE[0]}")/waiting.sh"
onggi=$1
ask=$2
rm -rf "$3"
mkdir -p "$3"
cd "$3"
kiosk=
server=
trap 'kill $kiosk $server 2>/dev/null || true' EXIT
open_display . 1280x720
listen_for_life

settings() {
    cat >kiosk.toml <<TOML
[languages]
first = "en"
[gallery]
folder = "gallery"
least_free_mb = 1
[sound]
remember_staff = true
[staff]
pin = "2580"
locked = $1
closes_after_s = $((silence_s / 2 < 600 ? silence_s / 2 : 600))
name = "Wheel 2"
[sharing]
public_url = "http://127.0.0.1:8080"
outbox = "outbox"
TOML
}
start() {
    "${as_usual[@]}" "$onggi" kiosk --config kiosk.toml --size 1280x720 "$@" >>kiosk.log 2>&1 &
    kiosk=$!
}
titled() { xdotool search --name "^Onggi - $1\$" >/dev/null 2>&1; }
shot=0
on_screen() {
    wait_for "screen '$1'" titled "$1"
    pause 6
    shot=$((shot + 1))
    command -v import >/dev/null && import -window root "$(printf '%02d' "$shot")-${2:-$1}.png" || true
}
click() {
    xdotool mousemove "$1" "$2" sleep 0.1 mousedown 1 sleep 0.1 mouseup 1
    pause 1
}
# hold_corner COMMAND...: holds the corner while the command runs.
hold_corner() {
    xdotool mousemove 30 30 sleep 0.1 mousedown 1
    "$@"
    xdotool mouseup 1
}
# The keypad's positions: three columns 136 apart from 504, four rows 100 apart from 218.
digit() {
    local place=$(($1 == 0 ? 10 : $1 - 1))
    click $((504 + place % 3 * 136)) $((218 + place / 3 * 100))
}
pin() { for d in $(grep -o . <<<"$1"); do digit "$d"; done; }
ends_with() {
    local status=0
    wait "$kiosk" || status=$?
    [ "$status" -eq "$1" ] || fail "expected exit code $1, found $status"
}
window() { xdotool search --name '^Onggi' | head -1; }
# Sends the close request of a window manager, as for the window's cross and Alt+F4.
ask_to_close() { "$ask" "$(window)"; }

# A pot to delete.
mkdir -p gallery/2026-01-02/pot-001 gallery/2026-01-02/pot-002
for pot in 1 2; do echo clay >"gallery/2026-01-02/pot-00$pot/pot.glb"; done
# The first pot is shared, in the outbox's form.
mkdir -p outbox/7777ZZZZ
now=$(date +%s)
printf 'made %d\nexpires %d\nname 2026-01-02/pot-001\n' "$now" $((now + 36000)) >outbox/7777ZZZZ/.kept

settings true
start
wait_for "window" xdotool search --name '^Onggi'
on_screen attract
# None of these may end the kiosk.
for key in Escape alt+F4 ctrl+q ctrl+c ctrl+w q F11; do xdotool key "$key" sleep 0.1; done
ask_to_close
kill -INT "$kiosk"
pkill -INT -P "$kiosk" || true # and the program under its supervisor
pause 10
kill -0 "$kiosk" || fail "a locked kiosk was left by a visitor"
wait_for "a screen" xdotool search --name '^Onggi - (attract|choose)$'

# Holding the corner for less than five seconds has no effect; then the keypad, and three wrong PINs.
hold_corner sleep 3
pause 5
titled '.*pin' && fail "the keypad came too early"
hold_corner pause 58
on_screen '.* - pin' pin
for _ in 1 2 3; do pin 1111; done
on_screen '.* - pin' pin-waits
pin 2580
pause 5
titled '.* - staff' && fail "the PIN counted while it should not"
click 504 518 # Close
wait_for "the keypad gone" xdotool search --name '^Onggi - (attract|choose)$'
pause 90
hold_corner pause 58
on_screen '.* - pin' pin-again
pin 2580
on_screen '.* - staff' health

# The panel's pages, its tests, its volume and language; a key at the right, 70 apart from 183.
action() { click 1096 $((183 + 70 * $1)); }
click 270 104; on_screen '.* - staff' visits
click 600 104; on_screen '.* - staff' devices
action 0; pause 45; on_screen '.* - staff' force-tested
action 1; on_screen '.* - staff' sound-tested
action 3; pause 5
wait_for "the volume kept" grep -q 'volume = 4' gallery/statistics/staff.toml
action 4; pause 5
wait_for "the language kept" grep -q 'first = "ar"' gallery/statistics/staff.toml
action 4; pause 5  # Korean, and back: in Arabic the other corner would be used
action 4; pause 5
wait_for "the first language again" grep -q 'first = "en"' gallery/statistics/staff.toml
# Delete the second pot, which is the first in the list; once with no, once with yes.
click 440 104; on_screen '.* - staff' gallery
click 852 168; on_screen '.* - staff' asks
click 480 414; pause 5
[ -d gallery/2026-01-02/pot-002 ] || fail "a pot was deleted without confirmation"
click 852 168; pause 5
click 800 414
gone() { [ ! -e gallery/2026-01-02/pot-002 ]; }
wait_for "the pot gone" gone
[ -d gallery/2026-01-02/pot-001 ] || fail "the other pot is gone as well"
# Withdraw the code of the remaining pot likewise: the pot stays on the shelf.
click 704 168; on_screen '.* - staff' asks-withdraw
click 480 414; pause 5
[ -d outbox/7777ZZZZ ] || fail "a code was withdrawn without confirmation"
click 704 168; pause 5
click 800 414
withdrawn() { [ ! -e outbox/7777ZZZZ ]; }
wait_for "the code withdrawn" withdrawn
[ -d gallery/2026-01-02/pot-001 ] || fail "the pot is gone with its code"
on_screen '.* - staff' withdrawn
# Restart: the same process goes on with a new window.
action 5; pause 5
click 800 414
twice() { [ "$(grep -c . gallery/statistics/starts.csv)" -eq 3 ]; }
wait_for "a second start" twice
wait_for "window" xdotool search --name '^Onggi - attract$'
kill -0 "$kiosk" || fail "the restart is another process"
pause 10

# An idle panel locks itself.
hold_corner pause 58
on_screen '.* - pin' pin-at-last
pin 2580
on_screen '.* - staff' health-at-last
is_locked() { ! titled '.* - staff'; }
wait_for "panel that closes by itself" is_locked
# The system can still end it.
kill -TERM "$kiosk"
ends_with 0

# Not locked: the window's cross, Escape and Ctrl+C close it.
settings false
for way in cross escape interrupt; do
    start --device mouse --volume 0
    wait_for "window" xdotool search --name '^Onggi'
    wait_for "screen" titled attract
    case $way in
    cross) ask_to_close ;;
    escape) xdotool key Escape ;;
    interrupt) kill -INT "$kiosk" ;;
    esac
    ends_with 0
done
printf 'the staff had access, and no visitor\n'
