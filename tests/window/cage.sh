#!/usr/bin/env bash
# A visitor at the kiosk as a museum starts it: full screen in the compositor cage, through Xwayland, as a user who is not
# root, by a finger on a touch screen. cage.sh SCRIPT ONGGI PROGRAMS FOLDER [LANGUAGE]: SCRIPT is a visitor's, as visit.sh.
# cage's screen is a window of the display of a desk that has a touch screen (1024x768: what wlroots opens there); a touch
# goes through that server, cage and Xwayland to the kiosk. TURNED: it hangs on its side, and the picture is turned by a
# quarter. When the kiosk is asked to end, the compositor ends with it.
# 77: there is no cage, or no Xwayland.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
for program in cage Xwayland setpriv; do
    command -v "$program" >/dev/null || { echo "SKIPPED: no $program"; exit 77; }
done
source "$here/../support/display.sh"
size=1024x768
turned=
seen=$size
if [ -n "${TURNED:-}" ]; then
    turned=-r
    seen=768x1024
fi
mkdir -p "$4"
results=$(realpath "$4")
# Where any user may read, and the compositor's may write.
folder=$(mktemp -d)
server=
trap 'kill $server 2>/dev/null || true; rm -rf "$folder"' EXIT
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
# As in waiting.sh: a visitor, and a real panel, are not slower where the machine is busy.
renice -n -10 -p "$$" >/dev/null 2>&1 || true
status=0
"${as_visitor[@]}" env HOME="$folder" XDG_RUNTIME_DIR="$folder/run" ONGGI_ASSETS="$folder/assets" \
    LSAN_OPTIONS="suppressions=$folder/support/lsan.supp:print_suppressions=0" \
    WLR_BACKENDS=x11 WLR_RENDERER=pixman CAGED=1 TURNED="${TURNED:-}" TOUCH_SCREEN="$folder/desk/touch-screen" \
    cage $turned -- bash "$folder/window/$1" "$folder/$(basename "$2")" "$folder/programs" "$folder/visit" touch "${5:-en}" "$seen" \
    >"$folder/cage.log" 2>&1 || status=$?
rm -rf "$results"
cp -r "$folder/visit" "$results"
# Of a program that a signal ended cage says nothing; of others it gives the exit code on.
[ "$status" -eq 0 ] && grep '^kept by touch ' "$folder/cage.log" && exit
echo "cage ended with $status:"
cat "$folder/cage.log"
exit 1
