// A picture of half the width and height, at its whole size. Any thread; pure. Pixels.
#pragma once

#include <cstdint>
#include <span>

namespace onggi::render {

// Half of a width or a height, the odd one kept.
[[nodiscard]] constexpr int half_of(int length_px) {
    return (length_px + 1) / 2;
}

// into: width x height pixels of four bytes; from: half_of() both, at least one. Bilinear: a pixel is three
// parts of the one it lies in and one of the next, both ways. A processor without wider vectors makes the
// same bits.
void enlarge_pixels(std::span<const std::uint32_t> from, int width, int height,
                    std::span<std::uint32_t> into);

// Depth is not mixed: between two things there is nothing.
void enlarge_depth(std::span<const float> from, int width, int height, std::span<float> into);

}  // namespace onggi::render
