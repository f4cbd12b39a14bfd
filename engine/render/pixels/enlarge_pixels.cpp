#include "engine/render/pixels/enlarge_pixels.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/render/pixels/wide_vectors.h"

namespace onggi::render {
namespace {

// Three parts of one pixel and one of another, two channels of four in a word at a time.
[[gnu::always_inline]] inline std::uint32_t mostly(std::uint32_t own, std::uint32_t other) {
    constexpr std::uint32_t kTwo = 0x00FF00FFU;
    constexpr std::uint32_t kHalf = 0x00020002U;
    const std::uint32_t even = (3U * (own & kTwo) + (other & kTwo) + kHalf) >> 2U & kTwo;
    const std::uint32_t odd = (3U * (own >> 8U & kTwo) + (other >> 8U & kTwo) + kHalf) >> 2U & kTwo;
    return even | odd << 8U;
}

[[gnu::always_inline]] inline void mix_rows(const std::uint32_t* own, const std::uint32_t* other,
                                            std::size_t count, std::uint32_t* into) {
    for (std::size_t i = 0; i < count; ++i)
        into[i] = mostly(own[i], other[i]);
}

// row: with a pixel before its first and one behind its last.
[[gnu::always_inline]] inline void widen_row(const std::uint32_t* row, std::size_t width,
                                             std::uint32_t* into) {
    const std::size_t pairs = width / 2;
    for (std::size_t i = 0; i < pairs; ++i) {
        into[2 * i] = mostly(row[i], row[i - 1]);
        into[2 * i + 1] = mostly(row[i], row[i + 1]);
    }
    if (width % 2 == 1) into[width - 1] = mostly(row[pairs], row[pairs - 1]);
}

[[gnu::always_inline]] inline void enlarge(std::span<const std::uint32_t> from, std::size_t width,
                                           std::size_t height, std::uint32_t* into) {
    const std::size_t across = (width + 1) / 2;
    const std::size_t last = (height + 1) / 2 - 1;
    std::vector<std::uint32_t> mixed(across + 2);
    for (std::size_t y = 0; y < height; ++y) {
        const std::size_t own = y / 2;
        const std::size_t other = y % 2 == 1 ? std::min(own + 1, last) : own - std::min<std::size_t>(own, 1);
        mix_rows(from.data() + own * across, from.data() + other * across, across, mixed.data() + 1);
        mixed.front() = mixed[1];
        mixed.back() = mixed[across];
        widen_row(mixed.data() + 1, width, into + y * width);
    }
}

void enlarge_plain(std::span<const std::uint32_t> from, std::size_t width, std::size_t height,
                   std::uint32_t* into) {
    enlarge(from, width, height, into);
}

ONGGI_WIDE_VECTORS void enlarge_wide(std::span<const std::uint32_t> from, std::size_t width,
                                     std::size_t height, std::uint32_t* into) {
    enlarge(from, width, height, into);
}

}  // namespace

void enlarge_pixels(std::span<const std::uint32_t> from, int width, int height,
                    std::span<std::uint32_t> into) {
    static auto* const best = best_of(enlarge_plain, enlarge_wide);
    best(from, static_cast<std::size_t>(width), static_cast<std::size_t>(height), into.data());
}

void enlarge_depth(std::span<const float> from, int width, int height, std::span<float> into) {
    const auto across = static_cast<std::size_t>(half_of(width));
    float* at = into.data();
    for (int y = 0; y < height; ++y) {
        const float* const row = from.data() + static_cast<std::size_t>(y / 2) * across;
        for (int x = 0; x < width; ++x)
            *at++ = row[x / 2];
    }
}

}  // namespace onggi::render
