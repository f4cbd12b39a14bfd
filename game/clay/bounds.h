// Range checks for numbers from outside the program. Any thread; not for the tick.
#pragma once

#include <fmt/format.h>

#include <span>
#include <string_view>

#include "engine/core/result.h"

namespace onggi::clay {

struct Bound {
    std::string_view name;
    double value;
    double least;
    double most;
};

// Returns an error that names the first value that is out of its bounds or NaN.
inline Result<void> check_bounds(std::string_view what, std::span<const Bound> bounds) {
    for (const Bound& bound : bounds) {
        if (!(bound.value >= bound.least && bound.value <= bound.most)) {
            return bad_input(fmt::format("{} {}: expected {} to {}, found {}", what, bound.name, bound.least,
                                         bound.most, bound.value));
        }
    }
    return {};
}

}  // namespace onggi::clay
