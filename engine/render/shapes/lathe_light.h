// How much light reaches each place of a turned shape past the rest of it: the sky as ambient occlusion, the
// key light as a soft shadow. Both depend on the outline alone, not on how far the wheel has turned, so they
// are worked out per ring on the processor. Any thread; pure functions. mm.
#pragma once

#include <array>

#include "engine/math/math.h"
#include "engine/render/shapes/lathe_profile.h"

namespace onggi::render {

enum class LatheFace { kOuter, kInner };

// The sky that a place of the outside sees, 0 to 1, weighted by the cosine to an upright wall: between the
// horizons that the outline makes above and below it.
[[nodiscard]] float open_outside(const LatheSamples& samples, float radius_mm, float y_mm);

// The sky that a place inside sees through the mouth, 0 to 1, weighted by the cosine to its normal (r, y): by
// rays, always the same ones.
[[nodiscard]] float open_inside(const LatheSamples& samples, float radius_mm, float y_mm, vec2 normal);

struct KeyRay {
    vec3 towards_light{0.0F, 1.0F, 0.0F};  // unit; only its height counts here
    float tangent = 0.05F;                 // of half the light's width
};

// The fraction of the key light that gets past the shape to the places of a ring: between none and all over
// the width of the light. One entry a column, evenly from the light's azimuth to the far side; a ring is
// symmetrical about the light.
constexpr int kKeyColumns = 25;
using KeyColumns = std::array<float, kKeyColumns>;
void key_columns(const LatheSamples& samples, LatheFace face, vec2 place, vec2 normal, const KeyRay& key,
                 KeyColumns& columns);

}  // namespace onggi::render
