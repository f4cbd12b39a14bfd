// How much light reaches each point of a turned shape past the shape itself: the sky as ambient occlusion,
// the key light as a soft shadow. Both depend only on the outline, not on the wheel's rotation, so the
// processor computes them per ring. Any thread; pure functions. mm.
#pragma once

#include <array>

#include "engine/math/math.h"
#include "engine/render/shapes/lathe_profile.h"

namespace onggi::render {

enum class LatheFace { kOuter, kInner };

// Returns the visible fraction of the sky for a point on the outside, 0 to 1, cosine-weighted for a vertical
// wall: the part between the outline's horizons above and below.
[[nodiscard]] float open_outside(const LatheSamples& samples, float radius_mm, float y_mm);

// Returns the fraction of the sky that an inside point sees through the mouth, 0 to 1, cosine-weighted about
// its normal (r, y); by a fixed set of rays.
[[nodiscard]] float open_inside(const LatheSamples& samples, float radius_mm, float y_mm, vec2 normal);

struct KeyRay {
    vec3 towards_light{0.0F, 1.0F, 0.0F};  // unit; only its height matters here
    float tangent = 0.05F;                 // of half the light's angular width
};

// The visible fraction of the key light at the points of a ring; it goes from 0 to 1 over the light's width.
// One entry per column, evenly spaced from the light's azimuth to the far side; a ring is symmetrical about
// the light.
constexpr int kKeyColumns = 25;
using KeyColumns = std::array<float, kKeyColumns>;
void key_columns(const LatheSamples& samples, LatheFace face, vec2 place, vec2 normal, const KeyRay& key,
                 KeyColumns& columns);

}  // namespace onggi::render
