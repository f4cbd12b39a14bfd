#!/usr/bin/env bash
# Package: libopenal1, libopenal-dev 1:1.19.1-2, libopenal-data 1:1.19.1-2 with libasound2 1.2.8-1+b1 (Debian 12).
# Behaviour: on a machine without a sound card and a sound server, here by an ALSA configuration without a card, OpenAL
# Soft lists one device, "ALSA Default", and names it as the default. Opening it fails, with the error "out of memory".
# Expected: an empty list; or an error that says that there is no such device (ALC_INVALID_DEVICE, ALC_INVALID_VALUE).
# Why it matters: a kiosk's start-up check that counts devices promises sound, and its log then blames the memory; each
# try prints ALSA's search to the log. Look for a playback device in /dev/snd or a server's socket first.
# Seen:
#   listed: ALSA Default; default: ALSA Default; opened: no, error A005 (out of memory)
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=1:1.19.1-2
apt-get -qq -o APT::Sandbox::User=root download "libopenal1=$version" "libopenal-dev=$version" "libopenal-data=$version" \
    libasound2=1.2.8-1+b1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >devices.c <<'CODE'
#include <AL/al.h>
#include <AL/alc.h>
#include <stdio.h>
#include <string.h>
int main(void) {
    const char* separator = "listed: ";
    for (const char* name = alcGetString(NULL, ALC_ALL_DEVICES_SPECIFIER); *name != '\0'; name += strlen(name) + 1) {
        printf("%s%s", separator, name);
        separator = ", ";
    }
    printf("; default: %s", alcGetString(NULL, ALC_DEFAULT_ALL_DEVICES_SPECIFIER));
    ALCdevice* device = alcOpenDevice(NULL);
    const ALCenum error = alcGetError(NULL);
    printf("; opened: %s, error %X%s", device != NULL ? "yes" : "no", (unsigned)error,
           error == ALC_OUT_OF_MEMORY ? " (out of memory)" : "");
    return 0;
}
CODE
gcc -Iusr/include devices.c -o devices "$libraries/libopenal.so.1" -Wl,--unresolved-symbols=ignore-in-shared-libs
: >no-card.conf
saw=$(env -u PULSE_SERVER -u XDG_RUNTIME_DIR -u ALSOFT_CONF HOME="$PWD" ALSOFT_DRIVERS=alsa ALSA_CONFIG_PATH="$PWD/no-card.conf" \
    LD_LIBRARY_PATH="$libraries" ./devices 2>/dev/null)
echo "saw: $saw"
[ "$saw" = "listed: ALSA Default; default: ALSA Default; opened: no, error A005 (out of memory)" ]
