#!/usr/bin/env bash
# Package: libsndfile1, libsndfile1-dev 1.2.0-1+deb12u1 (Debian 12).
# Behaviour: a float WAV that holds 0.5 and -1 (full scale) is 0 and -1 to sf_readf_short, nearly silence; a short of 16384
# that is written to a float WAV is 16384 there, 32768 times half of full scale. From a file of 16 bits sf_readf_float gives
# 0.5 for 16384, as one would think. SFC_SET_SCALE_FLOAT_INT_READ and SFC_SET_SCALE_INT_FLOAT_WRITE turn the others on.
# Expected: a sample keeps its loudness in whatever type it is asked for, in both directions and for all files.
# Why it matters: a kiosk plays a museum's float recording as silence, or a cue saved by shorts at a volume that is cut to
# a square wave in loudspeakers and motors. Read and write floats, or set both switches.
# Seen:
#   float file as shorts: 0, -1; short in a float file: 16384; 16-bit file as float: 0.5; switched: 16383
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=1.2.0-1+deb12u1
apt-get -qq -o APT::Sandbox::User=root download "libsndfile1=$version" "libsndfile1-dev=$version"
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >kinds.c <<'CODE'
#include <sndfile.h>
#include <stdio.h>
#include <stdlib.h>
static SNDFILE* opened(int mode, int kind) {
    SF_INFO form = {0};
    if (mode == SFM_WRITE) form = (SF_INFO){.samplerate = 48000, .channels = 1, .format = SF_FORMAT_WAV | kind};
    SNDFILE* file = sf_open("sound.wav", mode, &form);
    if (file == NULL) exit(2);
    return file;
}
int main(void) {
    float floats[2] = {0.5F, -1.0F};
    short shorts[2];
    SNDFILE* file = opened(SFM_WRITE, SF_FORMAT_FLOAT);
    sf_writef_float(file, floats, 2);
    sf_close(file);
    file = opened(SFM_READ, 0);
    sf_readf_short(file, shorts, 2);
    printf("float file as shorts: %d, %d; ", shorts[0], shorts[1]);
    sf_close(file);
    const int kinds[2] = {SF_FORMAT_FLOAT, SF_FORMAT_PCM_16};
    const char* const names[2] = {"short in a float file", "16-bit file as float"};
    for (int i = 0; i < 2; ++i) {
        shorts[0] = 16384;
        file = opened(SFM_WRITE, kinds[i]);
        sf_writef_short(file, shorts, 1);
        sf_close(file);
        file = opened(SFM_READ, 0);
        sf_readf_float(file, floats, 1);
        printf("%s: %g; ", names[i], floats[0]);
        sf_close(file);
    }
    floats[0] = 0.5F;
    floats[1] = 1.0F;  // The switch takes the file's largest sample for full scale.
    file = opened(SFM_WRITE, SF_FORMAT_FLOAT);
    sf_writef_float(file, floats, 2);
    sf_close(file);
    file = opened(SFM_READ, 0);
    sf_command(file, SFC_SET_SCALE_FLOAT_INT_READ, NULL, SF_TRUE);
    sf_readf_short(file, shorts, 1);
    printf("switched: %d", shorts[0]);
    sf_close(file);
    return 0;
}
CODE
gcc -Iusr/include kinds.c -o kinds "$libraries/libsndfile.so.1" -Wl,--unresolved-symbols=ignore-in-shared-libs
saw=$(LD_LIBRARY_PATH=$libraries ./kinds)
echo "saw: $saw"
[ "$saw" = "float file as shorts: 0, -1; short in a float file: 16384; 16-bit file as float: 0.5; switched: 16383" ]
