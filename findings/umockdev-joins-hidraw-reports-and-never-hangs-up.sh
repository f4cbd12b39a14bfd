#!/usr/bin/env bash
# Package: umockdev, libumockdev0, libumockdev-dev 0.17.16-1 (Debian 12).
# Behaviour: the node of a simulated hidraw device is one stream of bytes. Two reports of four bytes that wait are
# returned by one read of eight, and poll() reports no hang-up after the device was removed.
# Expected: as the kernel's hidraw: a read returns one report, and POLLERR or POLLHUP tells that the device has gone.
# Why it matters: a test of a joystick, haptic or SpaceMouse driver passes though the driver splits reports wrongly or
# waits for ever on an unplugged device, and a right driver fails where two reports wait.
# Seen:
#   one read: 8 bytes; removed: poll says 0
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=0.17.16-1
apt-get -qq -o APT::Sandbox::User=root download "umockdev=$version" "libumockdev0=$version" "libumockdev-dev=$version"
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >reports.c <<'CODE'
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <umockdev.h>
#include <unistd.h>
static const char description[] =
    "P: /devices/pci0/usb1/1-1/0003:0001:0002.0003/hidraw/hidraw0\n"
    "N: hidraw0\nE: DEVNAME=/dev/hidraw0\nE: SUBSYSTEM=hidraw\n";
int main(void) {
    UMockdevTestbed* bed = umockdev_testbed_new();
    if (!umockdev_testbed_add_from_string(bed, description, NULL)) return 2;
    int device = open("/dev/hidraw0", O_RDWR);
    // What is written there, the device reports.
    int reporter = umockdev_testbed_get_dev_fd(bed, "/dev/hidraw0");
    if (device < 0 || reporter < 0) return 3;
    for (int report = 0; report < 2; ++report)
        if (write(reporter, "\1\2\3\4", 4) != 4) return 4;
    unsigned char bytes[64];
    printf("one read: %zd bytes; ", read(device, bytes, sizeof bytes));
    umockdev_testbed_uevent(bed, "/sys/devices/pci0/usb1/1-1/0003:0001:0002.0003/hidraw/hidraw0", "remove");
    umockdev_testbed_remove_device(bed, "/sys/devices/pci0/usb1/1-1/0003:0001:0002.0003/hidraw/hidraw0");
    struct pollfd one = {.fd = device, .events = POLLIN};
    const int ready = poll(&one, 1, 500);
    printf("removed: poll says %d\n", ready);
    return 0;
}
CODE
gcc -Iusr/include/umockdev-1.0 reports.c -o reports $(pkg-config --cflags --libs gio-2.0) "$libraries/libumockdev.so.0"
saw=$(LD_LIBRARY_PATH=$libraries LD_PRELOAD=$libraries/libumockdev-preload.so.0 ./reports)
echo "saw: $saw"
[ "$saw" = "one read: 8 bytes; removed: poll says 0" ]
