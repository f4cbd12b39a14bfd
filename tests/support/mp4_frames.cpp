#include "tests/support/mp4_frames.h"

#include <wels/codec_api.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

namespace onggi::test {
namespace {

using Span = std::span<const std::byte>;

void expect(bool holds, const std::string& words) {
    if (!holds) throw std::runtime_error("MP4: " + words);
}

std::uint32_t number(Span bytes, std::size_t at, std::size_t size = 4) {
    expect(at + size <= bytes.size(), "a box ends early");
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value = value * 256 + std::to_integer<std::uint32_t>(bytes[at + i]);
    return value;
}

// What follows the header of the first box of that name, and `skipped` bytes.
Span inside(Span boxes, const std::string& name, std::size_t skipped = 0) {
    while (!boxes.empty()) {
        const std::size_t size = number(boxes, 0);
        expect(size >= 8 && size <= boxes.size(), "a box has a wrong size");
        const std::string found(reinterpret_cast<const char*>(boxes.data()) + 4, 4);
        if (found == name) return boxes.subspan(8 + skipped, size - 8 - skipped);
        boxes = boxes.subspan(size);
    }
    throw std::runtime_error("MP4: no box " + name);
}

struct DecoderEnd {
    void operator()(ISVCDecoder* decoder) const {
        decoder->Uninitialize();
        WelsDestroyDecoder(decoder);
    }
};
using Decoder = std::unique_ptr<ISVCDecoder, DecoderEnd>;

Decoder make_decoder() {
    ISVCDecoder* made = nullptr;
    expect(WelsCreateDecoder(&made) == 0, "no decoder");
    Decoder decoder(made);
    int silent = WELS_LOG_QUIET;
    decoder->SetOption(DECODER_OPTION_TRACE_LEVEL, &silent);
    SDecodingParam wanted{};
    wanted.sVideoProperty.eVideoBsType = VIDEO_BITSTREAM_AVC;
    expect(decoder->Initialize(&wanted) == 0, "no decoder");
    return decoder;
}

// Rec. ITU-R BT.601, luma 16 to 235.
asset::Image picture_of(unsigned char* const* planes, const SSysMEMBuffer& form) {
    asset::Image image{.width = form.iWidth, .height = form.iHeight, .rgba = {}};
    for (int y = 0; y < form.iHeight; ++y) {
        for (int x = 0; x < form.iWidth; ++x) {
            const double luma = 1.164 * (planes[0][y * form.iStride[0] + x] - 16);
            const double blue = planes[1][y / 2 * form.iStride[1] + x / 2] - 128;
            const double red = planes[2][y / 2 * form.iStride[1] + x / 2] - 128;
            for (const double value :
                 {luma + 1.596 * red, luma - 0.392 * blue - 0.813 * red, luma + 2.017 * blue})
                image.rgba.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))));
            image.rgba.push_back(255);
        }
    }
    return image;
}

// The decoder may hold pictures back, because those of other encoders are not stored in the order of showing.
void decode(Decoder& decoder, const std::vector<unsigned char>& units, Mp4Frames& into) {
    unsigned char* planes[3] = {};
    SBufferInfo info{};
    expect(decoder->DecodeFrameNoDelay(units.data(), static_cast<int>(units.size()), planes, &info) == 0,
           "a picture was refused");
    if (info.iBufferStatus == 1) into.images.push_back(picture_of(planes, info.UsrData.sSystemBuffer));
}

void take_the_rest(Decoder& decoder, Mp4Frames& into) {
    int left = 0;
    decoder->GetOption(DECODER_OPTION_NUM_OF_FRAMES_REMAINING_IN_BUFFER, &left);
    for (; left > 0; --left) {
        unsigned char* planes[3] = {};
        SBufferInfo info{};
        decoder->FlushFrame(planes, &info);
        if (info.iBufferStatus == 1) into.images.push_back(picture_of(planes, info.UsrData.sSystemBuffer));
    }
}

void add_unit(std::vector<unsigned char>& units, Span unit) {
    units.insert(units.end(), {0, 0, 0, 1});
    for (const std::byte byte : unit)
        units.push_back(std::to_integer<unsigned char>(byte));
}

}  // namespace

Mp4Frames mp4_frames(Span file) {
    const Span index = inside(file, "moov");
    const Span pictures = inside(file, "mdat");
    expect(index.data() < pictures.data(), "the index follows the pictures");
    const Span media = inside(inside(index, "trak"), "mdia");
    const Span table = inside(inside(media, "minf"), "stbl");
    const Span kind = inside(inside(table, "stsd", 8), "avc1", 24);
    const Span settings = inside(kind.subspan(54), "avcC");
    const Span sizes = inside(table, "stsz", 8);
    const Span times = inside(table, "stts", 4);
    const std::uint32_t count = number(sizes, 0);
    Mp4Frames frames;
    frames.lasts_ms = static_cast<int>(number(inside(index, "mvhd"), 16));
    for (const std::uint32_t other : {number(inside(media, "mdhd"), 16), number(times, 4) * number(times, 8)})
        expect(frames.lasts_ms == static_cast<int>(other), "two durations");
    expect(number(inside(index, "mvhd"), 12) == 1000 && number(times, 0) == 1 && number(times, 4) == count,
           "another clock");
    expect(number(inside(table, "stsc", 8), 4) == count, "more than one chunk");
    const Span keys = inside(table, "stss", 8);
    for (std::size_t at = 0; at < keys.size(); at += 4)
        frames.keys.push_back(static_cast<int>(number(keys, at)) - 1);

    Decoder decoder = make_decoder();
    std::vector<unsigned char> units;
    const std::size_t sps = number(settings, 6, 2);
    add_unit(units, settings.subspan(8, sps));
    add_unit(units, settings.subspan(8 + sps + 3, number(settings, 8 + sps + 1, 2)));
    std::size_t at = number(inside(table, "stco", 8), 0);
    expect(file.data() + at == pictures.data(), "the index names another place");
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::size_t end = at + number(sizes, 4 + 4 * std::size_t{i});
        while (at < end) {
            const std::size_t size = number(file, at);
            expect(size > 0 && at + 4 + size <= end, "a unit has a wrong size");
            add_unit(units, file.subspan(at + 4, size));
            at += 4 + size;
        }
        decode(decoder, units, frames);
        units.clear();
    }
    take_the_rest(decoder, frames);
    expect(frames.images.size() == count, "a picture is missing");
    for (const asset::Image& image : frames.images)
        expect(image.width == static_cast<int>(number(kind, 0, 2)) &&
                   image.height == static_cast<int>(number(kind, 2, 2)),
               "two sizes");
    return frames;
}

}  // namespace onggi::test
