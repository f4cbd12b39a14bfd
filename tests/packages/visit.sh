#!/usr/bin/env bash
# A visitor by a finger at the installed kiosk, which runs in its root under cage, as the unit starts and stops it. cage's
# screen is a window on a display with a touch screen (1024x768, the default of wlroots). Display and visitor stay outside
# the root: cage and the visitor's tools reach their X servers by abstract sockets. TURNED: the panel is mounted on its side.
# visit.sh keep|begin|resume BUILD ROOT FOLDER: keep: up to a kept pot; begin: until the clay is open, then
# stops the service; resume: continues from there.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
what=$1 build=$2 root=$3
source "$here/root.sh"
source "$here/../support/display.sh"

# The display that the compositor gave the kiosk; there is one in this namespace. A process may end during the
# search.
display_of_kiosk() {
    local process display
    for process in $(pgrep --exact onggi); do
        display=$(tr '\0' '\n' 2>/dev/null <"/proc/$process/environ" | sed -n 's/^DISPLAY=//p') || continue
        [ -z "$display" ] || { echo "$display"; return; }
    done
    return 1
}
has_display() { DISPLAY=$(display_of_kiosk 2>/dev/null); }

# Replaces visitor.sh's open_kiosk: uses the start script, with the settings in /etc/onggi.
open_installed() {
    # RuntimeDirectory= and its mode.
    in_root install -d -o onggi -g onggi -m 0700 /run/onggi
    owner=$(in_root id -u onggi)
    chown "$owner" .
    (as_service NOTIFY_SOCKET="$NOTIFY_SOCKET" WATCHDOG_USEC="$WATCHDOG_USEC" DISPLAY="$panel" WLR_BACKENDS=x11 \
        WLR_RENDERER=pixman ONGGI_QUARTER_TURNS="${TURNED:-0}" /usr/lib/onggi/kiosk start) >>kiosk.log 2>&1 &
    kiosk=$!
    ln -sfn "$root/var/lib/onggi/gallery" gallery
    wait_for "display" has_display
    export DISPLAY
}
# The kiosk is locked: no key ends it, systemd does.
end_installed() {
    (as_service MAINPID="$kiosk" /usr/lib/onggi/kiosk stop)
}
installed_onggi() {
    local words=("$@") at
    for at in "${!words[@]}"; do words[at]=${words[at]/#gallery\//\/var\/lib\/onggi\/gallery\/}; done
    in_root onggi "${words[@]}"
}

# `onggi doctor` may report only a missing sound card and what a container refuses.
look_for_lacks() {
    local lacks
    (as_service DISPLAY="$DISPLAY" onggi doctor) | tee doctor.txt
    lacks=$(grep '^lacking' doctor.txt | grep -vE \
        -e '^lacking  sound      expected a sound card or a sound server, found neither' \
        -e '^lacking  real time  .* was refused: (Operation not permitted|Cannot allocate memory|No such file or directory)' || true)
    [ -z "$lacks" ] || fail "expected a doctor who lacks a sound card at most, found: $lacks"
    grep -q '^good     display' doctor.txt || fail "expected a display"
}

# The status for the museum's monitoring, as a user in the group onggi.
is_well() { chroot --userspec=65533:"$(in_root id -g onggi)" "$root" onggi status --json >status.json; }

# Xwayland accepts clients with its owner's user id.
as_owner() { setpriv --reuid="$owner" --regid="$owner" --clear-groups "$@"; }
xdotool() { as_owner xdotool "$@"; }
! command -v import >/dev/null || import() { as_owner import "$@"; }

mkdir -p "$4-desk"
open_touch_display "$4-desk" 1024x768
panel=$DISPLAY panel_server=$server
export CAGED=1 TOUCH_SCREEN=../$(basename "$4")-desk/touch-screen
OPENS=open_installed ENDS=end_installed
set -- installed_onggi "$build/tests" "$4" touch en "$([ -n "${TURNED:-}" ] && echo 768x1024 || echo 1024x768)"
source "$here/../window/visitor.sh"
server=$panel_server  # visitor.sh ends it
case $what in
keep)
    begin_visit
    look_for_lacks
    wait_for "heartbeat of a wheel that is well" is_well
    press choose free; on_screen throw
    throw_a_pot
    on_screen throw
    keep_the_pot
    ;;
begin)
    begin_visit
    press choose free; on_screen throw
    press_it
    open_it
    on_screen throw
    end_kiosk
    wait "$kiosk" || fail "the kiosk ended with exit code $?"
    grep -q . gallery/state/visit-* || fail "expected the visit to wait, found nothing"
    echo "stopped in the middle of a visit, which waits"
    ;;
resume)
    pick_it_up
    end_kiosk
    wait "$kiosk" || fail "the kiosk ended with exit code $?"
    echo "picked up where it was left"
    ;;
esac
