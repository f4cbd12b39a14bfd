#!/usr/bin/env bash
# A visitor whose pot collapses under the hand, on clay of realistic strength: failed_visit.sh ONGGI PROGRAMS
# FOLDER spacemouse [LANGUAGE [WIDTHxHEIGHT]], with visitor.sh's arguments. Undoes the collapse; collapses
# again; then takes new clay and keeps a pot. With a SpaceMouse, which puts a hand directly into the clay: the
# hands behind a pointer avoid a collapse.
set -euo pipefail
FORGIVING=false
source "$(dirname "${BASH_SOURCE[0]}")/visitor.sh"

gave_way() { [[ "$(title)" = "Onggi - failure"* ]]; }
# Moves the mouse beside the clay, where the SpaceMouse takes over, and moves the hand down and outwards.
come_low() {
    local x y
    read -r x y < <(echo "140 60" | "$programs/clay_places" "$width" "$height")
    xdotool mousemove "$x" "$y"
    pause 3
    hands push 400 0 150
    hands push 0 -200 150
    hands push 0 15 50
}
# Presses the foot in to the middle, and moves up and down there until the pot above is twisted off.
press_through() {
    come_low
    for _ in $(seq 60); do
        gave_way && break
        hands push -15 0 30
        gave_way && break
        hands push 0 6 12
        hands push 0 -6 12
    done
    on_screen failure
    hands push 400 0 150  # or it would collapse again
}
# Checks that the pot stands for this long; a collapse would be detected earlier.
stands_still() {
    within 30 "clay that stands" gave_way && fail "it collapsed again without a touch"
    on_screen throw
}

begin_visit
press choose free; on_screen throw
hands hold wheel  # a SpaceMouse's wheel starts with that button, pressed as long as by a thumb
hands rest 0.2
hands let-go wheel
press_through
press failure before-collapse; on_screen throw
stands_still
press_through
press failure new-clay; on_screen throw
stands_still
hand=mouse
throw_a_pot
on_screen throw
keep_the_pot
