// Blends two pictures. Any thread; pure. Pixels of four bytes.
#pragma once

#include <cstdint>
#include <span>

#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// Blends `to` over `from` with weight `fraction`, 0 to 1, in steps of 1/256, byte by byte in encoded values;
// inside a rectangle of pictures that are width_px wide. Bit-identical on every processor.
void mix_pixels(std::span<const std::uint32_t> from, std::span<const std::uint32_t> to, float fraction,
                const PixelRect& inside, int width_px, std::span<std::uint32_t> into);

// Blends two four-byte pixels. Inline, so that the code is compiled for its caller's instruction set. Any
// thread; pure.

// `part`/256 of the second pixel, the rest of the first; two channels at a time.
[[gnu::always_inline]] inline std::uint32_t mix_words(std::uint32_t first, std::uint32_t second,
                                                      std::uint32_t part) {
    constexpr std::uint32_t kTwo = 0x00FF00FFU;
    constexpr std::uint32_t kHalf = 0x00800080U;
    const std::uint32_t rest = 256U - part;
    const std::uint32_t even = (first & kTwo) * rest + (second & kTwo) * part + kHalf;
    const std::uint32_t odd = (first >> 8U & kTwo) * rest + (second >> 8U & kTwo) * part + kHalf;
    return (even >> 8U & kTwo) | (odd & ~kTwo);
}

}  // namespace onggi::render
