// A jar thrown as two bowls and joined rim to rim, as moon jars were: the shape of each bowl, and the width
// of the mouth to cut. Any thread but the haptic one. mm.
#pragma once

#include <vector>

#include "engine/math/math.h"
#include "game/heritage/score.h"

namespace onggi::heritage {

// Whether the table's note is "two joined bowls".
[[nodiscard]] bool is_of_two_bowls(const Target& target);

struct JarOfTwo {
    ThrownSize size;            // of the whole jar
    std::vector<vec2> bowl_mm;  // radius and height, wet, from the foot up to the jar's widest point
    double mouth_mm = 0.0;      // outer diameter, wet, of the mouth to cut into the upper bowl's foot
};

// Both bowls are alike: the jar's lower half. `clay`: the clay for each bowl. Precondition: an outline.
[[nodiscard]] JarOfTwo jar_of_two(const Target& target, clay::ClayBody body, const ThrownClay& clay);

// The size of a museum's pot on this wheel: as large as its lump allows, with the walls that a visitor
// leaves, so that the shown pot can be thrown. A jar of two bowls is thrown from two lumps.
[[nodiscard]] ThrownSize size_on_this_wheel(const Target& target);
// The two bowls of the jar. Precondition: is_of_two_bowls().
[[nodiscard]] JarOfTwo jar_of(const Target& target);
// The target's outline, `scale` times its size: radius and height, from the bottom.
[[nodiscard]] std::vector<vec2> outline_of(const Target& target, double scale);
// The outline at the size at which it is thrown, wet.
[[nodiscard]] std::vector<vec2> wet_outline(const Target& target);

// Deviation of the fired pot from round at its widest ring: the largest minus the smallest distance of its
// wall from the axis of its foot, mm.
[[nodiscard]] double off_round_mm(const clay::StudioClay& clay);

}  // namespace onggi::heritage
