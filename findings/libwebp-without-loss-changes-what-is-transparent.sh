#!/usr/bin/env bash
# Package: libwebp7, libwebp-dev 1.2.4-0.2+deb12u1 (Debian 12).
# Behaviour: WebPEncodeLosslessRGBA gives back every byte of an opaque picture, and of pixels whose alpha is 0 only the
# alpha: their red, green and blue are gone. With alpha 1 of 255 they stay. The call that keeps them is another one,
# with WebPConfig.exact.
# Expected: without loss means each byte, as in PNG; transparency is the reader's affair.
# Why it matters: masks, heights or normals packed beside an alpha of zero, and edges that a renderer filters, come
# out changed from a format chosen because it loses nothing; a round trip of opaque pictures does not show it.
# Seen:
#   opaque: same; alpha 1: same; alpha 0: 0 0 0 for 200 100 50; alpha 0 with exact: same
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=1.2.4-0.2+deb12u1
apt-get -qq -o APT::Sandbox::User=root download "libwebp7=$version" "libwebp-dev=$version"
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >pixels.c <<'CODE'
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <webp/decode.h>
#include <webp/encode.h>
enum { kSide = 8 };
static void shown(const char* name, const uint8_t* before, const uint8_t* file, size_t bytes) {
    int width, height;
    uint8_t* after = WebPDecodeRGBA(file, bytes, &width, &height);
    if (after == NULL) printf("%s: none", name);
    else if (memcmp(before, after, 4 * kSide * kSide) == 0) printf("%s: same", name);
    else printf("%s: %d %d %d for %d %d %d", name, after[0], after[1], after[2], before[0], before[1], before[2]);
    WebPFree(after);
}
static void plain(const char* name, uint8_t* pixels, uint8_t alpha) {
    for (int i = 0; i < kSide * kSide; ++i) pixels[4 * i + 3] = alpha;
    uint8_t* file;
    const size_t bytes = WebPEncodeLosslessRGBA(pixels, kSide, kSide, 4 * kSide, &file);
    shown(name, pixels, file, bytes);
    WebPFree(file);
    printf("; ");
}
int main(void) {
    uint8_t pixels[4 * kSide * kSide];
    for (int i = 0; i < kSide * kSide; ++i) memcpy(pixels + 4 * i, (uint8_t[]){200, 100, 50}, 3);
    plain("opaque", pixels, 255);
    plain("alpha 1", pixels, 1);
    plain("alpha 0", pixels, 0);
    WebPConfig config;
    WebPPicture picture;
    WebPMemoryWriter file;
    WebPMemoryWriterInit(&file);
    if (!WebPConfigInit(&config) || !WebPPictureInit(&picture)) return 2;
    config.lossless = 1;
    config.exact = 1;
    picture.use_argb = 1;
    picture.width = picture.height = kSide;
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = &file;
    if (!WebPPictureImportRGBA(&picture, pixels, 4 * kSide) || !WebPEncode(&config, &picture)) return 3;
    shown("alpha 0 with exact", pixels, file.mem, file.size);
    return 0;
}
CODE
gcc -Iusr/include pixels.c -o pixels "$libraries/libwebp.so.7"
saw=$(LD_LIBRARY_PATH=$libraries ./pixels)
echo "saw: $saw"
[ "$saw" = "opaque: same; alpha 1: same; alpha 0: 0 0 0 for 200 100 50; alpha 0 with exact: same" ]
