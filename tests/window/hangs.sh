#!/usr/bin/env bash
# Tests how the scripts of this folder detect a program that hangs: hangs.sh ONGGI FOLDER. A real kiosk is
# stopped, runs without doing what is awaited, and dies; each must be detected and reported correctly.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
source "$(dirname "${BASH_SOURCE[0]}")/waiting.sh"
onggi=$1
work_in "$2"
open_display . 640x360
listen_for_life
"${as_usual[@]}" "$onggi" kiosk --size 640x360 --device mouse --volume 0 --gallery gallery >>kiosk.log 2>&1 &
kiosk=$!
wait_for "window" xdotool search --name '^Onggi - attract$'
pause 5

# finds_out WORDS COMMAND...: the command must fail the script with these words.
finds_out() {
    local words=$1 status=0
    shift
    ("$@") >found_out.log 2>&1 || status=$?
    [ "$status" -eq 1 ] && grep -q "$words" found_out.log ||
        fail "expected exit code 1 and '$words' of $*, found $status and $(head -1 found_out.log)"
}
most_signs=50
finds_out "no pot, and the program goes on, found 'Onggi - attract'" wait_for "pot" false
kill -STOP "$kiosk"
silence_s=5
finds_out "no pot, and no frame with a tick nor a line of the log for 5 s" wait_for "pot" false
kill -CONT "$kiosk"
pause 5
kill -KILL "$kiosk"
finds_out "the program ended with exit code" wait_for "pot" false
echo "a program that hangs is found out"
