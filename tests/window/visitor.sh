#!/usr/bin/env bash
# A visitor at the window, with any device, in any language. Sourced, never run; the script's arguments are
# ONGGI PROGRAMS FOLDER [HAND [LANGUAGE [WIDTHxHEIGHT]]]. It starts its own display, works in FOLDER and
# leaves a picture of each screen there. PROGRAMS: the folder of screen_targets, which prints the positions of
# buttons, and of the programs that throwing.sh uses. HAND: mouse, touch, pen, keys, switch (the space bar alone),
# gamepad or spacemouse (which have no buttons for screens: the mouse presses those). Optional variables:
# FORGIVING: whether the clay is stronger than real clay; BACKEND: the renderer's backend; SHARES: also takes
# the pot home by phone; CAGED: a compositor has opened a display already, where the kiosk is full screen and
# ends on request; TOUCH_SCREEN: the socket of that display's touch screen; OPENS, ENDS: functions that
# replace those here, to start the kiosk (setting `kiosk` to its process) and to end it.
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
source "$(dirname "${BASH_SOURCE[0]}")/waiting.sh"
source "$(dirname "${BASH_SOURCE[0]}")/throwing.sh"
onggi=$1
programs=$2
hand=${4:-mouse}
language=${5:-en}
size=${6:-1280x720}
width=${size%x*}
height=${size#*x}
reach=  # "low": all controls in the lower half
rm -rf "$3"
mkdir -p "$3"
cd "$3"
# lay_out LANGUAGE [low]: sets the layout of buttons from now on.
lay_out() {
    reach=${2:-}
    "$programs/screen_targets" "$1" "$width" "$height" 1 "$reach" >targets
}
lay_out "$language"

kiosk=
server=
trap 'kill $kiosk $server 2>/dev/null || true' EXIT
if [ -z "${CAGED:-}" ]; then
    case $hand in
    touch | pen) open_touch_display . "$size" ;;
    *) open_display . "$size" ;;
    esac
fi
listen_for_life
if [ "$hand" = touch ] || [ "$hand" = pen ]; then
    mkfifo to_hands from_hands
    touched=${TOUCH_SCREEN:-touch-screen}
    [ "$hand" = pen ] && touched="pen:pen"
    "$programs/finger" "$touched" "$width" "$height" ${TURNED:+turned} <to_hands >from_hands 2>>kiosk.log &
    exec 8>to_hands 9<from_hands
fi

# screen_targets lays out the panel of languages without the switch for speech, wherever espeak-ng is.
cat >kiosk.toml <<TOML
[languages]
first = "$language"
[screen]
full_screen = $([ -n "${CAGED:-}" ] && echo true || echo false)
backend = "${BACKEND:-auto}"
[sound]
speech = "off"
[visit]
forgiving = ${FORGIVING:-true}
shows_by_itself = false
idle_s = 600
[gallery]
folder = "gallery"
least_free_mb = 1
TOML
# A gallery of several days, unless its pots are looked at as well.
if [ -n "${SHARES:-}" ]; then
    source "$here/phone.sh"
elif [ -z "${OPENS:-}" ]; then
    mkdir -p gallery/2026-01-02/pot-001
    for file in pot.glb pot.png; do echo "another visitor's" >"gallery/2026-01-02/pot-001/$file"; done
fi
open_kiosk() {
    local words=("${as_usual[@]}" "$onggi" kiosk --config kiosk.toml --size "$size")
    if [ "$hand" = gamepad ] || [ "$hand" = spacemouse ]; then
        mkfifo to_hands from_hands
        umockdev-wrapper "$programs/hands_at" "$hand" "${words[@]}" <to_hands >from_hands 2>>kiosk.log &
        kiosk=$!
        exec 8>to_hands 9<from_hands
    else
        "${words[@]}" --device mouse >>kiosk.log 2>&1 &
        kiosk=$!
    fi
}
# A script may replace both functions.
[ -z "${OPENS:-}" ] || open_kiosk() { "$OPENS"; }
end_kiosk() { "${ENDS:-$([ -n "${CAGED:-}" ] && echo ask_to_end || echo press_escape)}"; }
press_escape() { xdotool key Escape; }
ask_to_end() { kill -TERM "$kiosk"; }
open_kiosk
# The title names a screen at once; its picture follows after some frames and a cross-fade of a quarter of a
# second.
on_screen() {
    wait_for "screen '$1'" xdotool search --name "^Onggi - $1( - [0-3] of 3, [0-9]+ mm(, (rib|sponge|wire))?(, tools)?| - [0-9]+ strokes| - [0-9]+ g)?( .[0-9]+.)?\$"
    pause 6
    shot=$((shot + 1))
    # Xwayland's root window is empty.
    local seen=root
    [ -z "${CAGED:-}" ] || seen=$(xdotool search --name '^Onggi' | tail -1)
    command -v import >/dev/null && import -window "$seen" "$(printf '%02d' "$shot")-$1.png" || true
}
shot=0
throwing=throw-0  # the layout's name: with one switch there are more targets
[ "$hand" = switch ] && throwing=throw-scan-0
asking=throw-thick
[ "$hand" = switch ] && asking=throw-thick-scan
decorating=decorate-0
[ "$hand" = switch ] && decorating=decorate-scan

# at SCREEN BUTTON [VALUE]: finds a button in the layout; sets x, y and place (in the ring).
at() {
    local value=${3:-}
    local line
    line=$(awk -v screen="$1" -v button="$2" -v value="$value" \
        '$1 == screen && $2 == button && (value == "" || $3 == value) { print $4, $5, $6; exit }' targets)
    [ -n "$line" ] || fail "expected a button '$2' on '$1', found none"
    read -r place x y <<<"$line"
}
# point WORD...: moves a mouse, in xdotool's syntax, or a finger on a real touch screen.
point() {
    case $hand in
    touch | pen) hands "$@" ;;
    *) xdotool "$@" ;;
    esac
}
# A mouse moves, hovers and clicks; a finger touches at once.
click() {
    if [ "$hand" = touch ]; then
        point mousemove "$1" "$2" mousedown 1 sleep 0.08 mouseup 1
    else
        point mousemove "$1" "$2" sleep 0.1 mousedown 1 sleep 0.1 mouseup 1
    fi
}
# press SCREEN BUTTON [VALUE]: with the visitor's device.
press() {
    at "$@"
    case $hand in
    keys | switch) take "$place" ;;
    *) click "$x" "$y" ;;
    esac
}
# The ring's target from the title, "[5]"; empty if no ring is shown. The rest of the title changes with the
# clay.
ring() { title | grep -oE '\[[0-9]+\]$' || true; }
has_left() { [ "$(ring)" != "$1" ]; }
is_elsewhere() { [[ "$(title)" != *"[$1]" ]]; }
is_there_or_gone() { [[ "$(title)" = *"[$1]" ]] || ! has_come_to "$2"; }
# take PLACE: moves the ring there, or waits for it, and presses; places count from 0.
take() {
    local before after
    if [ "$hand" = keys ]; then
        for _ in $(seq 40); do
            xdotool search --name "^Onggi - .*\[$1\]\$" >/dev/null 2>&1 && break
            # A frame may be slow: a second step before the first is shown would overshoot.
            before=$(ring)
            xdotool key Tab
            within 50 "the ring's next step" has_left "$before" || true
        done
        xdotool key Return
    else
        local began
        began=$(title | grep -oE '^Onggi - [a-z-]+' || true)
        began=${began#Onggi - }
        for _ in $(seq 5); do
            # Press as soon as it arrives: if it is about to move on, a busy machine would press the next one.
            wait_for "the ring elsewhere than on target $1" is_elsewhere "$1"
            wait_for "the ring on target $1" is_there_or_gone "$1" "$began"
            has_come_to "$began" || return 0  # what was taken came late
            before=$(title)
            xdotool key space
            pause 3
            # The ring stays a while on the pressed target, or the screen changes; otherwise the ring moved
            # before the press.
            after=$(title)
            [[ "$after" = *"[$1]" || "$(screen_of "$after")" != "$(screen_of "$before")" ]] && return
        done
        fail "expected the ring to stay on target $1, found '$after'"
    fi
}
# The screen part of a title: "Onggi - throw, rib" from "Onggi - throw - 3 of 3, 56 mm, rib [4]".
screen_of() { sed -E 's/ - [0-3] of 3, [0-9]+ mm//; s/ - [0-9]+ g//; s/ .[0-9]+.$//' <<<"$1"; }
has_come_to() { [[ "$(title)" = "Onggi - $1"* ]]; }
fills_the_screen() {
    local geometry
    geometry=$(xdotool search --name '^Onggi' getwindowgeometry --shell | grep -E '^(X|Y|WIDTH|HEIGHT)=' | tr '\n' ' ')
    [ "$geometry" = "X=0 Y=0 WIDTH=$width HEIGHT=$height " ] || fail "expected the whole screen, found $geometry"
}
# To the choice of pots, with the visitor's device.
begin_visit() {
    wait_for "window" xdotool search --name '^Onggi'
    [ -z "${CAGED:-}" ] || fills_the_screen
    on_screen attract
    case $hand in
    mouse | touch | pen) click $((width / 2)) $((height / 2)) ;;
    keys) xdotool key Tab ;;
    switch) xdotool key space ;;
    *)  # a late frame may miss a stick that was pushed for a moment
        for _ in $(seq 10); do
            hands push 20 0 20
            so_soon has_come_to choose && break
        done
        ;;
    esac
    on_screen choose
}
# Resumes a visit with opened clay after the program ended in the middle of it.
pick_it_up() {
    wait_for "window" xdotool search --name '^Onggi'
    on_screen attract
    wait_for "interrupted visit" grep -q 'interrupted visit: .* can be resumed' kiosk.log
    click $((width / 2)) $((height / 2))
    on_screen resume
    press resume resume-go; on_screen throw
    has_done 2 || fail "expected clay that is open, as it was left, found '$(title)'"
}
has_strokes() { [[ "$(title)" == *" - $1 strokes"* ]]; }
# Draws a band and a line of iron, with any device; keys and one switch put the brush down and lift it.
decorate_the_pot() {
    local middle=$((width / 2)) high=$((height * 45 / 100))
    press $decorating drawing-tool 1
    case $hand in
    keys)
        xdotool key Up; xdotool key Return; pause 5; xdotool key Return
        ;;
    switch)
        press $decorating put-brush; pause 5; press $decorating put-brush
        ;;
    *)
        point mousemove "$middle" "$high" mousedown 1 sleep 0.5 mouseup 1
        ;;
    esac
    wait_for "a stroke" has_strokes 1
    on_screen decorate
}
# Trims a thick foot of the pot, which was TOP mm high. With one switch it is left as it is, and where the tools do not
# forgive, because they would cut through the wall.
is_dry() { has_come_to trim || has_come_to decorate; }
is_lighter() { [[ "$(title)" =~ ^Onggi\ -\ trim\ -\ ([0-9]+)\ g ]] && [ "${BASH_REMATCH[1]}" -ge "$1" ]; }
shave() {  # from beside the wall inwards, at the cue
    case $hand in
    keys) keys Left ;;
    *) stroke 2 "80 $(($1 - 12))" "46 $(($1 - 12))" ;;
    esac
}
turn_the_foot() {
    wait_for "a dry pot" is_dry
    if has_come_to trim; then
        on_screen trim
        if [ "$hand" = switch ]; then
            press trim-scan skip
        elif [ "${FORGIVING:-true}" = false ]; then
            press trim skip
        else
            [ "${clay_top:-0}" -ge "$1" ] || clay_top=$1
            work_until "a foot that was turned" "is_lighter 5" shave "$1"
            on_screen trim
            title
            press trim-taken done
        fi
    fi
    on_screen decorate
}
is_asked() { [[ "$(title)" == "Onggi - throw"*", asks"* ]]; }
has_answered_done() { is_asked || [[ "$(title)" == "Onggi - firing"* ]]; }
# The folders of all whole pots; the kiosk writes them as pot-NNN.part. A gallery may have several days.
kept_pots() {
    local picture
    for picture in gallery/*-*-*/pot-*[0-9]/pot.png; do
        [ ! -s "$picture" ] || dirname "$picture"
    done
}
# is_kept BEFORE: whether a pot has come that the list lacks; sets `pot` to its folder.
is_kept() {
    pot=$(comm -13 <(printf '%s\n' "$1") <(kept_pots))
    [ -n "$pot" ]
}
# From the wheel to the shelf, where the result must be a pot; then ends the kiosk.
keep_the_pot() {
    local top
    top=$(clay_mm)
    press $throwing done
    wait_for "the kiln, or a question about thick walls" has_answered_done
    if is_asked; then press "$asking" done; fi  # they stay so
    on_screen firing; turn_the_foot "$top"
    decorate_the_pot
    press $decorating done
    on_screen firing; on_screen glaze
    press glaze-0 glaze 2; pause 5; on_screen glaze
    press glaze-2 take-glaze; on_screen your-pot
    local file before verdict status=0
    before=$(kept_pots)
    press your-pot keep; on_screen keep
    wait_for "kept pot" is_kept "$before"
    for file in pot.onggi pot.glb pot.stl pot.3mf pot.png; do
        [ -s "$pot/$file" ] || fail "expected $pot/$file, found none"
    done
    [ "$(head -c 4 "$pot/pot.glb")" = glTF ] || fail "expected a GLB, found something else"
    pause 6
    on_screen keep
    if [ -n "${SHARES:-}" ]; then
        take_it_home
        hang_it_on_the_wall
        press home-ready finish
        on_screen attract
        look_at_the_wall
        look_at_the_film
    else
        press keep finish
        on_screen attract
    fi
    end_kiosk
    wait "$kiosk" || status=$?
    [ "$status" -eq 0 ] || fail "the kiosk ended with exit code $status"
    # Unoptimised, judging takes longer than the kiosk's timeout after keeping a pot.
    verdict=$("$programs/judge_session" "$pot/pot.onggi") || fail "expected a pot, found ${verdict:-no verdict}"
    "$onggi" replay "$pot/pot.onggi" --validate || fail "the session that was kept does not replay"
    printf 'kept by %s in %s: %s, %s\n' "$hand" "$language" "$pot" "$verdict"
}
