#include "engine/render/pixels/mix_pixels.h"

#include <algorithm>
#include <cstddef>

#include "engine/math/wide_vectors.h"

namespace onggi::render {
namespace {

[[gnu::always_inline]] inline void mix_row(const std::uint32_t* from, const std::uint32_t* to,
                                           std::uint32_t part, std::size_t count, std::uint32_t* into) {
    for (std::size_t i = 0; i < count; ++i)
        into[i] = mix_words(from[i], to[i], part);
}

void mix_row_plain(const std::uint32_t* from, const std::uint32_t* to, std::uint32_t part, std::size_t count,
                   std::uint32_t* into) {
    mix_row(from, to, part, count, into);
}

ONGGI_WIDE_VECTORS void mix_row_wide(const std::uint32_t* from, const std::uint32_t* to, std::uint32_t part,
                                     std::size_t count, std::uint32_t* into) {
    mix_row(from, to, part, count, into);
}

}  // namespace

void mix_pixels(std::span<const std::uint32_t> from, std::span<const std::uint32_t> to, float fraction,
                const PixelRect& inside, int width_px, std::span<std::uint32_t> into) {
    const auto part = static_cast<std::uint32_t>(std::clamp(fraction, 0.0F, 1.0F) * 256.0F + 0.5F);
    static auto* const mix = best_of(mix_row_plain, mix_row_wide);
    for (int y = inside.y; y < inside.y + inside.height; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                                  static_cast<std::size_t>(inside.x);
        mix(&from[first], &to[first], part, static_cast<std::size_t>(inside.width), &into[first]);
    }
}

}  // namespace onggi::render
