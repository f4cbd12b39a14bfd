// Ends the program if a condition does not hold, so that libFuzzer keeps the input.
#pragma once

#include <cstdlib>

namespace onggi::fuzz {

inline void expect(bool holds) {
    if (!holds) std::abort();
}

}  // namespace onggi::fuzz
