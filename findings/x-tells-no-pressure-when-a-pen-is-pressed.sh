#!/usr/bin/env bash
# Package: xserver-xorg-core, xserver-xorg-dev 2:21.1.7-3+deb12u12, xserver-xorg-video-dummy 1:0.4.0-1, libxi6, libxi-dev
# 2:1.8-1+b1, libxfixes-dev 1:6.0.0-2 (Debian 12), a pen of the server's own test driver (inputtest).
# Behaviour: XInput 2's event of a pen's press lists no valuator at all, so no pressure. A motion lists what the driver told,
# and no more: pressure alone, or x alone. A program of the core protocol gets nothing when the pen is only pressed harder.
# Expected: a press that says how firm it is, and motions with the whole state: the event has room for every axis.
# Why it matters: a line or a wall begins with the pressure 0 that was never told, and one that waits for the pointer to
# move misses a hand that only leans. Keep the last value of each axis; read by XInput 2.
# Seen:
#   pressed harder: axis 4 alone, core events 0; moved sideways: axis 0 alone, core events 1; press: no axes
set -euo pipefail
folder=$(mktemp -d)
server=
trap '[ -z "$server" ] || kill "$server" 2>/dev/null || true; wait; rm -rf "$folder"' EXIT
cd "$folder"
version=2:21.1.7-3+deb12u12
apt-get -qq -o APT::Sandbox::User=root download "xserver-xorg-core=$version" "xserver-xorg-dev=$version" \
    xserver-xorg-video-dummy=1:0.4.0-1 libxi6=2:1.8-1+b1 libxi-dev=2:1.8-1+b1 libxfixes-dev=1:6.0.0-2
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >xorg.conf <<'CONF'
Section "ServerFlags"
    Option "AutoAddDevices" "false"
    Option "AutoAddGPU" "false"
EndSection
Section "Device"
    Identifier "memory"
    Driver "dummy"
EndSection
Section "Screen"
    Identifier "screen"
    Device "memory"
    DefaultDepth 24
EndSection
Section "InputDevice"
    Identifier "pen"
    Driver "inputtest"
    Option "SocketPath" "pen"
    Option "DeviceType" "PointerAbsoluteProximity"
EndSection
Section "InputDevice"
    Identifier "keys"
    Driver "inputtest"
    Option "SocketPath" "keys"
    Option "DeviceType" "Keyboard"
EndSection
Section "ServerLayout"
    Identifier "desk"
    Screen "screen"
    InputDevice "pen" "CorePointer"
    InputDevice "keys" "CoreKeyboard"
EndSection
CONF
cat >pen.c <<'CODE'
#include <X11/Xlib.h>
#include <X11/extensions/XInput2.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <xorg/xf86-input-inputtest-protocol.h>
static int pen, extension;
static Display *by_extension, *by_core;
static void tell(xf86ITEventAny* event, size_t size, unsigned type) {
    event->header.length = size;
    event->header.type = type;
    if (send(pen, event, size, 0) != (ssize_t)size) _exit(3);
}
static void wait_for_server(void) {
    xf86ITEventAny wait = {0};
    xf86ITResponseSyncFinished done;
    tell(&wait, sizeof(xf86ITEventWaitForSync), XF86IT_EVENT_WAIT_FOR_SYNC);
    if (recv(pen, &done, sizeof done, MSG_WAITALL) != (ssize_t)sizeof done) _exit(4);
}
// axes: a bit each: 0 and 1 are the place, 4 the pressure.
static void move(unsigned char axes, double x, double pressure) {
    xf86ITEventAny event = {0};
    event.motion.is_absolute = 1;
    event.motion.valuators.mask[0] = axes;
    event.motion.valuators.valuators[0] = x * 65536.0;
    event.motion.valuators.valuators[1] = 0.5 * 65536.0;
    event.motion.valuators.valuators[4] = pressure;
    tell(&event, sizeof event.motion, XF86IT_EVENT_MOTION);
    wait_for_server();
}
static void press(void) {
    xf86ITEventAny event = {0};
    event.button.is_absolute = 1;
    event.button.button = 1;
    event.button.is_press = 1;
    tell(&event, sizeof event.button, XF86IT_EVENT_BUTTON);
    wait_for_server();
}
// The motions that the core protocol's program got since the last call.
static int motions(void) {
    usleep(200000);
    XSync(by_core, False);
    int count = 0;
    while (XPending(by_core) > 0) {
        XEvent event;
        XNextEvent(by_core, &event);
        count += event.type == MotionNotify;
    }
    return count;
}
// Prints the axes of what the extension's program got since the last call.
static void print_axes(void) {
    usleep(200000);
    XSync(by_extension, False);
    while (XPending(by_extension) > 0) {
        XEvent event;
        XNextEvent(by_extension, &event);
        if (event.type != GenericEvent || event.xcookie.extension != extension) continue;
        if (!XGetEventData(by_extension, &event.xcookie)) continue;
        const XIValuatorState* axes = &((XIDeviceEvent*)event.xcookie.data)->valuators;
        int count = 0;
        for (int axis = 0; axis < axes->mask_len * 8; ++axis)
            if (XIMaskIsSet(axes->mask, axis)) printf("%s axis %d", count++ > 0 ? "," : "", axis);
        printf("%s", count == 0 ? " no axes" : count == 1 ? " alone" : "");
        XFreeEventData(by_extension, &event.xcookie);
    }
}
static Window open_window(Display** display, long mask) {
    *display = XOpenDisplay(NULL);
    if (*display == NULL) _exit(2);
    const Window root = DefaultRootWindow(*display);
    XSelectInput(*display, root, mask);
    return root;
}
int main(void) {
    struct sockaddr_un address = {.sun_family = AF_UNIX, .sun_path = "pen"};
    pen = socket(AF_UNIX, SOCK_STREAM, 0);
    if (connect(pen, (struct sockaddr*)&address, sizeof address) != 0) return 2;
    xf86ITEventAny version = {0};
    version.version.major = XF86IT_PROTOCOL_VERSION_MAJOR;
    version.version.minor = XF86IT_PROTOCOL_VERSION_MINOR;
    tell(&version, sizeof version.version, XF86IT_EVENT_CLIENT_VERSION);
    xf86ITResponseServerVersion answer;
    if (recv(pen, &answer, sizeof answer, MSG_WAITALL) != (ssize_t)sizeof answer) return 2;
    open_window(&by_core, PointerMotionMask);
    move(0x13, 0.2, 100);
    motions();
    move(0x10, 0.2, 300);
    const int leaned = motions();
    move(0x01, 0.3, 300);
    const int moved = motions();
    const Window root = open_window(&by_extension, NoEventMask);
    int event_base, error_base, major = 2, minor = 2;
    if (!XQueryExtension(by_extension, "XInputExtension", &extension, &event_base, &error_base)) return 2;
    XIQueryVersion(by_extension, &major, &minor);
    unsigned char wanted[4] = {0};
    XISetMask(wanted, XI_Motion);
    XISetMask(wanted, XI_ButtonPress);
    XISelectEvents(by_extension, root, &(XIEventMask){XIAllMasterDevices, sizeof wanted, wanted}, 1);
    XSync(by_extension, False);
    printf("pressed harder:");
    move(0x10, 0.3, 400);
    print_axes();
    printf(", core events %d; moved sideways:", leaned);
    move(0x01, 0.4, 400);
    print_axes();
    printf(", core events %d; press:", moved);
    press();
    print_axes();
    return 0;
}
CODE
gcc -Iusr/include pen.c -o pen-events -lX11 "$PWD/usr/lib/x86_64-linux-gnu/libXi.so.6" \
    -Wl,--unresolved-symbols=ignore-in-shared-libs
modules=$PWD/usr/lib/xorg/modules
usr/lib/xorg/Xorg -seat seat-finding -config xorg.conf -modulepath "$modules" -logfile "$PWD/x.log" -displayfd 3 \
    -noreset -nolisten tcp 3>number >/dev/null 2>&1 &
server=$!
for _ in $(seq 300); do [ -s number ] && break; sleep 0.1; done
saw=$(LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu DISPLAY=:$(cat number) ./pen-events)
echo "saw: $saw"
[ "$saw" = "pressed harder: axis 4 alone, core events 0; moved sideways: axis 0 alone, core events 1; press: no axes" ]
