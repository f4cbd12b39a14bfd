# A separate display for a test. Sourced, never run.

# scaled NUMBER: scales a number of seconds, or of checks of similar duration, to this machine
# (ONGGI_SLOWNESS, set by ctest).
scaled() { awk -v number="$1" -v slowness="${ONGGI_SLOWNESS:-1}" 'BEGIN { print int(number * slowness) }'; }

# serve_display FOLDER SERVER WORD...: starts an X server, waits until it listens and sets `server` (its
# process) and DISPLAY. Its output is in FOLDER. The server chooses a free display number; guessing one would
# race with other tests. Without -noreset it restarts whenever its last client leaves, and refuses a client
# that connects just then. The option keeps the memory of pictures: allocated for each frame, the three
# million pages of a visit cost a tenth of a core.
serve_display() {
    MALLOC_MMAP_THRESHOLD_=33554432 MALLOC_TRIM_THRESHOLD_=134217728 \
        "${@:2}" -displayfd 1 -noreset -nolisten tcp >"$1/display" 2>"$1/display.log" &
    server=$!
    for _ in $(seq "$(scaled 300)"); do
        [ -s "$1/display" ] && break
        sleep 0.1
    done
    [ -s "$1/display" ] || { echo "no display"; cat "$1/display.log"; return 1; }
    DISPLAY=:$(cat "$1/display")
    export DISPLAY
    unset WAYLAND_DISPLAY
}

# open_display FOLDER WxH [OPTION...]: Xvfb. FOLDER/Xvfb_screen0 is its picture, in xwd format.
open_display() { serve_display "$1" Xvfb -fbdir "$1" -screen 0 "${2}x24" "${@:3}"; }

# open_touch_display FOLDER WxH: the X server of a machine with a touch screen, rendered into memory
# (xserver-xorg-video-dummy), and with a pen. The screen is touched by `finger`, through the socket
# FOLDER/touch-screen, and the pen has FOLDER/pen: relative paths, because a socket's is short. With a named seat the server needs no terminal.
open_touch_display() {
    local folder wide=${2%x*} high=${2#*x}
    folder=$(realpath "$1")
    # A mode of any size, at 60 Hz; a blanking of 160 would count as reduced, which the monitor would have to
    # declare.
    local across=$((wide + 200)) down=$((high + 40))
    local mode="$((across * down * 60 / 1000000)) $wide $((wide + 50)) $((wide + 100)) $across $high $((high + 3)) $((high + 8)) $down"
    cat >"$folder/xorg.conf" <<CONF
Section "ServerFlags"
    Option "AutoAddDevices" "false"
    Option "AutoAddGPU" "false"
EndSection
Section "Monitor"
    Identifier "monitor"
    HorizSync 5-1000
    VertRefresh 5-200
    Modeline "$2" $mode
EndSection
Section "Device"
    Identifier "memory"
    Driver "dummy"
    VideoRam 65536
EndSection
Section "Screen"
    Identifier "screen"
    Device "memory"
    Monitor "monitor"
    DefaultDepth 24
    SubSection "Display"
        Modes "$2"
        Virtual $wide $high
    EndSubSection
EndSection
Section "InputDevice"
    Identifier "finger"
    Driver "inputtest"
    Option "SocketPath" "touch-screen"
    Option "DeviceType" "Touch"
    Option "TouchCount" "10"
EndSection
Section "InputDevice"
    Identifier "pen"
    Driver "inputtest"
    Option "SocketPath" "pen"
    Option "DeviceType" "PointerAbsoluteProximity"
    Option "PointerHasPressure" "true"
EndSection
Section "InputDevice"
    Identifier "keyboard"
    Driver "inputtest"
    Option "SocketPath" "keyboard"
    Option "DeviceType" "Keyboard"
EndSection
Section "ServerLayout"
    Identifier "desk"
    Screen "screen"
    InputDevice "finger" "CorePointer"
    InputDevice "pen" "SendCoreEvents"
    InputDevice "keyboard" "CoreKeyboard"
EndSection
CONF
    serve_display "$1" env -C "$folder" Xorg -config "$folder/xorg.conf" -seat touch -logfile "$folder/xorg.log"
}
