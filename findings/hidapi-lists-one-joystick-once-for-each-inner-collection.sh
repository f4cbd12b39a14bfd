#!/usr/bin/env bash
# Package: libhidapi-hidraw0, libhidapi-dev 0.13.1-1, simulated by umockdev 0.17.16-1 (Debian 12).
# Behaviour: hid_enumerate returns an entry for each collection of a report descriptor, also for those inside another one:
# a force-feedback joystick with one application collection and three in it is listed four times with one path. Of the
# entries only the first has the joystick's usage; the rest have those of their parts (pointer, effect, parameters).
# Expected: an entry for each top-level collection, as on Windows, where the list comes from those; here one.
# Why it matters: "two devices found, take the second" takes the same stick, a count of devices is wrong, and a program
# that opens each entry opens the device many times. Keep one entry a path.
# Seen:
#   entries 4, paths 1, joysticks 1
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download libhidapi-hidraw0=0.13.1-1 libhidapi-dev=0.13.1-1 \
    umockdev=0.17.16-1 libumockdev0=0.17.16-1 libumockdev-dev=0.17.16-1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >list.c <<'CODE'
#include <hidapi/hidapi.h>
#include <stdio.h>
#include <string.h>
#include <umockdev.h>
// A stick with two axes in a physical collection, and of the page of force feedback (0F) one report in a logical
// collection with another inside.
#define STICK "05010904A101" "0901A100" "09300931" "16018026FF7F" "75109502" "8102" "C0" \
    "050F0921A102" "8501" "0922150125287508950191020957A10209581500250175019508" "9102" "C0" "C0" "C0"
static const char description[] =
    "P: /devices/usb1/1-1\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nA: idVendor=1209\nA: idProduct=0001\n"
    "A: bcdDevice=0100\nA: manufacturer=Maker\nA: product=Stick\n\n"
    "P: /devices/usb1/1-1/1-1:1.0\nE: DEVTYPE=usb_interface\nE: SUBSYSTEM=usb\nA: bInterfaceNumber=00\n\n"
    "P: /devices/usb1/1-1/1-1:1.0/0003:1209:0001.0001\nE: HID_ID=0003:00001209:00000001\nE: HID_NAME=Stick\n"
    "E: HID_PHYS=usb-1\nE: HID_UNIQ=\nE: SUBSYSTEM=hid\nH: report_descriptor=" STICK "\n\n"
    "P: /devices/usb1/1-1/1-1:1.0/0003:1209:0001.0001/hidraw/hidraw0\nN: hidraw0\nE: DEVNAME=/dev/hidraw0\n"
    "E: MAJOR=240\nE: MINOR=0\nE: SUBSYSTEM=hidraw\nA: dev=240:0\\n\nL: device=../../../0003:1209:0001.0001\n\n";
int main(void) {
    UMockdevTestbed* bed = umockdev_testbed_new();
    GError* error = NULL;
    if (!umockdev_testbed_add_from_string(bed, description, &error)) {
        fprintf(stderr, "%s\n", error->message);
        return 2;
    }
    int entries = 0, paths = 0, joysticks = 0;
    const char* last = "";
    for (struct hid_device_info* at = hid_enumerate(0x1209, 1); at != NULL; at = at->next) {
        ++entries;
        if (strcmp(last, at->path) != 0) ++paths;
        last = at->path;
        if (at->usage_page == 0x01 && at->usage == 0x04) ++joysticks;
    }
    printf("entries %d, paths %d, joysticks %d", entries, paths, joysticks);
    return 0;
}
CODE
gcc -Iusr/include -Iusr/include/umockdev-1.0 list.c -o list $(pkg-config --cflags --libs gio-2.0) \
    "$libraries/libumockdev.so.0" "$libraries/libhidapi-hidraw.so.0"
saw=$(LD_LIBRARY_PATH=$libraries LD_PRELOAD=$libraries/libumockdev-preload.so.0 ./list)
echo "saw: $saw"
[ "$saw" = "entries 4, paths 1, joysticks 1" ]
