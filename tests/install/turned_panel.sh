#!/usr/bin/env bash
# The start script turns the picture of a panel on its side, whichever cage the system has: turned_panel.sh BUILD FOLDER.
# Debian 12's cage 0.1.4 has an option for it and takes no wishes of clients; from 0.1.5 on it is the other way round. A
# system has one of them and no panel: cage and wlr-randr are stand-ins that say and do what those programs do.
set -euo pipefail
build=$1 folder=$2
fail() { printf '%s\n' "$*"; exit 1; }
rm -rf "$folder"
mkdir -p "$folder/programs"
folder=$(realpath "$folder")
DESTDIR=$folder/root cmake --install "$build" --prefix /usr --component kiosk >"$folder/log"
kiosk=$folder/root/usr/lib/onggi/kiosk
export PATH=$folder/programs:$PATH folder
# program NAME: makes a stand-in.
program() { cat >"$folder/programs/$1"; chmod +x "$folder/programs/$1"; }
program taskset <<'CODE'
#!/bin/sh
shift 2
exec "$@"
CODE
# Like cage's, its client inherits a pipe, whose number has two digits.
program cage <<'CODE'
#!/bin/bash
[ "$*" = -h ] && { cat "$folder/help"; exit; }
printf '%s ' "$@" >"$folder/words"
while [ "$1" != -- ]; do shift; done
shift
[ -e "$folder/pipe" ] || mkfifo "$folder/pipe"
if [ "$1" = "$folder/root/usr/lib/onggi/kiosk" ]; then "${@:1:3}" sleep 4; fi 19>"$folder/pipe" &
cat "$folder/pipe"
CODE
program wlr-randr <<'CODE'
#!/bin/sh
[ $# -eq 0 ] || { echo "$4" >"$folder/turned"; exit; }
printf 'HDMI-A-1 "A panel"\n  Enabled: yes\n  Transform: %s\nHDMI-A-2 "Off"\n  Enabled: no\n' "$(cat "$folder/turned")"
CODE
# start TURNS
start() {
    echo normal >"$folder/turned"
    ONGGI_QUARTER_TURNS=$1 timeout 60 "$kiosk" start >>"$folder/log" 2>&1
}
is_turned() {
    for _ in $(seq 100); do
        [ "$(cat "$folder/turned")" = "$1" ] && return
        sleep 0.1
    done
    fail "expected the picture to be turned by $1 degrees, found $(cat "$folder/turned")"
}

printf ' -r\t Rotate the output 90 degrees clockwise, specify up to three times\n' >"$folder/help"
start 3
[[ "$(cat "$folder/words")" = "-rrr -- "* ]] || fail "expected three quarter turns by option, found: $(cat "$folder/words")"
[ "$(cat "$folder/turned")" = normal ] || fail "expected no client that turns the picture"

printf ' -s\t Allow VT switching\n' >"$folder/help"
start 0
[[ "$(cat "$folder/words")" = "-- "*/usr/bin/onggi* && "$(cat "$folder/words")" != *turned* ]] ||
    fail "expected the wheel alone, found: $(cat "$folder/words")"
start 1 & compositor=$!
is_turned 90
echo normal >"$folder/turned"  # a display that was plugged in again
is_turned 90
# cage ends when each process has closed that pipe.
for process in $(pgrep -f "^/bin/bash $kiosk turned"); do
    [ ! -e "/proc/$process/fd/19" ] || fail "expected the watch to close the compositor's pipe"
done
wait "$compositor" || fail "expected the compositor to end after its client, found exit code $?"
grep -qx 'kiosk: turned the picture on HDMI-A-1 by 90 degrees' "$folder/log" || fail "expected a line in the log"
! grep -q 'HDMI-A-2' "$folder/log" || fail "expected an output that is off to be left alone"

# Without the program the wheel starts all the same.
mkdir "$folder/few"
for name in bash cat grep mkfifo nproc sleep timeout; do ln -s "$(command -v "$name")" "$folder/few"; done
rm "$folder/programs/wlr-randr"
PATH=$folder/programs:$folder/few start 1 || fail "expected the wheel to start without wlr-randr, found exit code $?"
grep -q '^kiosk: expected wlr-randr, found none' "$folder/log" || fail "expected a word about wlr-randr"
echo "the picture of a panel on its side is turned, also after the display was unplugged"
