# How the scripts of this folder wait, and what they say when it was in vain. Sourced, never run; whoever calls has put
# the process into `kiosk` and its words into kiosk.log.

# What the window says of what is seen in it.
title() { xdotool search --name '^Onggi' getwindowname 2>/dev/null | tail -1; }

fail() { printf '%s\n' "$*"; cat kiosk.log; exit 1; }

# wait_for WHAT COMMAND...: up to a minute, or patience_s; a software driver under a sanitizer takes ten seconds to its
# first frame.
wait_for() {
    local what=$1 most_s=${patience_s:-60}
    shift
    for _ in $(seq $((10 * most_s))); do
        "$@" >/dev/null 2>&1 && return
        if ! kill -0 "$kiosk" 2>/dev/null; then
            local status=0
            wait "$kiosk" || status=$?
            fail "the program ended with exit code $status while waiting for $what"
        fi
        sleep 0.1
    done
    fail "no $what after $most_s s, found '$(title)'"
}
