// A drawing's path, read from the words in which SVG writes one: M L H V C Q A Z, each also small for
// "from here". Any thread. Lengths are the path's own.
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

// Quadratic curves and arcs come out as cubic ones. Bad input: a word that is none of the above, a missing or
// broken number, a path that does not begin with a move; the message says at which letter.
Result<std::vector<PathStep>> read_path(std::string_view words);

}  // namespace onggi::ui
