// A hash noise for grain and glazes, the same on every machine. Any thread.
#pragma once

#include <cstdint>

namespace onggi {

// Returns 0 to 1 for an integer point, uncorrelated between neighbours.
[[nodiscard]] inline float lattice(int x, int y) {
    auto n = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U;
    n = (n ^ (n >> 13U)) * 1274126177U;
    return static_cast<float>((n ^ (n >> 16U)) & 0xffffU) / 65535.0F;
}

}  // namespace onggi
