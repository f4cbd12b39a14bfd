#!/usr/bin/env bash
# Package: libinput10 1.22.1-1+deb12u1 (Debian 12; 1.28.1 of Debian 13 does the same), on a made-up mouse.
# Behaviour: of a mouse without a middle button the press of either button is told 50 ms late, the release at once: it waits
# whether the other button follows, since both together count as the middle one, unasked. With a third button: at once.
# Expected: an event a report, as it comes; what both buttons mean is for the program to say.
# Why it matters: a kiosk's trackball or button box has two buttons, and every press, a beat of the drum or a touch of the clay,
# is 50 ms older than it looks. Buy three buttons, or turn it off (Xorg: MiddleEmulation; sway: middle_emulation).
# Seen:
#   two buttons: 40 to 80 ms late; three: under 20 ms
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=1.22.1-1+deb12u1
apt-get -qq -o APT::Sandbox::User=root download "libinput10=$version" "libinput-bin=$version" "libinput-dev=$version" \
    libevdev2=1.13.0+dfsg-1 libmtdev1=1.1.6-1 libwacom9=2.6.0-1 libwacom-common=2.6.0-1 libgudev-1.0-0=237-2
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
printf 'struct udev;\nstruct udev_device;\n' >usr/include/libudev.h
cat >press.c <<'CODE'
#include "made_up_input.h"
int main(int count, char** words) {
    (void)words;
    kind = "ID_INPUT_MOUSE";
    has_key(BTN_LEFT), has_key(BTN_RIGHT), has_move(REL_X), has_move(REL_Y);
    if (count > 1) has_key(BTN_MIDDLE);
    struct libinput* input = begin();
    const double pressed_ms = now_ms();
    say(EV_KEY, BTN_LEFT, 1), end_of_report();
    if (next(input, LIBINPUT_EVENT_POINTER_BUTTON) == NULL) return 2;
    const double late_ms = now_ms() - pressed_ms;
    fprintf(stderr, "%.1f ms\n", late_ms);
    puts(late_ms < 20 ? "under 20 ms" : late_ms > 40 && late_ms < 80 ? "40 to 80 ms late" : "another time");
    return 0;
}
CODE
gcc -rdynamic -Iusr/include -I"$here" press.c -o press "$libraries/libinput.so.10" -Wl,--unresolved-symbols=ignore-in-shared-libs
run() { LIBINPUT_QUIRKS_DIR=$PWD/usr/share/libinput LD_LIBRARY_PATH=$libraries ./press "$@" 2>/dev/null; }
saw="two buttons: $(run); three: $(run middle)"
echo "saw: $saw"
[ "$saw" = "two buttons: 40 to 80 ms late; three: under 20 ms" ]
