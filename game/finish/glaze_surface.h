// What a glaze looks like at each place of a pot: where it pools, runs and breaks, and where there is none.
// Any thread; pure. mm, rad; linear light.
#pragma once

#include "engine/math/math.h"
#include "game/finish/glaze.h"

namespace onggi::finish {

struct GlazePlace {
    float height_mm = 0.0F;
    float angle = 0.0F;  // about the axis, of the pot itself; 0 was in front when it came out of the kiln
    bool inside = false;
};

// The fingers' rings under it, about -1 to 1: finer than the outline, so they are in the normal and the
// colour. The normal leans up by so much of it.
constexpr float kFingerLean = 0.045F;
[[nodiscard]] float finger_ring(const GlazePlace& at);

// Wiped off before firing.
[[nodiscard]] inline bool is_bare(const GlazeMaterial& glaze, const GlazePlace& at) {
    return !at.inside && at.height_mm < glaze.foot_bare_mm;
}

// Of a pot of that height.
[[nodiscard]] vec3 glaze_colour(const GlazeMaterial& glaze, float height_mm, const GlazePlace& at);

}  // namespace onggi::finish
