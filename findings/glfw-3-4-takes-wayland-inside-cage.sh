#!/usr/bin/env bash
# Package: libglfw3 3.4-3 under cage 0.2.0-2 (Debian 13). As root: makes a root of Debian 13 (mmdebstrap) and mounts in a
# namespace of its own.
# Behaviour: the program that took X11 (Xwayland) under cage with GLFW 3.3 takes Wayland with 3.4, which has the same
# soname, also where WAYLAND_DISPLAY is unset and DISPLAY is set. The hint GLFW_PLATFORM_X11 before glfwInit() keeps X11.
# Expected: DISPLAY set and WAYLAND_DISPLAY unset mean X11; or a new soname for a new window system.
# Why it matters: GLFW has no touch on either, but on X11 a program reads touches from XInput 2 for GLFW's window. After
# an upgrade of the system the kiosk's touch screen is dead, and nothing reports it.
# Seen:
#   in cage: Wayland; without WAYLAND_DISPLAY: Wayland; with the hint: X11
set -euo pipefail
[ "$(id -u)" -eq 0 ] || { echo "expected root, found $(id -un)"; exit 1; }
[ -n "${IN_NAMESPACE:-}" ] || IN_NAMESPACE=1 exec unshare --mount --propagation unchanged bash "$0"
folder=$(mktemp -d)
trap 'umount -R "$folder/root/dev" 2>/dev/null || true; rm -rf --one-file-system "$folder"' EXIT
cd "$folder"
mmdebstrap --quiet --variant=apt --include=cage,xwayland,libglfw3,libgl1-mesa-dri trixie root http://deb.debian.org/debian
chroot root dpkg-query -W -f '${Package} ${Version}\n' libglfw3 cage | tr '\n' ' '
cat >platform.c <<'CODE'
#include <stdio.h>
#include <stdlib.h>
void glfwInitHint(int hint, int value);
int glfwInit(void);
int glfwGetPlatform(void);
void glfwTerminate(void);
int main(int count, char** words) {
    (void)words;
    if (count > 1) glfwInitHint(0x00050003, 0x00060004);  // GLFW_PLATFORM, GLFW_PLATFORM_X11
    if (!glfwInit()) return 2;
    const int platform = glfwGetPlatform();
    puts(platform == 0x00060003 ? "Wayland" : platform == 0x00060004 ? "X11" : "another");
    glfwTerminate();
    return 0;
}
CODE
gcc platform.c -o root/platform root/usr/lib/x86_64-linux-gnu/libglfw.so.3 -Wl,--unresolved-symbols=ignore-in-shared-libs
mount --rbind /dev root/dev
mount --make-rslave root/dev
install -d -o nobody -m 700 root/run/nobody
# platform COMMAND...: what the program takes as the client of cage.
platform() {
    chroot root setpriv --reuid=nobody --regid=nogroup --clear-groups env -u DISPLAY XDG_RUNTIME_DIR=/run/nobody \
        WLR_BACKENDS=headless WLR_RENDERER=pixman WLR_LIBINPUT_NO_DEVICES=1 timeout 30 cage -- "$@" 2>/dev/null |
        grep -E '^(Wayland|X11|another)$'
}
saw="in cage: $(platform /platform); without WAYLAND_DISPLAY: $(platform env -u WAYLAND_DISPLAY /platform); \
with the hint: $(platform /platform x11)"
echo "saw: $saw"
[ "$saw" = "in cage: Wayland; without WAYLAND_DISPLAY: Wayland; with the hint: X11" ]
