#!/usr/bin/env bash
# A visitor whose pot gives way under the hand, on clay that bears no more than clay does: failed_visit.sh ONGGI PROGRAMS
# FOLDER spacemouse [LANGUAGE [WIDTHxHEIGHT]], as visitor.sh says them. Back to just before, where it stands; once more;
# then new clay, and a pot of it that is kept. By a SpaceMouse, which puts a hand right into the clay: the skilled hands
# behind a pointer know better.
set -euo pipefail
FORGIVING=false
source "$(dirname "${BASH_SOURCE[0]}")/visitor.sh"

gave_way() { [[ "$(title)" = "Onggi - failure"* ]]; }
# The mouse beside the clay, where the SpaceMouse takes the hand over; and the hand low down, as far out as it goes.
come_low() {
    local x y
    read -r x y < <(echo "140 60" | "$programs/clay_places" "$width" "$height")
    xdotool mousemove "$x" "$y"
    pause 3
    hands push 400 0 150
    hands push 0 -200 150
    hands push 0 15 50
}
# Presses the foot in to the middle, and stays there up and down until what stands on it is twisted off.
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
    hands push 400 0 150  # or it would give way again
}
# For so long it stands, or what gave way would be found out again.
stands_still() {
    within 30 "clay that stands" gave_way && fail "it gave way again, and nobody had touched it"
    on_screen throw
}

begin_visit
press choose free; on_screen throw
hands hold wheel  # under a SpaceMouse it rests until that button is pressed, for as long as a thumb takes
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
