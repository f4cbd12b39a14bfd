// Numbers that somebody else chose, held to their bounds. Any thread; not for the tick.
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

// Error: the first that is out of its bounds, or no number.
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
