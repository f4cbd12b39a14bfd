#!/usr/bin/env bash
# A visitor at the window, from attract to a kept pot: visit.sh ONGGI PROGRAMS FOLDER [HAND [LANGUAGE [WIDTHxHEIGHT]]], as
# visitor.sh says them. TOOLS: one switch takes up every tool, too. MEMORY: what the kiosk holds is watched.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/visitor.sh"
source "$(dirname "${BASH_SOURCE[0]}")/memory.sh"

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
    # It is on the disk once a second: what was done before the first of two more blocks is there.
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

# ledge NAME HELD: what the layout calls it while that is held; with one switch there are more targets on it.
ledge() { echo "$1-$([ "$hand" = switch ] && echo scan-)$2"; }
# take_tool FROM HELD NUMBER: the tray, and what lies there; FROM is the ledge that is seen while HELD is in the hand,
# NUMBER as screen_targets counts.
take_tool() {
    local tools=("" ", rib" ", sponge" ", wire")
    press "$1" tools; wait_for "the tray" lies_there "${tools[$2]}, tools"
    on_screen throw
    press "$(ledge tools "$2")" take-tool "$3"; wait_for "tool $3 in the hand" lies_there "${tools[$3]}"
    on_screen throw
}
# What is held and whether the tray is open, as the title says it behind the clay's height: ", rib, tools".
lies_there() { [ "$(title | sed -E 's/.* mm//; s/ .[0-9]+.$//')" = "$1" ]; }
# Rib, sponge and wire: the wall is faired and wiped, and a ring comes off the rim and back again, and off.
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
    top=$(clay_mm)  # as rib and sponge have left it
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
# By mouse, from an untouched lump to the next: a touch, a look into the clay, another screen, new clay.
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
    at choose target 0
    click "$x" $((height * 42 / 100))
    ;;
keys) press choose target 1 ;;
*) press choose free ;;
esac
on_screen throw
[ -z "${MEMORY:-}" ] || holds_no_more to_new_clay
# Somebody leans on the panel's edge, and will till the end.
[ "$hand" = touch ] && point palm 3 $((height * 6 / 10)) sleep 4
press_it
on_screen throw
if [ "$hand" = mouse ]; then  # all of it is taken back
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
    sleep 2
    on_screen throw
    press throw-look-in look-in
    sleep 2
    on_screen throw
fi
keep_the_pot
