#!/usr/bin/env bash
# Package: libopenal1, libopenal-dev 1:1.19.1-2, libopenal-data 1:1.19.1-2 with libasound2 1.2.8-1+b1 (Debian 12).
# Behaviour: ALSA's device "null", which an asoundrc names as the default where a machine has no card, takes sound as fast
# as it is given, and OpenAL Soft gives it as fast as it can, also while nothing plays: a minute of sound has been played
# within seconds. OpenAL's own back end "null" takes the minute that it lasts.
# Expected: both keep the time of the sound, as every device does that a program may wait for.
# Why it matters: a kiosk whose screens wait for a spoken line flies through them on the machine that builds it, and heats a
# quiet one. Choose OpenAL's null (ALSOFT_DRIVERS=null), and let no screen wait by sound alone.
# Seen:
#   ALSA's null: a minute in under 10 s; OpenAL's null: half a second in at least half a second
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=1:1.19.1-2
apt-get -qq -o APT::Sandbox::User=root download "libopenal1=$version" "libopenal-dev=$version" "libopenal-data=$version" \
    libasound2=1.2.8-1+b1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >play.c <<'CODE'
// play MS: plays silence of that length; prints the milliseconds that it took.
#include <AL/al.h>
#include <AL/alc.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>
static double now_ms(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1e3 + now.tv_nsec * 1e-6;
}
int main(int count, char** words) {
    (void)count;
    ALCdevice* device = alcOpenDevice(NULL);
    if (device == NULL) return 2;
    ALCcontext* context = alcCreateContext(device, NULL);
    alcMakeContextCurrent(context);
    const int bytes = 2 * 8 * atoi(words[1]);  // 8 samples a millisecond
    void* silence = calloc(1, bytes);
    ALuint buffer, source;
    alGenBuffers(1, &buffer);
    alBufferData(buffer, AL_FORMAT_MONO16, silence, bytes, 8000);
    alGenSources(1, &source);
    alSourcei(source, AL_BUFFER, (ALint)buffer);
    const double began = now_ms();
    alSourcePlay(source);
    ALint state = AL_PLAYING;
    while (state == AL_PLAYING && now_ms() - began < 70e3) {
        usleep(1000);
        alGetSourcei(source, AL_SOURCE_STATE, &state);
    }
    printf("%.0f", now_ms() - began);
    alcMakeContextCurrent(NULL);
    alcDestroyContext(context);
    alcCloseDevice(device);
    free(silence);
    return 0;
}
CODE
gcc -Iusr/include play.c -o play "$libraries/libopenal.so.1" -Wl,--unresolved-symbols=ignore-in-shared-libs
printf 'pcm.!default { type null }\nctl.!default { type null }\n' >null.conf
# play BACK_END MS
play() {
    env -u PULSE_SERVER -u XDG_RUNTIME_DIR -u ALSOFT_CONF HOME="$PWD" ALSOFT_DRIVERS="$1" ALSA_CONFIG_PATH="$PWD/null.conf" \
        LD_LIBRARY_PATH="$libraries" ./play "$2" 2>/dev/null
}
alsa_ms=$(play alsa 60000)
own_ms=$(play null 500)
saw="ALSA's null: a minute in $([ "$alsa_ms" -lt 10000 ] && echo under || echo over) 10 s"
saw="$saw; OpenAL's null: half a second in $([ "$own_ms" -ge 490 ] && echo at least || echo less than) half a second"
echo "saw: $saw"
[ "$saw" = "ALSA's null: a minute in under 10 s; OpenAL's null: half a second in at least half a second" ]
