#!/usr/bin/env bash
# Package: libsndfile1, libsndfile1-dev 1.2.0-1+deb12u1 (Debian 12).
# Behaviour: a sample of 1.001 that is written as a float into a file of 16 bits is stored as -32736, nearly full scale to the
# other side, and 1.5 as -16386; each call returns success. With SFC_SET_CLIPPING set first both are 32767.
# Expected: saturation, as in sound cards, mixers and every effect in between: a thousandth too loud is not heard.
# Why it matters: a recorded wheel, a museum's sound or a haptic signal kept as sound has a crack of twice full scale
# where two sounds met, and loudspeakers and motors play it. Ask for clipping, or limit before writing.
# Seen:
#   1: 32767, 1.001: -32736, 1.5: -16386; with clipping: 32767, 32767, 32767
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=1.2.0-1+deb12u1
apt-get -qq -o APT::Sandbox::User=root download "libsndfile1=$version" "libsndfile1-dev=$version"
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >loud.c <<'CODE'
#include <sndfile.h>
#include <stdio.h>
enum { kSamples = 3 };
static int through(short* kept, int clips) {
    const float samples[kSamples] = {1.0F, 1.001F, 1.5F};
    SF_INFO form = {.samplerate = 48000, .channels = 1, .format = SF_FORMAT_WAV | SF_FORMAT_PCM_16};
    SNDFILE* file = sf_open("loud.wav", SFM_WRITE, &form);
    if (file == NULL) return 0;
    if (clips) sf_command(file, SFC_SET_CLIPPING, NULL, SF_TRUE);
    if (sf_writef_float(file, samples, kSamples) != kSamples || sf_close(file) != 0) return 0;
    SF_INFO again = {0};
    file = sf_open("loud.wav", SFM_READ, &again);
    return file != NULL && sf_readf_short(file, kept, kSamples) == kSamples && sf_close(file) == 0;
}
int main(void) {
    short plain[kSamples], clipped[kSamples];
    if (!through(plain, 0) || !through(clipped, 1)) return 2;
    printf("1: %d, 1.001: %d, 1.5: %d; with clipping: %d, %d, %d", plain[0], plain[1], plain[2], clipped[0], clipped[1],
           clipped[2]);
    return 0;
}
CODE
gcc -Iusr/include loud.c -o loud "$libraries/libsndfile.so.1" -Wl,--unresolved-symbols=ignore-in-shared-libs
saw=$(LD_LIBRARY_PATH=$libraries ./loud)
echo "saw: $saw"
[ "$saw" = "1: 32767, 1.001: -32736, 1.5: -16386; with clipping: 32767, 32767, 32767" ]
