#!/usr/bin/env bash
# A visitor whose pot gives way under the hand, on clay that bears no more than clay does: failed_visit.sh ONGGI TARGETS
# FOLDER [HAND [LANGUAGE]], HAND mouse or keys, as visitor.sh says them. Back to just before, where it stands; once more;
# then new clay, and a pot of it that is kept.
set -euo pipefail
FORGIVING=false
source "$(dirname "${BASH_SOURCE[0]}")/visitor.sh"

gave_way() { [[ "$(title)" = "Onggi - failure"* ]]; }
# Presses the foot in from the right to the middle, and stays there up and down until what stands on it is twisted off.
press_through() {
    local from=$((width * 59 / 100)) to=$((width * 501 / 1000)) level=$((height * clay_level / 100))
    local off x
    if [ "$hand" = mouse ]; then
        xdotool mousemove "$from" "$level" sleep 0.2 mousedown 1
        for x in $(seq "$from" -3 "$to"); do
            xdotool mousemove "$x" "$level" sleep 0.05
        done
    else
        for _ in $(seq 13); do xdotool key Left sleep 0.2; done
    fi
    for _ in $(seq 60); do
        gave_way && break
        if [ "$hand" = mouse ]; then
            for off in 6 12 6 0 -6 0; do
                xdotool mousemove "$to" $((level + off * height / 720)) sleep 0.05
            done
        else
            xdotool key Up sleep 0.15 key Down sleep 0.15
        fi
    done
    [ "$hand" = mouse ] && xdotool mouseup 1
    on_screen failure
}
# For so long it stands, or what gave way would be found out again.
stands() {
    for _ in $(seq 30); do
        gave_way && fail "it gave way again, and nobody had touched it"
        sleep 0.1
    done
    on_screen throw
}

begin_visit
press choose free; on_screen throw
press_through
press failure before-collapse; on_screen throw
stands
press_through
press failure new-clay; on_screen throw
stands
press_in
sleep 0.5
on_screen throw
keep_the_pot 51 75  # clay that is pressed through is higher
