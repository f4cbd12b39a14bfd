// Converts a fraction to an 8-bit value for pictures and textures. Any thread.
#pragma once

#include <algorithm>
#include <cstdint>

namespace onggi {

// Maps 0 to 1 to 0 to 255, rounded; values outside are clamped.
[[nodiscard]] inline std::uint8_t eight_bits(float fraction) {
    // Not std::lround, which is a call into a library for every channel of a texel. The sum is exact.
    return static_cast<std::uint8_t>(static_cast<double>(255.0F * std::clamp(fraction, 0.0F, 1.0F)) + 0.5);
}

}  // namespace onggi
