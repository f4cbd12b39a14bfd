# How the scripts of this folder wait, and how they report a timeout. Sourced after display.sh, never run; the
# script sets `kiosk` to the program's process and writes its log to kiosk.log.
#
# They count the program's own signs of life, not seconds: like a service manager's watchdog they get at most
# ten pings a second, each only if a frame was shown and a tick was done since the last one. On a busy or slow
# machine with few frames, signs are rare and the scripts wait accordingly longer.

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# A program without a sign of life and without output for this long hangs.
silence_s=$(scaled 60)

# work_in FOLDER: makes the folder empty and current. `kiosk` and `server` are killed when the script ends.
work_in() {
    rm -rf "$1"
    mkdir -p "$1"
    cd "$1"
    kiosk=
    server=
    trap 'kill -KILL $kiosk $server 2>/dev/null || true' EXIT
}

# listen_for_life: records the signs of life of every program started from here on, one byte each in ./signs.
listen_for_life() {
    touch kiosk.log signs manager
    python3 "$here/signs_of_life.py" signs >manager &
    for _ in $(seq "$(scaled 300)"); do
        [ -s manager ] && break
        sleep 0.1
    done
    NOTIFY_SOCKET=$(cat manager)
    export NOTIFY_SOCKET WATCHDOG_USEC=400000  # pings come at a quarter of this
}
signs() { stat -c %s signs; }

# A person is not slower on a busy machine: if allowed, the script runs at higher priority, and starts the
# kiosk at normal priority by `as_usual`.
renice -n -10 -p "$$" >/dev/null 2>&1 || true
as_usual=()
[ "$(nice)" -ge 0 ] || as_usual=("$(command -v nice)" -n "$((0 - $(nice)))")

# The window's title, which describes its content.
title() { xdotool search --name '^Onggi' getwindowname 2>/dev/null | tail -1; }

fail() { printf '%s\n' "$*"; cat kiosk.log; exit 1; }

# keeps_living WHAT: fails if the program has ended or hangs during the wait for WHAT.
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
# wait_for WHAT COMMAND...: five minutes on a machine that shows all frames, because work behind the picture,
# at the lowest priority, may get almost no time on a busy one.
most_signs=3000
wait_for() { within "$most_signs" "$@" || fail "no $1, and the program goes on, found '$(title)'"; }
# pause SIGNS: waits until the program has given that many more; ten take at least a second.
pause() { within "$1" "sign of life" false || true; }
