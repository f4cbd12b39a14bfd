#!/usr/bin/env bash
# A visitor at the window who makes a moon jar, from attract to the shelf: two bowls, joined; the seam;
# decorated, glazed, kept. jar.sh ONGGI PROGRAMS FOLDER [HAND [LANGUAGE [WIDTHxHEIGHT]]], with visitor.sh's
# arguments.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/visitor.sh"

# The layout's names: with one switch there are more targets on the ledge.
scan=
[ "$hand" = switch ] && scan=-scan
is_a_lump() { [ "$(clay_mm)" -le 55 ]; }
is_a_jar() { [ "$(clay_mm)" -ge 120 ]; }

# Follows the dots of half a museum's jar, outwards and up; keys and one switch pull up what the demonstrating
# hands have shown.
draw_bowl() { stroke 3 "34 2" "57 21" "74 43" "83 69" "86 90" "87 98"; }
throw_a_bowl() {
    case $hand in
    mouse | touch)
        press_it
        open_it
        draw_bowl
        draw_bowl
        work_until "a bowl of 84 mm" "stands 84" draw_bowl
        ;;
    *) throw_a_pot ;;
    esac
}

begin_visit
press choose shelf-next; on_screen choose
pause 20  # time to look at the next page, whose title is the same
# The jar is the fourth museum's pot on the shelf, whose next page begins with the first unseen pot.
seen=$(grep -c '^choose target ' targets)
press choose-next target "$(awk '$1 == "choose-next" && $2 == "target" { print $3 }' targets | sed -n "$((4 - seen))p")"
on_screen jar-start
press jar-start begin; on_screen throw
throwing=jar-first$scan
throw_a_bowl
first_mm=$(clay_mm)
press "$throwing" done
wait_for "new clay" is_a_lump
on_screen throw  # the first bowl beside the wheel
pause 70         # time to look at it
throw_a_bowl
on_screen throw
clay_top=$((first_mm + $(clay_mm)))  # the camera moves back for both, and stays there
press "$throwing" done; on_screen join
press jar-join$scan hand-right; on_screen join
press jar-join$scan join-bowls
wait_for "both as one" is_a_jar
throwing=jar-seam$scan
on_screen throw
case $hand in mouse | touch | keys) draw_along "$(clay_mm)" ;; esac
on_screen throw
keep_the_pot
for bowl in 1 2; do
    [ -s "$pot/bowl-$bowl.onggi" ] || fail "expected $pot/bowl-$bowl.onggi, found none"
    "$onggi" replay "$pot/bowl-$bowl.onggi" --validate || fail "the bowl's session does not replay"
done
