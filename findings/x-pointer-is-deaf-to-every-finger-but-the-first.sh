#!/usr/bin/env bash
# Package: xserver-xorg-core, xserver-xorg-dev 2:21.1.7-3+deb12u12, xserver-xorg-video-dummy 1:0.4.0-1 (Debian 12), a touch
# screen of the server's own test driver (inputtest).
# Behaviour: the pointer and its button follow the first finger alone until every finger is up. One that came second gives
# a program that knows the pointer only no event: not on touching, not on moving, and not when the first has gone and it
# is the only one on the glass. Only a finger that touches the empty screen counts again.
# Expected: the pointer goes on with a finger that is still there, as a mouse would be handed on.
# Why it matters: a palm or a sleeve that lies on a kiosk's edge makes the screen dead for every hand; a program without
# touch of its own (GLFW 3, SDL 1, Tk) cannot tell. Read touches by XInput 2.2.
# Seen:
#   first finger: 2 button events; second, also alone: 0 button and 0 motion events; a new one: 2 button events
set -euo pipefail
folder=$(mktemp -d)
server=
trap '[ -z "$server" ] || kill "$server" 2>/dev/null || true; wait; rm -rf "$folder"' EXIT
cd "$folder"
mkdir partial
version=2:21.1.7-3+deb12u12
apt-get -qq -o APT::Sandbox::User=root download "xserver-xorg-core=$version" "xserver-xorg-dev=$version" \
    xserver-xorg-video-dummy=1:0.4.0-1
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
    Identifier "touch"
    Driver "inputtest"
    Option "SocketPath" "touch"
    Option "DeviceType" "Touch"
    Option "TouchCount" "5"
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
    InputDevice "touch" "CorePointer"
    InputDevice "keys" "CoreKeyboard"
EndSection
CONF
cat >fingers.c <<'CODE'
#include <X11/Xlib.h>
#include <X11/extensions/XI2.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <xorg/xf86-input-inputtest-protocol.h>
static int screen_touch;
static Display* display;
static int buttons, motions;
static void touch(unsigned finger, int type, double x, double y) {
    xf86ITEventTouch event;
    memset(&event, 0, sizeof event);
    event.header.length = sizeof event;
    event.header.type = XF86IT_EVENT_TOUCH;
    event.touchid = finger;
    event.touch_type = (unsigned)type;
    event.valuators.mask[0] = 3;
    event.valuators.valuators[0] = x * 65536.0;
    event.valuators.valuators[1] = y * 65536.0;
    if (send(screen_touch, &event, sizeof event, 0) != (ssize_t)sizeof event) _exit(3);
    xf86ITEventWaitForSync wait;
    memset(&wait, 0, sizeof wait);
    wait.header.length = sizeof wait;
    wait.header.type = XF86IT_EVENT_WAIT_FOR_SYNC;
    xf86ITResponseSyncFinished done;
    if (send(screen_touch, &wait, sizeof wait, 0) != (ssize_t)sizeof wait ||
        recv(screen_touch, &done, sizeof done, MSG_WAITALL) != (ssize_t)sizeof done)
        _exit(4);
}
// Counts what the window got since the last call.
static void count(void) {
    buttons = motions = 0;
    usleep(200000);
    XSync(display, False);
    while (XPending(display) > 0) {
        XEvent event;
        XNextEvent(display, &event);
        if (event.type == ButtonPress || event.type == ButtonRelease) ++buttons;
        if (event.type == MotionNotify) ++motions;
    }
}
int main(void) {
    struct sockaddr_un address = {.sun_family = AF_UNIX, .sun_path = "touch"};
    screen_touch = socket(AF_UNIX, SOCK_STREAM, 0);
    if (connect(screen_touch, (struct sockaddr*)&address, sizeof address) != 0) return 2;
    xf86ITEventClientVersion version;
    memset(&version, 0, sizeof version);
    version.header.length = sizeof version;
    version.header.type = XF86IT_EVENT_CLIENT_VERSION;
    version.major = XF86IT_PROTOCOL_VERSION_MAJOR;
    version.minor = XF86IT_PROTOCOL_VERSION_MINOR;
    xf86ITResponseServerVersion answer;
    if (send(screen_touch, &version, sizeof version, 0) != (ssize_t)sizeof version ||
        recv(screen_touch, &answer, sizeof answer, MSG_WAITALL) != (ssize_t)sizeof answer)
        return 2;
    display = XOpenDisplay(NULL);
    if (display == NULL) return 2;
    Window window = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 640, 400, 0, 0, 0);
    XSelectInput(display, window, ButtonPressMask | ButtonReleaseMask | PointerMotionMask | ExposureMask);
    XMapRaised(display, window);
    for (XEvent event; XNextEvent(display, &event), event.type != Expose;) {}
    touch(1, XI_TouchBegin, 0.1, 0.1);
    touch(2, XI_TouchBegin, 0.2, 0.2);
    touch(1, XI_TouchEnd, 0.1, 0.1);
    count();
    printf("first finger: %d button events; ", buttons);
    for (int step = 1; step <= 9; ++step) touch(2, XI_TouchUpdate, 0.2 + step * 0.01, 0.2);
    touch(3, XI_TouchBegin, 0.3, 0.1);
    touch(3, XI_TouchEnd, 0.3, 0.1);
    touch(2, XI_TouchEnd, 0.3, 0.2);
    count();
    printf("second, also alone: %d button and %d motion events; ", buttons, motions);
    touch(4, XI_TouchBegin, 0.1, 0.2);
    touch(4, XI_TouchEnd, 0.1, 0.2);
    count();
    printf("a new one: %d button events", buttons);
    return 0;
}
CODE
gcc -Iusr/include fingers.c -o fingers -lX11
modules=$PWD/usr/lib/xorg/modules
usr/lib/xorg/Xorg -seat seat-finding -config xorg.conf -modulepath "$modules" -logfile "$PWD/x.log" -displayfd 3 \
    -noreset -nolisten tcp 3>number >/dev/null 2>&1 &
server=$!
for _ in $(seq 300); do [ -s number ] && break; sleep 0.1; done
saw=$(DISPLAY=:$(cat number) ./fingers)
echo "saw: $saw"
[ "$saw" = "first finger: 2 button events; second, also alone: 0 button and 0 motion events; a new one: 2 button events" ]
