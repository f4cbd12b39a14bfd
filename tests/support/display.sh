# A display of a test's own. Sourced, never run.

# open_display FOLDER WxH: starts Xvfb, waits until it listens and sets `server` (its process) and DISPLAY. What it says
# lies in FOLDER, and in FOLDER/Xvfb_screen0 what it shows, as xwd writes it. The server itself picks a free number and tells it; guessing one would race with other tests. Without
# -noreset it starts anew whenever its last client leaves, and turns away who comes just then.
open_display() {
    Xvfb -displayfd 1 -noreset -fbdir "$1" -screen 0 "${2}x24" -nolisten tcp >"$1/display" 2>"$1/display.log" &
    server=$!
    for _ in $(seq 300); do
        [ -s "$1/display" ] && break
        sleep 0.1
    done
    [ -s "$1/display" ] || { echo "no display after half a minute"; cat "$1/display.log"; return 1; }
    DISPLAY=:$(cat "$1/display")
    export DISPLAY
    unset WAYLAND_DISPLAY
}
