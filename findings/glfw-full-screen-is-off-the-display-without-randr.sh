#!/usr/bin/env bash
# Package: libglfw3, libglfw3-dev 3.3.8-1 (Debian 12), on an X server without the RandR extension (thin clients,
# VNC servers and multi-head set-ups have such; here Xvfb with the extension switched off).
# Behaviour: GLFW reports one monitor at 0,0 with the display's size, creates a full-screen window on it without an
# error, and places it at coordinates that it never set: the window has the right size and lies off the display.
# Expected: the window at 0,0, where glfwGetMonitorPos says that the monitor is; or an error.
# Why it matters: a kiosk shows a black display while the program runs, renders and reports no fault. Compare the
# window's position with the monitor's after it is shown; an undecorated window at the monitor's place is visible.
# Seen (the coordinates vary):
#   with RandR: monitor 0,0 1280x720, window covers it; without: monitor 0,0 1280x720, window off it
set -euo pipefail
folder=$(mktemp -d)
server=
trap 'kill $server 2>/dev/null || true; rm -rf "$folder"' EXIT
cd "$folder"
version=3.3.8-1
apt-get -qq -o APT::Sandbox::User=root download "libglfw3=$version" "libglfw3-dev=$version"
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >place.c <<'CODE'
#include <GLFW/glfw3.h>
#include <stdio.h>
#include <stdlib.h>
// What a larger program leaves on the stack, from which GLFW takes the coordinates; zeroes would hide them.
static void leave_marks(void) {
    volatile unsigned char marks[65536];
    for (unsigned i = 0; i < sizeof marks; ++i) marks[i] = 0x55;
}
int main(void) {
    if (!glfwInit()) return 2;
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    leave_marks();
    GLFWwindow* window = glfwCreateWindow(mode->width, mode->height, "place", monitor, NULL);
    if (window == NULL) return 3;
    for (int wait = 0; wait < 20; ++wait) glfwWaitEventsTimeout(0.05);
    int left, top, x, y;
    glfwGetMonitorPos(monitor, &left, &top);
    glfwGetWindowPos(window, &x, &y);
    const int is_off = abs(x - left) >= mode->width || abs(y - top) >= mode->height;
    printf("monitor %d,%d %dx%d, window %s", left, top, mode->width, mode->height,
           is_off ? "off it" : x == left && y == top ? "covers it" : "partly on it");
    glfwTerminate();
    return 0;
}
CODE
libraries=$(dirname "$(find . -name 'libglfw.so.3' | head -1)")
gcc -Iusr/include place.c -o place "$libraries/libglfw.so.3"
# place_on SERVER-OPTION...: where the window is on a server of its own.
place_on() {
    rm -f display
    Xvfb -screen 0 1280x720x24 -nolisten tcp -noreset "$@" -displayfd 1 >display 2>/dev/null &
    server=$!
    until [ -s display ]; do
        kill -0 "$server"
        sleep 0.1
    done
    DISPLAY=:$(cat display) LD_LIBRARY_PATH=$libraries ./place
    kill "$server"
}
saw="with RandR: $(place_on -extension DOUBLE-BUFFER); without: $(place_on -extension RANDR)"
echo "saw: $saw"
[ "$saw" = "with RandR: monitor 0,0 1280x720, window covers it; without: monitor 0,0 1280x720, window off it" ]
