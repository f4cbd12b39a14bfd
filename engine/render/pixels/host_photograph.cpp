#include "engine/render/pixels/host_photograph.h"

#include <algorithm>
#include <cstddef>

namespace onggi::render {

HostPhotograph::HostPhotograph(int width, int height)
    : width_(width),
      height_(height),
      // A row before them and one behind, and what a block reads beyond.
      texels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height + 2) + 8) {}

HostPhotograph::HostPhotograph(int width, int height, std::span<const std::uint8_t> rgba, ByteOrder order)
    : HostPhotograph(width, height) {
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

HostPhotograph HostPhotograph::halved() const {
    if (width_ < 2 || height_ < 2) return *this;
    HostPhotograph half(width_ / 2, height_ / 2);
    const std::span<std::uint32_t> into = half.texels();
    const auto across = static_cast<std::size_t>(width_);
    const std::uint32_t* const from = first();
    const auto columns = static_cast<std::size_t>(half.width_);
    for (std::size_t row = 0; row < static_cast<std::size_t>(half.height_); ++row) {
        const std::uint32_t* const upper = from + 2 * row * across;
        const std::uint32_t* const lower = upper + across;
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t left = 2 * column;
            constexpr std::uint32_t kTwo = 0x00FF00FFU;  // channels of four in a word
            const auto mean = [&](unsigned shift) {
                const std::uint32_t sum = (upper[left] >> shift & kTwo) + (upper[left + 1] >> shift & kTwo) +
                                          (lower[left] >> shift & kTwo) + (lower[left + 1] >> shift & kTwo);
                return (sum + 0x00020002U) >> 2U & kTwo;
            };
            into[row * columns + column] = mean(0) | mean(8) << 8U;
        }
    }
    half.fill_border();
    return half;
}

}  // namespace onggi::render
