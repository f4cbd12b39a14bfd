// A fraction as the eight bits that pictures and textures keep of it. Any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace onggi {

// 0 to 1 as 0 to 255, to the nearest; what lies beyond is the nearer end.
[[nodiscard]] inline std::uint8_t eight_bits(float fraction) {
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(fraction, 0.0F, 1.0F)));
}

}  // namespace onggi
