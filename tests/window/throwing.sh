#!/usr/bin/env bash
# How a visitor throws, with any device: following the screen's instructions, at a person's pace, until the
# clay has the wanted shape, however busy the machine is. Sourced by visitor.sh, never run. clay_places
# converts positions on the wheel to pixels; a finger or mouse misses them by some pixels, the same every
# time.

strokes=0
clay_top=  # the clay's height in mm, if the camera has moved back for it

# The state of the clay from the window's title: lesson steps done, height.
steps_done() { title | sed -nE 's/^Onggi - throw - ([0-3]) of 3, .*/\1/p'; }
clay_mm() {
    wait_for "sight of the clay" has_done 0
    title | sed -nE 's/^Onggi - throw - [0-3] of 3, ([0-9]+) mm.*/\1/p'
}
# Conditions, for work_until.
has_done() { [ "$(steps_done)" -ge "$1" ] 2>/dev/null; }
stands() { [ "$(clay_mm)" -ge "$1" ] 2>/dev/null; }
is_at_rest() { [[ "$(title)" != *", shown"* ]]; }
# so_soon CONDITION...: waits briefly, since the screen lags behind the clay, and hands behind a finger.
so_soon() { within 15 "$*" "$@"; }
# work_until WHAT CONDITION MOVE...: repeats the move until the condition holds.
work_until() {
    local what=$1 so=$2
    shift 2
    for _ in $(seq 12); do
        "$@"
        # shellcheck disable=SC2086  # a condition and its number
        so_soon $so && return
    done
    fail "expected $what after twelve tries, found '$(title)'"
}

# stroke SECONDS PLACE PLACE...: a finger lands at the first place, "RADIUS HEIGHT" in mm, moves on to the
# others, and stays for a moment, so that the hands follow.
stroke() {
    local seconds=$1 way
    shift
    strokes=$((strokes + 1))
    # shellcheck disable=SC2086  # no word where nothing is low, or high
    way=$(printf '%s\n' "$@" | "$programs/clay_places" "$width" "$height" $reach $clay_top |
        awk -v seconds="$seconds" -v seed="$strokes" -v hand="$hand" -v short="$((width < height ? width : height))" '
            function miss(   sum, i) {  # four pixels of 720, varying between people
                for (i = 0; i < 12; i++) sum += rand()
                return (sum - 6) * 4 * short / 720
            }
            { x[NR] = $1; y[NR] = $2 }
            END {
                srand(seed)
                for (i = 0; i < 5; i++) rand()
                first_x = miss(); first_y = miss(); last_x = miss(); last_y = miss()
                for (i = 2; i <= NR; i++)
                    along[i] = along[i - 1] + sqrt((x[i] - x[i - 1]) ^ 2 + (y[i] - y[i - 1]) ^ 2)
                steps = int(seconds / 0.03)
                for (step = 0; step <= steps; step++) {
                    u = step / steps
                    share = u * u * (3 - 2 * u)  # hands start and stop softly
                    for (i = 2; i < NR && along[i] < share * along[NR]; i++) continue
                    part = (share * along[NR] - along[i - 1]) / (along[i] - along[i - 1])
                    printf "mousemove %d %d ", x[i - 1] + (x[i] - x[i - 1]) * part + first_x * (1 - share) + last_x * share,
                        y[i - 1] + (y[i] - y[i - 1]) * part + first_y * (1 - share) + last_y * share
                    if (step == 0) printf hand == "touch" ? "mousedown 1 " : "sleep 0.2 mousedown 1 "
                    printf "sleep 0.03 "
                }
                print "sleep 0.5 mouseup 1"
            }')
    # shellcheck disable=SC2086  # its words are many
    point $way
}
# hands WORDS: sends a command to hands_at or finger, and waits until it is done.
hands() {
    local answer= piece=
    echo "$*" >&8
    # A line may arrive in pieces.
    until read -r -t 1 piece <&9; do
        [ $? -gt 128 ] || break  # the helper has ended
        answer+=$piece
        keeps_living "hand that does $*"
    done
    answer+=$piece
    [ "$answer" = "done" ] || fail "expected the $hand to $*, found '$answer'"
}
# pad_to RADIUS HEIGHT: with a gamepad, moves off the clay to the farthest position, which is reliably known,
# and from there to a place.
pad_to() {
    hands push 600 0 160
    hands push 0 -600 160
    hands push $(($1 - 260)) 0 100
    hands push 0 "$2" 100
}
keys() {
    local key
    for key in "$@"; do xdotool key "$key" sleep 0.12; done
}
# One switch: lets the demonstrating hands do the next step, and waits until they rest.
do_this_step() {
    at "$throwing" show-me
    take "$place"
    so_soon eval '! is_at_rest' || true
    wait_for "hands that have done it" is_at_rest
}

# draw_along TOP LEDGE: moves the held tool up along the wall; LEDGE is the ledge shown then.
draw_along() {
    local low=$(($1 * 3 / 10)) high=$(($1 * 8 / 10))
    case $hand in
    mouse | touch | pen) stroke 2 "45 $low" "45 $high" ;;
    keys) keys Left; pause 5; keys Up Left ;;
    switch) press "$2" hand-left; press "$2" hand-up ;;
    esac
}

# The moves of the lesson. The clay's height is visible to every visitor.
press_in() {
    local low=$(($(clay_mm) * 3 / 10))
    case $hand in
    mouse | touch | pen) stroke 1.5 "66 $low" "50 $low" ;;
    keys) keys Left; pause 5 ;;
    switch) do_this_step ;;
    gamepad)
        pad_to 75 "$low"
        hands hold a
        hands push -22 0 20
        hands rest 0.4
        hands let-go a
        ;;
    esac
}
open_the_middle() {
    local top
    top=$(clay_mm)
    case $hand in
    mouse | touch | pen) stroke 2 "0 $((top + 1))" "0 $((top - 35))" ;;
    keys)  # up the wall and over the rim; stays there if it is there already
        keys Up Up Up Up Up Up Up Up Up Up Up Up Up Up
        keys Down Down Down
        pause 5
        ;;
    switch) do_this_step ;;
    gamepad)
        pad_to 0 $((top + 15))
        hands hold a
        hands push 0 -50 25
        hands rest 0.5
        hands let-go a
        ;;
    esac
}
# No higher than the camera can show without moving back.
draw_up() {
    local top to
    top=$(clay_mm)
    to=$((top + 35 < 138 ? top + 35 : 138))
    case $hand in
    mouse | touch | pen) stroke 2.5 "58 $((top / 4))" "56 $top" "55 $to" ;;
    keys) keys Up Up Up; pause 8 ;;
    switch)
        if has_done 3; then
            at "$throwing" hand-up
            take "$place"
            for _ in 1 2; do sleep 0.9; xdotool key space; done  # the ring stays where it is pressed, so press again
        else
            do_this_step
        fi
        ;;
    gamepad)
        pad_to 62 $((top / 4))
        hands hold trigger
        hands push -4 $((to - top / 4)) 45
        hands rest 0.6
        hands let-go trigger
        ;;
    esac
}
# The whole lesson.
press_it() { work_until "clay that was pressed in" "has_done 1" press_in; }
open_it() { work_until "clay that is open" "has_done 2" open_the_middle; }
raise_it() {
    if [ "$hand" = keys ]; then keys Right; fi  # from the middle to the rim
    work_until "a wall that was drawn up" "has_done 3" draw_up
    work_until "a wall of 95 mm" "stands 95" draw_up
}
throw_a_pot() { press_it; open_it; raise_it; }
