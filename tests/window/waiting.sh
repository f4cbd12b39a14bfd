# How the scripts of this folder wait, and what they say when it was in vain. Sourced after display.sh, never run; the
# script puts the program's process into `kiosk` and its log into kiosk.log.
#
# They wait by the program's own sign of life, not by the clock: as a service manager's watchdog they are told that all is
# well ten times a second at most, and each time only if a frame was shown and a tick was done since the last time. Where
# a busy or slow machine shows few frames, signs are rare and the scripts wait accordingly longer.

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# A program that gives no sign of life and writes no line for so long hangs.
silence_s=$(scaled 60)

# listen_for_life: the signs of life of every program that is started from here on, each a byte in ./signs.
listen_for_life() {
    touch kiosk.log signs manager
    python3 "$here/signs_of_life.py" signs >manager &
    for _ in $(seq "$(scaled 300)"); do
        [ -s manager ] && break
        sleep 0.1
    done
    NOTIFY_SOCKET=$(cat manager)
    export NOTIFY_SOCKET WATCHDOG_USEC=400000  # told at a quarter of this
}
signs() { stat -c %s signs; }

# A person's hands and eyes are not slower where the machine is busy: where it may, the script goes before other programs,
# and starts the kiosk by `as_usual`, which does not.
renice -n -10 -p "$$" >/dev/null 2>&1 || true
as_usual=()
[ "$(nice)" -ge 0 ] || as_usual=("$(command -v nice)" -n "$((0 - $(nice)))")

# What the window says of what is seen in it.
title() { xdotool search --name '^Onggi' getwindowname 2>/dev/null | tail -1; }

fail() { printf '%s\n' "$*"; cat kiosk.log; exit 1; }

# keeps_living WHAT: fails where the program has ended, or hangs, while one waits for that.
last_life=
last_life_s=$SECONDS
keeps_living() {
    local life
    if ! kill -0 "$kiosk" 2>/dev/null; then
        local status=0
        wait "$kiosk" || status=$?
        fail "the program ended with exit code $status while waiting for $1"
    fi
    life="$(signs) $(stat -c %s kiosk.log)"
    [ "$life" = "$last_life" ] || last_life_s=$SECONDS
    last_life=$life
    [ $((SECONDS - last_life_s)) -le "$silence_s" ] ||
        fail "no $1, and no frame with a tick nor a line of the log for $silence_s s, found '$(title)'"
}

# within SIGNS WHAT COMMAND...: whether the command succeeds before the program has given that many signs of life.
within() {
    local what=$2 last=$(($(signs) + $1))
    shift 2
    last_life_s=$SECONDS
    until "$@" >/dev/null 2>&1; do
        [ "$(signs)" -le "$last" ] || return 1
        keeps_living "$what"
        sleep 0.1
    done
}
# wait_for WHAT COMMAND...: five minutes of a machine that shows all frames, because what works behind the picture, at the
# lowest priority, may get next to nothing of a busy one.
most_signs=3000
wait_for() { within "$most_signs" "$@" || fail "no $1, and the program goes on, found '$(title)'"; }
# pause SIGNS: until the program has given that many more; ten are a second at the least.
pause() { within "$1" "sign of life" false || true; }
