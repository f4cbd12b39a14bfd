// A jar that was thrown as two bowls and joined rim to rim, as moon jars were: what each bowl is, and how
// wide the mouth is cut. Any thread but the haptic one. mm.
#pragma once

#include <vector>

#include "engine/math/math.h"
#include "game/heritage/score.h"

namespace onggi::heritage {

// The table's note says that it was made so: "two joined bowls".
[[nodiscard]] bool is_of_two_bowls(const Target& target);

struct JarOfTwo {
    ThrownSize size;            // of the whole jar
    std::vector<vec2> bowl_mm;  // radius and height, wet, from the foot up to where the jar is widest
    double mouth_mm = 0.0;      // across, wet and outside, where the upper bowl's foot is cut open
};

// Both bowls are alike: the jar's lower half. `clay` is what there is for each of them.
// Precondition: an outline.
[[nodiscard]] JarOfTwo jar_of_two(const Target& target, clay::ClayBody body, const ThrownClay& clay);

// How far the fired pot is from round where it is widest: the largest distance of its wall from the axis of
// its foot less the smallest, mm.
[[nodiscard]] double off_round_mm(const clay::StudioClay& clay);

}  // namespace onggi::heritage
