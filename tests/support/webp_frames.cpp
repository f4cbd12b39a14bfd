#include "tests/support/webp_frames.h"

#include <webp/demux.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace onggi::test {

WebpFrames webp_frames(std::span<const std::byte> file) {
    const WebPData data{reinterpret_cast<const std::uint8_t*>(file.data()), file.size()};
    const std::unique_ptr<WebPAnimDecoder, void (*)(WebPAnimDecoder*)> decoder(
        WebPAnimDecoderNew(&data, nullptr), WebPAnimDecoderDelete);
    WebPAnimInfo info;
    if (!decoder || WebPAnimDecoderGetInfo(decoder.get(), &info) == 0)
        throw std::runtime_error("expected an animated WebP");
    WebpFrames frames;
    frames.plays = static_cast<int>(info.loop_count);
    while (WebPAnimDecoderHasMoreFrames(decoder.get()) != 0) {
        std::uint8_t* pixels = nullptr;
        int end_ms = 0;
        if (WebPAnimDecoderGetNext(decoder.get(), &pixels, &end_ms) == 0)
            throw std::runtime_error("expected another frame");
        asset::Image image{.width = static_cast<int>(info.canvas_width),
                           .height = static_cast<int>(info.canvas_height),
                           .rgba = {}};
        image.rgba.assign(pixels, pixels + std::size_t{4} * info.canvas_width * info.canvas_height);
        frames.images.push_back(std::move(image));
        frames.ends_ms.push_back(end_ms);
    }
    return frames;
}

double mean_difference(const asset::Image& a, const asset::Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
        sum += std::abs(static_cast<double>(a.rgba[i]) - static_cast<double>(b.rgba[i]));
    return sum / static_cast<double>(a.rgba.size());
}

}  // namespace onggi::test
