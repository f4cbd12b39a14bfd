// The look of a glaze at each place of a pot: pools, runs, breaks, and bare clay. Any thread; pure. mm, rad;
// linear light.
#pragma once

#include "engine/math/math.h"
#include "game/finish/glaze.h"

namespace onggi::finish {

struct GlazePlace {
    float height_mm = 0.0F;
    float angle = 0.0F;  // about the axis, in the pot's frame; 0 was the front when it left the kiln
    bool inside = false;
};

// Throwing rings under the glaze, about -1 to 1: finer than the outline, so they only affect normal and
// colour. kFingerLean: slope of the normal per unit.
constexpr float kFingerLean = 0.045F;
[[nodiscard]] float finger_ring(const GlazePlace& at);

// Whether the glaze was wiped off here before firing.
[[nodiscard]] inline bool is_bare(const GlazeMaterial& glaze, const GlazePlace& at) {
    return !at.inside && at.height_mm < glaze.foot_bare_mm;
}

// The colour on a pot of that height.
[[nodiscard]] vec3 glaze_colour(const GlazeMaterial& glaze, float height_mm, const GlazePlace& at);

}  // namespace onggi::finish
