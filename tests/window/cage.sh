#!/usr/bin/env bash
# A visitor at the kiosk as in a museum: full screen in the compositor cage, through Xwayland, as a user who
# is not root, by a finger on a touch screen. cage.sh SCRIPT ONGGI PROGRAMS FOLDER [LANGUAGE]: SCRIPT is a
# visitor's script, such as visit.sh. cage's screen is a window on a display with a touch screen (1024x768,
# the default of wlroots); a touch passes through that server, cage and Xwayland to the kiosk. TURNED: the
# panel is mounted on its side, and the picture is turned by a quarter. When the kiosk ends, the compositor
# ends too. Exit code 77: no cage or no Xwayland.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
for program in cage Xwayland setpriv; do
    command -v "$program" >/dev/null || { echo "SKIPPED: no $program"; exit 77; }
done
source "$here/../support/display.sh"
size=1024x768
compositor=(cage --)
seen=$size
mkdir -p "$4"
results=$(realpath "$4")
# A folder that any user can read and the compositor's user can write.
folder=$(mktemp -d)
server=
trap 'kill $server 2>/dev/null || true; rm -rf "$folder"' EXIT
if [ -n "${TURNED:-}" ]; then
    seen=768x1024
    # As the start script does: cage 0.1.5 and later obey a client instead.
    if [[ "$(cage -h 2>&1)" = *$'\n -r\t'* ]]; then
        compositor=(cage -r --)
    else
        command -v wlr-randr >/dev/null || { echo "SKIPPED: no wlr-randr"; exit 77; }
        compositor=(cage -- bash "$folder/assets/install/kiosk.in" turned 90)
    fi
fi
cp -r "$2" "$here/../../assets" "$here" "$here/../support" "$folder"
mkdir "$folder/programs"
for program in screen_targets clay_places judge_session finger; do cp "$3/$program" "$folder/programs"; done
mkdir -m 700 "$folder/run"
mkdir "$folder/desk"
open_touch_display "$folder/desk" "$size"
as_visitor=()
if [ "$(id -u)" -eq 0 ]; then  # cage refuses
    chown -R nobody "$folder"
    as_visitor=(setpriv --reuid=nobody --regid=nogroup --clear-groups)
fi
# As in waiting.sh: visitor and panel are not slower on a busy machine.
renice -n -10 -p "$$" >/dev/null 2>&1 || true
status=0
"${as_visitor[@]}" env HOME="$folder" XDG_RUNTIME_DIR="$folder/run" ONGGI_ASSETS="$folder/assets" \
    LSAN_OPTIONS="suppressions=$folder/support/lsan.supp:print_suppressions=0" \
    WLR_BACKENDS=x11 WLR_RENDERER=pixman CAGED=1 TURNED="${TURNED:-}" TOUCH_SCREEN="$folder/desk/touch-screen" \
    "${compositor[@]}" bash "$folder/window/$1" "$folder/$(basename "$2")" "$folder/programs" "$folder/visit" touch "${5:-en}" "$seen" \
    >"$folder/cage.log" 2>&1 || status=$?
rm -rf "$results"
cp -r "$folder/visit" "$results"
# cage 0.1.4 ends with 0 however the program ended (findings/cage-exits-0-however-its-client-ended.sh): the line counts.
[ "$status" -eq 0 ] && grep '^kept by touch ' "$folder/cage.log" && exit
echo "cage ended with $status:"
cat "$folder/cage.log"
exit 1
