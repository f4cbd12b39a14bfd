// Zigzag coding: small differences of either sign become small words (0, -1, 1, -2 as 0, 1, 2, 3). Pure.
#pragma once

#include <concepts>
#include <limits>

namespace onggi::record {

template <std::unsigned_integral Word>
constexpr Word folded(Word difference) {
    return (difference << 1U) ^ (Word{0} - (difference >> (std::numeric_limits<Word>::digits - 1)));
}
template <std::unsigned_integral Word>
constexpr Word unfolded(Word word) {
    return (word >> 1U) ^ (Word{0} - (word & 1U));
}

}  // namespace onggi::record
