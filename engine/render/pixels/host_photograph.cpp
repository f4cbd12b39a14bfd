#include "engine/render/pixels/host_photograph.h"

#include <algorithm>
#include <cstddef>

namespace onggi::render {

HostPhotograph::HostPhotograph(int width, int height, std::span<const std::uint8_t> rgba, ByteOrder order)
    : width_(width),
      height_(height),
      // One row before, one row behind, and a block's overread.
      texels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height + 2) + 8) {
    const std::span<std::uint32_t> own = texels();
    const std::size_t red = order == ByteOrder::kRedFirst ? 0 : 2;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const auto byte = [&](std::size_t channel) { return std::uint32_t{rgba[4 * i + channel]}; };
        own[i] = byte(red) | byte(1) << 8U | byte(2 - red) << 16U | 0xFF000000U;
    }
    fill_border();
}

std::span<std::uint32_t> HostPhotograph::texels() {
    const auto across = static_cast<std::size_t>(width_);
    return std::span(texels_).subspan(across + 1, across * static_cast<std::size_t>(height_));
}

void HostPhotograph::fill_border() {
    const auto across = static_cast<std::size_t>(width_);
    const std::span<std::uint32_t> own = texels();
    std::copy_n(own.begin(), across, texels_.begin() + 1);
    std::copy(own.end() - width_, own.end(),
              texels_.begin() + 1 + static_cast<std::ptrdiff_t>(across + own.size()));
    texels_.front() = own.front();
}

}  // namespace onggi::render
