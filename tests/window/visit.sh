#!/usr/bin/env bash
# A visitor at the window, from attract to a kept pot: visit.sh ONGGI TARGETS FOLDER [HAND [LANGUAGE [WIDTHxHEIGHT]]], as
# visitor.sh says them.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/visitor.sh"

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
press_in
sleep 0.5
on_screen throw
# Clay that was pressed in low down stands higher; a lump that nobody touched is 49.6 mm high, and one from which the
# touch was taken back.
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
keep_the_pot "$least_mm" "$most_mm"
