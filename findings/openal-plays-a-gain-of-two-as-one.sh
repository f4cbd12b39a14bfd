#!/usr/bin/env bash
# Package: libopenal1, libopenal-dev 1:1.19.1-2, libopenal-data 1:1.19.1-2 (Debian 12), writing a wave file.
# Behaviour: AL_GAIN of a source may be set above 1, without an error, and is read back as set; the sound is as loud as
# with 1. The cause is another property, AL_MAX_GAIN, which is 1 for a new source and may not be set higher. The
# listener's gain of 2 does double it.
# Expected: twice the amplitude (6 dB), or AL_INVALID_VALUE as for a negative gain.
# Why it matters: a slider beyond 100 % for a noisy hall does nothing, and a mix that balances voices by gains above 1 has
# them all equal. Scale the samples, or raise the listener's gain.
# Seen:
#   source's gain 2: 1.0 times as loud, no error, reads 2.0; listener's gain 2: 2.0 times
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=1:1.19.1-2
apt-get -qq -o APT::Sandbox::User=root download "libopenal1=$version" "libopenal-dev=$version" "libopenal-data=$version"
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >play.c <<'CODE'
// play SOURCE_GAIN LISTENER_GAIN: half a second of a square wave of a tenth of full scale, a second's stop apart at the
// most; prints the gain that is read back, and the error.
#include <AL/al.h>
#include <AL/alc.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
int main(int count, char** words) {
    (void)count;
    ALCdevice* device = alcOpenDevice(NULL);
    if (device == NULL) return 2;
    ALCcontext* context = alcCreateContext(device, NULL);
    alcMakeContextCurrent(context);
    static short samples[22050];
    for (int at = 0; at < 22050; ++at) samples[at] = at / 100 % 2 != 0 ? 3277 : -3277;
    ALuint buffer, source;
    alGenBuffers(1, &buffer);
    alBufferData(buffer, AL_FORMAT_MONO16, samples, sizeof samples, 44100);
    alGenSources(1, &source);
    alSourcei(source, AL_BUFFER, (ALint)buffer);
    alGetError();
    alSourcef(source, AL_GAIN, strtof(words[1], NULL));
    alListenerf(AL_GAIN, strtof(words[2], NULL));
    float gain = 0;
    alGetSourcef(source, AL_GAIN, &gain);
    printf("%s, reads %.1f", alGetError() == AL_NO_ERROR ? "no error" : "an error", gain);
    alSourcePlay(source);
    ALint state = AL_PLAYING;
    for (int wait = 0; wait < 3000 && state == AL_PLAYING; ++wait) {
        usleep(10000);
        alGetSourcei(source, AL_SOURCE_STATE, &state);
    }
    alcMakeContextCurrent(NULL);
    alcDestroyContext(context);
    alcCloseDevice(device);
    return 0;
}
CODE
gcc -Iusr/include play.c -o play "$libraries/libopenal.so.1" -Wl,--unresolved-symbols=ignore-in-shared-libs
printf '[general]\ndrivers = wave\nsample-type = int16\n[wave]\nfile = %s/played.wav\n' "$PWD" >played.conf
# play SOURCE_GAIN LISTENER_GAIN: sets said, and loudness: the mean size of the loudest quarter of the samples.
play() {
    said=$(ALSOFT_CONF=$PWD/played.conf LD_LIBRARY_PATH=$libraries ./play "$1" "$2" 2>/dev/null)
    loudness=$(python3 - <<'CODE'
import array
samples = array.array("h", open("played.wav", "rb").read()[-80000 // 4 * 4:])
loudest = sorted(map(abs, samples))[-len(samples) // 4:]
print(sum(loudest) / len(loudest))
CODE
    )
}
times() { awk "BEGIN { printf \"%.1f times\", $loudness / $once }"; }
play 1 1
once=$loudness
play 2 1
saw="source's gain 2: $(times) as loud, $said"
play 1 2
saw="$saw; listener's gain 2: $(times)"
echo "saw: $saw"
[ "$saw" = "source's gain 2: 1.0 times as loud, no error, reads 2.0; listener's gain 2: 2.0 times" ]
