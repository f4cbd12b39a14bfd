#!/usr/bin/env bash
# Package: libinput10 1.22.1-1+deb12u1 (Debian 12; 1.28.1 of Debian 13 does the same), on a made-up pen tablet.
# Behaviour: of a pen whose tilt runs from -60 to 60 and says no unit, as many tablets do, a tilt of 60 is told as 64 degrees
# and one of 30 as 32: the range is taken to be 128 degrees wide. Where the axis says its unit, 57 a radian, 60 is told as 60.3.
# Expected: degrees as they come, since such an axis is one of whole degrees.
# Why it matters: a drawn hand or a tool lies flatter than the pen, and a pen that is calibrated on one tablet is off on the next.
# Show the tilt; measure nothing by it.
# Seen:
#   without a unit: 64.0 and 32.0; with it: 60.3 and 30.2
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
cat >tilt.c <<'CODE'
#include "made_up_input.h"
int main(int count, char** words) {
    const int a_radian = count > 1 ? atoi(words[1]) : 0;
    kind = "ID_INPUT_TABLET";
    has_key(BTN_TOOL_PEN), has_key(BTN_TOUCH), has_key(BTN_STYLUS);
    has_axis(ABS_X, 0, 20000, 100), has_axis(ABS_Y, 0, 10000, 100), has_axis(ABS_PRESSURE, 0, 1000, 0);
    has_axis(ABS_TILT_X, -60, 60, a_radian), has_axis(ABS_TILT_Y, -60, 60, a_radian);
    struct libinput* input = begin();
    say(EV_KEY, BTN_TOOL_PEN, 1), say(EV_ABS, ABS_X, 5000), say(EV_ABS, ABS_Y, 5000);
    say(EV_ABS, ABS_TILT_X, 60), say(EV_ABS, ABS_TILT_Y, 30), end_of_report();
    struct libinput_event* event = next(input, LIBINPUT_EVENT_TABLET_TOOL_PROXIMITY);
    if (event == NULL) return 2;
    struct libinput_event_tablet_tool* pen = libinput_event_get_tablet_tool_event(event);
    printf("%.1f and %.1f", libinput_event_tablet_tool_get_tilt_x(pen), libinput_event_tablet_tool_get_tilt_y(pen));
    return 0;
}
CODE
gcc -rdynamic -Iusr/include -I"$here" tilt.c -o tilt "$libraries/libinput.so.10" -Wl,--unresolved-symbols=ignore-in-shared-libs
run() { LIBINPUT_QUIRKS_DIR=$PWD/usr/share/libinput LD_LIBRARY_PATH=$libraries ./tilt "$@" 2>/dev/null; }
saw="without a unit: $(run); with it: $(run 57)"
echo "saw: $saw"
[ "$saw" = "without a unit: 64.0 and 32.0; with it: 60.3 and 30.2" ]
