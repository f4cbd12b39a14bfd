// Reads an SVG path with the commands M L H V C Q A Z, and their lower-case, relative forms. Any thread.
// Lengths are the path's own.
#pragma once

#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/math/math.h"

namespace onggi::ui {

struct PathStep {
    enum class Kind { kMove, kLine, kCurve, kClose };
    Kind kind = Kind::kMove;
    vec2 to{0.0F};
    vec2 first_control{0.0F};  // of a cubic curve
    vec2 second_control{0.0F};
};

// Returns quadratic curves and arcs as cubic curves. Bad input: another command, a missing or malformed
// number, a path that does not begin with a move; the message gives the position.
Result<std::vector<PathStep>> read_path(std::string_view words);

}  // namespace onggi::ui
