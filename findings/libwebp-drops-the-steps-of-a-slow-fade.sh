#!/usr/bin/env bash
# Package: libwebp7, libwebpmux3, libwebpdemux2, libwebp-dev 1.2.4-0.2+deb12u1 (Debian 12).
# Behaviour: WebPAnimEncoder at quality 75 joins pictures that differ by a few levels from the last one that it kept. A grey
# picture that brightens by one level in each of 24 pictures comes out as four frames, in steps of six levels; at quality
# 100 still as twelve, and key frames alone (kmax 1) change nothing. Only a lossless film keeps each.
# Expected: loss within a frame; and each picture that differs is a frame, of however few bytes.
# Why it matters: a sunset, a cooling kiln or a slow turn stands still and jumps, though each picture was given.
# Seen:
#   24 pictures; lossy: 4 frames; lossless: 24 frames
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=1.2.4-0.2+deb12u1
apt-get -qq -o APT::Sandbox::User=root download "libwebp7=$version" "libwebpmux3=$version" "libwebpdemux2=$version" \
    "libwebp-dev=$version"
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >fade.c <<'CODE'
#include <stdio.h>
#include <webp/demux.h>
#include <webp/encode.h>
#include <webp/mux.h>
enum { kPictures = 24, kPictureMs = 80, kSide = 64 };
static unsigned frames(int lossless) {
    WebPConfig config;
    WebPPicture picture;
    WebPData file;
    WebPDataInit(&file);
    WebPAnimEncoder* encoder = WebPAnimEncoderNew(kSide, kSide, NULL);
    if (!WebPConfigInit(&config) || !WebPPictureInit(&picture)) return 0;
    config.lossless = lossless;
    config.quality = 75.0F;
    picture.use_argb = 1;
    picture.width = picture.height = kSide;
    if (!WebPPictureAlloc(&picture)) return 0;
    for (unsigned i = 0; i < kPictures; ++i) {
        for (int pixel = 0; pixel < kSide * kSide; ++pixel) picture.argb[pixel] = 0xFF000000U + (90U + i) * 0x010101U;
        if (!WebPAnimEncoderAdd(encoder, &picture, (int)i * kPictureMs, &config)) return 0;
    }
    WebPPictureFree(&picture);
    if (!WebPAnimEncoderAdd(encoder, NULL, kPictures * kPictureMs, NULL) || !WebPAnimEncoderAssemble(encoder, &file))
        return 0;
    WebPAnimEncoderDelete(encoder);
    WebPDemuxer* parts = WebPDemux(&file);
    const unsigned count = WebPDemuxGetI(parts, WEBP_FF_FRAME_COUNT);
    WebPDemuxDelete(parts);
    WebPDataClear(&file);
    return count;
}
int main(void) {
    printf("%d pictures; lossy: %u frames; lossless: %u frames", kPictures, frames(0), frames(1));
    return 0;
}
CODE
gcc -Iusr/include fade.c -o fade "$libraries/libwebpmux.so.3" "$libraries/libwebpdemux.so.2" "$libraries/libwebp.so.7"
saw=$(LD_LIBRARY_PATH=$libraries ./fade)
echo "saw: $saw"
[ "$saw" = "24 pictures; lossy: 4 frames; lossless: 24 frames" ]
