#!/usr/bin/env bash
# Package: libopenh264-7, libopenh264-dev 2.3.1+dfsg-3+deb12u2 (Debian 12).
# Behaviour: the encoder takes a size of 301x201 and pictures of that size, returns success for each call, and writes a
# stream of 300x200 without a crop: the last column and row are gone. A size of 15x15 is taken too; then each picture
# fails.
# Expected: the size in the stream, by H.264's frame cropping as other encoders do with odd sizes, or an error at once.
# Why it matters: a container whose header has the asked size disagrees with its stream; players scale or show an edge.
# Write the container with even sides, and refuse below 16 pixels.
# Seen:
#   301x201: taken 0, stream 300x200; 15x15: taken 0, pictures coded 0 of 2
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=2.3.1+dfsg-3+deb12u2
apt-get -qq -o APT::Sandbox::User=root download "libopenh264-7=$version" "libopenh264-dev=$version"
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >odd.cpp <<'CODE'
#include <wels/codec_api.h>
#include <cstdio>
#include <string>
#include <vector>
constexpr int kPictures = 2;
std::string encoded(int width, int height) {
    int quiet = WELS_LOG_QUIET;
    ISVCEncoder* encoder = nullptr;
    ISVCDecoder* decoder = nullptr;
    if (WelsCreateSVCEncoder(&encoder) != 0 || WelsCreateDecoder(&decoder) != 0) return "none";
    encoder->SetOption(ENCODER_OPTION_TRACE_LEVEL, &quiet);
    decoder->SetOption(DECODER_OPTION_TRACE_LEVEL, &quiet);
    SEncParamBase wish{};
    wish.iUsageType = CAMERA_VIDEO_REAL_TIME;
    wish.iPicWidth = width;
    wish.iPicHeight = height;
    wish.iTargetBitrate = 500'000;
    wish.iRCMode = RC_OFF_MODE;
    wish.fMaxFrameRate = 10.0F;
    std::string said = "taken " + std::to_string(encoder->Initialize(&wish));
    SDecodingParam reading{};
    reading.sVideoProperty.eVideoBsType = VIDEO_BITSTREAM_AVC;
    decoder->Initialize(&reading);
    const int half_width = (width + 1) / 2;
    const int half_height = (height + 1) / 2;
    std::vector<unsigned char> light(static_cast<std::size_t>(width * height), 90);
    std::vector<unsigned char> colour(static_cast<std::size_t>(half_width * half_height), 128);
    int coded = 0;
    std::vector<unsigned char> stream;
    for (int i = 0; i < kPictures; ++i) {
        SSourcePicture picture{};
        picture.iColorFormat = videoFormatI420;
        picture.iPicWidth = width;
        picture.iPicHeight = height;
        picture.iStride[0] = width;
        picture.iStride[1] = picture.iStride[2] = half_width;
        picture.pData[0] = light.data();
        picture.pData[1] = picture.pData[2] = colour.data();
        picture.uiTimeStamp = 100 * i;
        SFrameBSInfo bits{};
        if (encoder->EncodeFrame(&picture, &bits) == cmResultSuccess) ++coded;
        for (int layer = 0; layer < bits.iLayerNum; ++layer) {
            const SLayerBSInfo& part = bits.sLayerInfo[layer];
            int bytes = 0;
            for (int unit = 0; unit < part.iNalCount; ++unit) bytes += part.pNalLengthInByte[unit];
            stream.insert(stream.end(), part.pBsBuf, part.pBsBuf + bytes);
        }
    }
    unsigned char* planes[3]{};
    SBufferInfo shown{};
    if (coded == kPictures) {
        decoder->DecodeFrameNoDelay(stream.data(), static_cast<int>(stream.size()), planes, &shown);
        const SSysMEMBuffer& size = shown.UsrData.sSystemBuffer;
        said += ", stream " + std::to_string(size.iWidth) + "x" + std::to_string(size.iHeight);
    } else {
        said += ", pictures coded " + std::to_string(coded) + " of " + std::to_string(kPictures);
    }
    decoder->Uninitialize();
    WelsDestroyDecoder(decoder);
    encoder->Uninitialize();
    WelsDestroySVCEncoder(encoder);
    return said;
}
int main() { std::printf("301x201: %s; 15x15: %s", encoded(301, 201).c_str(), encoded(15, 15).c_str()); }
CODE
g++ -std=c++17 -Iusr/include odd.cpp -o odd "$libraries/libopenh264.so.7"
saw=$(LD_LIBRARY_PATH=$libraries ./odd)
echo "saw: $saw"
[ "$saw" = "301x201: taken 0, stream 300x200; 15x15: taken 0, pictures coded 0 of 2" ]
