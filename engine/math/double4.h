// A vector of four doubles, for loops that the compiler does not vectorise by itself. Inline, so that it uses
// the instruction set of its caller. Pure; any thread.
#pragma once

#include <cstring>

namespace onggi {

using Double4 [[gnu::vector_size(32)]] = double;
using Long4 [[gnu::vector_size(32)]] = long long;  // of a comparison: all bits set, or zero

[[gnu::always_inline]] inline Double4 load4(const double* numbers) {
    Double4 found;
    std::memcpy(&found, numbers, sizeof found);
    return found;
}

[[gnu::always_inline]] inline bool any(const Long4& mask) {
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}

}  // namespace onggi
