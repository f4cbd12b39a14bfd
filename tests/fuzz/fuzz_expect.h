// What a fuzz target says when something that must hold does not: it ends the program, and libFuzzer keeps
// the input.
#pragma once

#include <cstdlib>

namespace onggi::fuzz {

inline void expect(bool holds) {
    if (!holds) std::abort();
}

}  // namespace onggi::fuzz
