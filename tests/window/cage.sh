#!/usr/bin/env bash
# The kiosk as a museum starts it: full screen in the compositor cage, through Xwayland, as a user who is not root. Without
# a screen: wlroots' headless back end is one of 1280x720. cage.sh ONGGI PROGRAMS FOLDER. A visitor comes to the wheel and
# works the clay; then the kiosk is asked to end, and the compositor ends with it. 77: there is no cage, or no Xwayland.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
if [ -z "${CAGED:-}" ]; then
    for program in cage Xwayland setpriv; do
        command -v "$program" >/dev/null || { echo "SKIPPED: no $program"; exit 77; }
    done
    mkdir -p "$3"
    results=$(realpath "$3")
    # Where any user may read, and the compositor's may write.
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    cp -r "$1" "$here/../../assets" "$here" "$here/../support" "$folder"
    mkdir "$folder/programs"
    cp "$2/screen_targets" "$2/clay_places" "$folder/programs"
    mkdir -m 700 "$folder/run"
    as_visitor=()
    if [ "$(id -u)" -eq 0 ]; then  # cage refuses
        chown -R nobody "$folder"
        as_visitor=(setpriv --reuid=nobody --regid=nogroup --clear-groups)
    fi
    status=0
    timeout 300 "${as_visitor[@]}" env -u DISPLAY -u WAYLAND_DISPLAY CAGED="$folder" HOME="$folder" \
        XDG_RUNTIME_DIR="$folder/run" ONGGI_ASSETS="$folder/assets" \
        LSAN_OPTIONS="suppressions=$folder/support/lsan.supp:print_suppressions=0" \
        WLR_BACKENDS=headless WLR_LIBINPUT_NO_DEVICES=1 WLR_RENDERER=pixman \
        cage -- bash "$folder/window/cage.sh" "$folder/$(basename "$1")" "$folder/programs" "$folder/visit" \
        >"$folder/cage.log" 2>&1 || status=$?
    rm -rf "$results"
    cp -r "$folder/visit" "$results"
    # Of a program that a signal ended cage says nothing; of others it gives the exit code on.
    [ "$status" -eq 0 ] && grep '^caged visit: ' "$folder/cage.log" && exit
    echo "cage ended with $status:"
    cat "$folder/cage.log"
    exit 1
fi

FULL_SCREEN=true
source "$here/visitor.sh"
begin_visit
geometry=$(xdotool search --name '^Onggi' getwindowgeometry --shell | grep -E '^(X|Y|WIDTH|HEIGHT)=' | tr '\n' ' ')
[ "$geometry" = "X=0 Y=0 WIDTH=$width HEIGHT=$height " ] || fail "expected the whole screen, found $geometry"
press choose free; on_screen throw
press_it
on_screen throw
kill -TERM "$kiosk"
status=0
wait "$kiosk" || status=$?
[ "$status" -eq 0 ] || fail "the kiosk ended with exit code $status"
grep -q . gallery/state/visit-* || fail "expected the visit to wait for the next one, found nothing"
echo "caged visit: from attract to the wheel, $shot pictures"
