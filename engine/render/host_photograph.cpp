#include "engine/render/host_photograph.h"

#include <algorithm>
#include <cstddef>

namespace onggi::render {

HostPhotograph::HostPhotograph(int width, int height, std::span<const std::uint8_t> rgba, ByteOrder order)
    : width_(width),
      height_(height) {
    const auto across = static_cast<std::size_t>(width);
    const std::size_t count = across * static_cast<std::size_t>(height);
    // A row before them and one behind, and what a block reads beyond.
    texels_.resize(count + 2 * across + 8);
    std::uint32_t* const own = texels_.data() + across + 1;
    const std::size_t red = order == ByteOrder::kRedFirst ? 0 : 2;
    for (std::size_t i = 0; i < count; ++i) {
        const auto byte = [&](std::size_t channel) { return std::uint32_t{rgba[4 * i + channel]}; };
        own[i] = byte(red) | byte(1) << 8U | byte(2 - red) << 16U | 0xFF000000U;
    }
    std::copy_n(own, across, own - across);
    std::copy_n(own + count - across, across, own + count);
    texels_.front() = own[0];
}

}  // namespace onggi::render
