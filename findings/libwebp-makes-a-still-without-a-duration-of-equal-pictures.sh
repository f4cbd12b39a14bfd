#!/usr/bin/env bash
# Package: libwebp7, libwebpmux3, libwebpdemux2, libwebp-dev 1.2.4-0.2+deb12u1 (Debian 12); 1.5.0 (Debian 13) does the same.
# Behaviour: WebPAnimEncoder, given ten equal pictures of 300 ms each, returns a file without an animation: one still, and
# the three seconds are nowhere in it. With a single picture that differs, the file keeps all three seconds.
# Expected: an animation of one frame of 3000 ms, which the format has (ANIM and ANMF), from an encoder of animations.
# Why it matters: a film of a pot that nobody touches becomes a picture; a program that asks for its length divides by
# zero or shows it for no time. Put the picture in twice with WebPMux.
# Seen:
#   equal: animation no, ends at 0 ms; last differs: animation yes, ends at 3000 ms
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=1.2.4-0.2+deb12u1
apt-get -qq -o APT::Sandbox::User=root download "libwebp7=$version" "libwebpmux3=$version" "libwebpdemux2=$version" \
    "libwebp-dev=$version"
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >film.c <<'CODE'
#include <stdio.h>
#include <webp/demux.h>
#include <webp/encode.h>
#include <webp/mux.h>
enum { kPictures = 10, kPictureMs = 300, kSide = 32 };
static int film(const char* name, uint32_t last_argb) {
    WebPConfig config;
    WebPPicture picture;
    WebPData file;
    WebPDataInit(&file);
    WebPAnimEncoder* encoder = WebPAnimEncoderNew(kSide, kSide, NULL);
    if (!WebPConfigInit(&config) || !WebPPictureInit(&picture)) return 0;
    config.lossless = 1;
    picture.use_argb = 1;
    picture.width = picture.height = kSide;
    if (!WebPPictureAlloc(&picture)) return 0;
    for (int i = 0; i < kPictures; ++i) {
        for (int pixel = 0; pixel < kSide * kSide; ++pixel)
            picture.argb[pixel] = i + 1 < kPictures ? 0xFF805030U : last_argb;
        if (!WebPAnimEncoderAdd(encoder, &picture, i * kPictureMs, &config)) return 0;
    }
    WebPPictureFree(&picture);
    if (!WebPAnimEncoderAdd(encoder, NULL, kPictures * kPictureMs, NULL) || !WebPAnimEncoderAssemble(encoder, &file))
        return 0;
    WebPAnimEncoderDelete(encoder);
    WebPDemuxer* parts = WebPDemux(&file);
    const int is_animation = (WebPDemuxGetI(parts, WEBP_FF_FORMAT_FLAGS) & ANIMATION_FLAG) != 0;
    int end_ms = 0;
    WebPIterator frame;
    if (WebPDemuxGetFrame(parts, 1, &frame)) do end_ms += frame.duration;
        while (WebPDemuxNextFrame(&frame));
    printf("%s: animation %s, ends at %d ms", name, is_animation ? "yes" : "no", end_ms);
    WebPDemuxReleaseIterator(&frame);
    WebPDemuxDelete(parts);
    WebPDataClear(&file);
    return 1;
}
int main(void) {
    if (!film("equal", 0xFF805030U)) return 2;
    printf("; ");
    return film("last differs", 0xFF8050FFU) ? 0 : 3;
}
CODE
gcc -Iusr/include film.c -o film "$libraries/libwebpmux.so.3" "$libraries/libwebpdemux.so.2" "$libraries/libwebp.so.7"
saw=$(LD_LIBRARY_PATH=$libraries ./film)
echo "saw: $saw"
[ "$saw" = "equal: animation no, ends at 0 ms; last differs: animation yes, ends at 3000 ms" ]
