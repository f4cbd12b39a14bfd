#!/usr/bin/env bash
# Package: libopenal1, libopenal-dev, libopenal-data 1:1.19.1-2 with pipewire, pipewire-bin, pipewire-alsa 0.3.65-3+deb12u1 and
# libasound2 1.2.8-1+b1 (Debian 12). OpenAL Soft 1.24.2 of Debian 13 does the same by its own back end for PipeWire.
# Behaviour: PipeWire ends while OpenAL Soft plays to it through ALSA. OpenAL says that the device is connected and the source
# plays, for ever, also once PipeWire runs again; no further buffer is done. A PulseAudio server's end is told.
# Expected: ALC_CONNECTED turns false (ALC_EXT_disconnect), as where a card is pulled out.
# Why it matters: a kiosk whose sound server is restarted by an update, or fails and is restarted, is silent for the rest of the
# day and says that it is heard. Watch that buffers are done, and open the device again where none was for seconds.
# Seen:
#   connected 1, playing 1, buffers done 0
set -euo pipefail
folder=$(mktemp -d)
server=
manager=
player=
trap 'for process in $server $manager $player; do kill "$process" 2>/dev/null || true; done; rm -rf "$folder"' EXIT
cd "$folder"
openal=1:1.19.1-2
pipewire=0.3.65-3+deb12u1
apt-get -qq -o APT::Sandbox::User=root download "libopenal1=$openal" "libopenal-dev=$openal" "libopenal-data=$openal" \
    libasound2=1.2.8-1+b1 libasound2-data=1.2.8-1 "pipewire=$pipewire" "pipewire-bin=$pipewire" "pipewire-alsa=$pipewire" \
    "libpipewire-0.3-0=$pipewire" "libpipewire-0.3-modules=$pipewire" "libspa-0.2-modules=$pipewire" wireplumber=0.4.13-1 \
    libwireplumber-0.4-0=0.4.13-1 liblua5.3-0=5.3.6-2
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >play.c <<'CODE'
// Plays 20 s of silence in 200 buffers and makes the file "plays" once five are done. Once the file "ended" is there, waits and
// prints what OpenAL says 3 s later.
#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>
static void wait_ms(long ms) { nanosleep(&(struct timespec){ms / 1000, ms % 1000 * 1000000}, NULL); }
int main(void) {
    ALCdevice* device = alcOpenDevice(NULL);
    if (device == NULL) return 2;
    alcMakeContextCurrent(alcCreateContext(device, NULL));
    static short silence[4800];
    ALuint source, buffers[200];
    alGenSources(1, &source);
    alGenBuffers(200, buffers);
    for (int i = 0; i < 200; ++i) alBufferData(buffers[i], AL_FORMAT_MONO16, silence, sizeof silence, 48000);
    alSourceQueueBuffers(source, 200, buffers);
    alSourcePlay(source);
    ALint played = 0, before, after, state;
    ALCint connected;
    while (played < 5) alGetSourcei(source, AL_BUFFERS_PROCESSED, &played), wait_ms(10);
    fclose(fopen("plays", "w"));
    while (access("ended", F_OK) != 0) wait_ms(10);
    wait_ms(500);
    alGetSourcei(source, AL_BUFFERS_PROCESSED, &before);
    wait_ms(3000);
    alGetSourcei(source, AL_BUFFERS_PROCESSED, &after);
    alGetSourcei(source, AL_SOURCE_STATE, &state);
    alcGetIntegerv(device, ALC_CONNECTED, 1, &connected);
    printf("connected %d, playing %d, buffers done %d", connected, state == AL_PLAYING, after - before);
    fflush(stdout);
    _exit(0);
}
CODE
gcc -Iusr/include play.c -o play "$libraries/libopenal.so.1" -Wl,--unresolved-symbols=ignore-in-shared-libs
export XDG_RUNTIME_DIR=$PWD HOME=$PWD LD_LIBRARY_PATH=$libraries ALSA_PLUGIN_DIR=$libraries/alsa-lib
export SPA_PLUGIN_DIR=$libraries/spa-0.2 PIPEWIRE_MODULE_DIR=$libraries/pipewire-0.3 PIPEWIRE_CONFIG_DIR=$PWD/usr/share/pipewire
export WIREPLUMBER_MODULE_DIR=$libraries/wireplumber-0.4 WIREPLUMBER_CONFIG_DIR=$PWD/usr/share/wireplumber
export WIREPLUMBER_DATA_DIR=$PWD/usr/share/wireplumber
unset PULSE_SERVER DBUS_SESSION_BUS_ADDRESS ALSOFT_CONF
printf 'pcm.!default { type pipewire }\nctl.!default { type pipewire }\n' >alsa.conf
usr/bin/pipewire >server.log 2>&1 &
server=$!
for _ in $(seq 100); do [ -S pipewire-0 ] && break; sleep 0.1; done
# Links sounds to a sink that plays nowhere, and looks neither for cards nor for a desktop.
printf 'load_module("metadata")\ndevice_defaults.enable()\nstream_defaults.enable()\n' \
    >usr/share/wireplumber/main.lua.d/90-enable-all.lua
: >usr/share/wireplumber/bluetooth.lua.d/90-enable-all.lua
usr/bin/wireplumber >manager.log 2>&1 &
manager=$!
sleep 1
sink='factory.name=support.null-audio-sink node.name=hall media.class=Audio/Sink object.linger=true audio.position=[FL FR]'
usr/bin/pw-cli create-node adapter "{ $sink }" >sink.log
sleep 1
ALSOFT_DRIVERS=alsa ALSA_CONFIG_PATH=$PWD/alsa.conf ./play >said 2>/dev/null &
player=$!
for _ in $(seq 100); do [ -e plays ] && break; sleep 0.1; done
[ -e plays ]
kill "$server"
wait "$server" || true
server=
touch ended
wait "$player"
player=
saw=$(cat said)
echo "saw: $saw"
[ "$saw" = "connected 1, playing 1, buffers done 0" ]
