#!/usr/bin/env bash
# A visitor at the window, from attract to a kept pot: visit.sh ONGGI PROGRAMS FOLDER [HAND [LANGUAGE
# [WIDTHxHEIGHT]]], with visitor.sh's arguments. TOOLS: with one switch, also uses every tool. MEMORY: checks
# the kiosk's memory.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/visitor.sh"
source "$here/memory.sh"

# Changes the language and back, and moves all controls into the lower half: from the choice of pots and back
# to it.
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
# A power cut during throwing, and a restart.
through_a_failure_of_power() {
    wait_for "journal of the visit" bash -c 'grep -qs . gallery/state/visit-*'
    # The journal is written once a second: after two more blocks everything before is on disk.
    for _ in 1 2; do
        local bytes
        bytes=$(cat gallery/state/visit-* | wc -c)
        grown() { [ "$(cat gallery/state/visit-* | wc -c)" -gt "$bytes" ]; }
        wait_for "another second of the visit" grown
    done
    kill -9 "$kiosk"
    wait "$kiosk" 2>/dev/null || true
    open_kiosk
    pick_it_up
}

# ledge NAME HELD: the layout's name of the ledge with that tool; with one switch it has more targets.
ledge() { echo "$1-$([ "$hand" = switch ] && echo scan-)$2"; }
# take_tool FROM HELD NUMBER: opens the tray and takes a tool; FROM is the ledge shown while HELD is in the
# hand, NUMBER as in screen_targets.
take_tool() {
    local tools=("" ", rib" ", sponge" ", wire")
    press "$1" tools; wait_for "the tray" lies_there "${tools[$2]}, tools"
    on_screen throw
    press "$(ledge tools "$2")" take-tool "$3"; wait_for "tool $3 in the hand" lies_there "${tools[$3]}"
    on_screen throw
}
# Whether the title shows this tool and tray state after the clay's height: ", rib, tools".
lies_there() { [ "$(title | sed -E 's/.* mm//; s/ .[0-9]+.$//')" = "$1" ]; }
# Rib, sponge and wire: fairs and wipes the wall, cuts a ring off the rim, undoes it, and cuts again.
with_every_tool() {
    local top rib sponge wire
    top=$(clay_mm) rib=$(ledge held 1) sponge=$(ledge held 2) wire=$(ledge held 3)
    take_tool "$throwing" 0 1
    draw_along "$top" "$rib"
    on_screen throw
    take_tool "$rib" 1 2
    draw_along "$top" "$sponge"
    on_screen throw
    take_tool "$sponge" 2 3
    top=$(clay_mm)  # after rib and sponge
    press "$wire" hand-down; press "$wire" hand-down
    on_screen throw
    press "$wire" cut
    is_lower() { [ "$(clay_mm)" -le $((top - 6)) ]; }
    wait_for "a lower rim" is_lower
    on_screen throw
    press "$throwing" undo
    is_back() { [ "$(clay_mm)" -ge $((top - 1)) ]; }
    wait_for "the rim as it was" is_back
}

is_a_lump() { [ "$(clay_mm)" -eq 50 ]; }
# By mouse, from one untouched lump to the next: a touch, a view into the clay, another screen, new clay.
to_new_clay() {
    press_it
    press throw-0 look-in; on_screen throw
    press throw-look-in look-in; on_screen throw
    press throw-0 languages; on_screen "throw - language $language"
    press language comfort-done; on_screen throw
    press throw-0 new-clay
    wait_for "new clay" is_a_lump
    on_screen throw
}

begin_visit
[ "$hand" = keys ] && through_languages
case $hand in
touch)  # the pot itself, above its card
    at choose other 0  # stands beside the pot's foot
    foot_y=$y
    at choose target 0
    click "$x" "$foot_y"
    ;;
keys) press choose target 1 ;;
*) press choose free ;;
esac
on_screen throw
[ -z "${MEMORY:-}" ] || holds_no_more to_new_clay
# A palm rests on the panel's edge until the end.
[ "$hand" = touch ] && point palm 3 $((height * 6 / 10)) sleep 4
press_it
on_screen throw
if [ "$hand" = mouse ]; then  # everything is undone
    press throw-0 undo
    wait_for "the lump as it was" is_a_lump
    on_screen throw
fi
open_it
on_screen throw
[ "$hand" = touch ] && through_a_failure_of_power
raise_it
on_screen throw
case $hand in
mouse | touch | keys) with_every_tool ;;
switch) [ -z "${TOOLS:-}" ] || with_every_tool ;;  # whom it takes minutes
esac
if [ "$hand" != switch ]; then  # whom it takes half a minute
    press $throwing look-in
    pause 20
    on_screen throw
    press throw-look-in look-in
    pause 20
    on_screen throw
fi
keep_the_pot
