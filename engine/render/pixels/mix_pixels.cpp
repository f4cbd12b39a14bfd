#include "engine/render/pixels/mix_pixels.h"

#include <algorithm>
#include <cstddef>

#include "engine/render/pixels/wide_vectors.h"

namespace onggi::render {
namespace {

// How many parts of 256 each has.
struct Weights {
    std::uint32_t from;
    std::uint32_t to;
};

// Two channels of four in a word at a time.
[[gnu::always_inline]] inline void mix_row(const std::uint32_t* from, const std::uint32_t* to,
                                           const Weights& weights, std::size_t count, std::uint32_t* into) {
    constexpr std::uint32_t kTwo = 0x00FF00FFU;
    constexpr std::uint32_t kHalf = 0x00800080U;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t even = (from[i] & kTwo) * weights.from + (to[i] & kTwo) * weights.to + kHalf;
        const std::uint32_t odd =
            (from[i] >> 8U & kTwo) * weights.from + (to[i] >> 8U & kTwo) * weights.to + kHalf;
        into[i] = (even >> 8U & kTwo) | (odd & ~kTwo);
    }
}

void mix_row_plain(const std::uint32_t* from, const std::uint32_t* to, const Weights& weights,
                   std::size_t count, std::uint32_t* into) {
    mix_row(from, to, weights, count, into);
}

ONGGI_WIDE_VECTORS void mix_row_wide(const std::uint32_t* from, const std::uint32_t* to,
                                     const Weights& weights, std::size_t count, std::uint32_t* into) {
    mix_row(from, to, weights, count, into);
}

}  // namespace

void mix_pixels(std::span<const std::uint32_t> from, std::span<const std::uint32_t> to, float share,
                const PixelRect& inside, int width_px, std::span<std::uint32_t> into) {
    const auto of_to = static_cast<std::uint32_t>(std::clamp(share, 0.0F, 1.0F) * 256.0F + 0.5F);
    const Weights weights{256U - of_to, of_to};
    static auto* const mix = best_of(mix_row_plain, mix_row_wide);
    for (int y = inside.y; y < inside.y + inside.height; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                                  static_cast<std::size_t>(inside.x);
        mix(&from[first], &to[first], weights, static_cast<std::size_t>(inside.width), &into[first]);
    }
}

}  // namespace onggi::render
