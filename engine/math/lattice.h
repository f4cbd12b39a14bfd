// Chance that stands still: for grain and glazes, which are the same on every machine. Any thread.
#pragma once

#include <cstdint>

namespace onggi {

// 0 to 1, of a point of whole numbers; its neighbours know nothing of it.
[[nodiscard]] inline float lattice(int x, int y) {
    auto n = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U;
    n = (n ^ (n >> 13U)) * 1274126177U;
    return static_cast<float>((n ^ (n >> 16U)) & 0xffffU) / 65535.0F;
}

}  // namespace onggi
