#include "engine/render/shapes/lathe_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace onggi::render {
namespace {

constexpr int kSkyRays = 40;
constexpr int kSkySteps = 14;

// Cosine-distributed directions about +Y on a golden-angle spiral: deterministic, and no two of them are
// coplanar with the axis.
const std::array<vec3, kSkyRays>& sky_rays() {
    static const std::array<vec3, kSkyRays> rays = [] {
        std::array<vec3, kSkyRays> made{};
        for (int i = 0; i < kSkyRays; ++i) {
            const float fraction = (static_cast<float>(i) + 0.5F) / kSkyRays;
            const float flat = std::sqrt(fraction);
            const float angle = 2.39996323F * static_cast<float>(i);
            made[static_cast<std::size_t>(i)] = {flat * std::cos(angle), std::sqrt(1.0F - fraction),
                                                 flat * std::sin(angle)};
        }
        return made;
    }();
    return rays;
}

float smooth_step(float from, float to, float value) {
    const float fraction = std::clamp((value - from) / (to - from), 0.0F, 1.0F);
    return fraction * fraction * (3.0F - 2.0F * fraction);
}

// The cosine of each column's azimuth from the light.
const KeyColumns& column_cosines() {
    static const KeyColumns cosines = [] {
        KeyColumns made{};
        for (int i = 0; i < kKeyColumns; ++i)
            made[static_cast<std::size_t>(i)] = std::cos(kPiF * static_cast<float>(i) / (kKeyColumns - 1));
        return made;
    }();
    return cosines;
}

}  // namespace

float open_outside(const LatheSamples& samples, float radius_mm, float y_mm) {
    constexpr int kStride = 8;    // the horizon is formed by the belly, not by a groove
    float steepest_above = 0.0F;  // tangent of the upper horizon's outward angle from vertical
    float steepest_below = 0.0F;
    const float step_mm = samples.per_mm > 0.0F ? 1.0F / samples.per_mm : 0.0F;
    for (int i = kStride / 2; i < LatheSamples::kCount; i += kStride) {
        const float rise = (static_cast<float>(i) + 0.5F) * step_mm - y_mm;
        const float out = samples.outer_mm[static_cast<std::size_t>(i)] - radius_mm;
        // A nearer horizon is the wall's own slope, which the normal accounts for.
        if (rise > 2.0F * kStride * step_mm) steepest_above = std::max(steepest_above, out / rise);
        if (rise < -2.0F * kStride * step_mm) steepest_below = std::max(steepest_below, out / -rise);
    }
    const auto sine_of_view = [](float tangent) { return 1.0F / std::sqrt(1.0F + tangent * tangent); };
    return 0.5F * (sine_of_view(steepest_above) + sine_of_view(steepest_below));
}

float open_inside(const LatheSamples& samples, float radius_mm, float y_mm, vec2 normal) {
    // The point is (radius, y, 0); its frame: the normal, the tangent around, and their perpendicular.
    const vec2 across(normal.y, -normal.x);
    const float widest = *std::max_element(samples.inner_mm.begin(), samples.inner_mm.end());
    const float reach = 2.0F * widest + (samples.height_mm - y_mm);
    float open = 0.0F;
    for (const vec3& ray : sky_rays()) {
        const vec3 direction(normal.x * ray.y + across.x * ray.x, normal.y * ray.y + across.y * ray.x, ray.z);
        bool seen = direction.y > 0.0F;
        for (int step = 1; seen && step <= kSkySteps; ++step) {
            // Short steps first: the occluder is mostly the adjacent wall.
            const float fraction = static_cast<float>(step) / kSkySteps;
            const float t = reach * fraction * fraction;
            const float y = y_mm + direction.y * t;
            if (y >= samples.height_mm) break;
            const float x = radius_mm + direction.x * t;
            const float z = direction.z * t;
            const float limit = samples.inner_mm[samples.at(y)] + 0.3F;
            seen = x * x + z * z < limit * limit;
        }
        if (seen) open += 1.0F;
    }
    return open / kSkyRays;
}

namespace {

// Samples along a ray towards the light, the same for all azimuths.
struct KeySteps {
    static constexpr std::size_t kCount = 16;
    std::array<float, kCount> t{};
    std::array<float, kCount> one_over_t{};
    std::array<float, kCount> wall_mm{};  // radius of the wall at that height
};
KeySteps key_steps(const LatheSamples& samples, LatheFace face, float y_mm, const KeyRay& key) {
    KeySteps steps;
    const float reach = std::max(samples.height_mm - y_mm, 0.1F) / std::max(key.towards_light.y, 0.05F);
    const auto& wall_mm = face == LatheFace::kOuter ? samples.outer_mm : samples.inner_mm;
    for (std::size_t i = 0; i < KeySteps::kCount; ++i) {
        steps.t[i] = reach * static_cast<float>(i + 1) / KeySteps::kCount;
        steps.one_over_t[i] = 1.0F / steps.t[i];
        steps.wall_mm[i] = wall_mm[samples.at(y_mm + key.towards_light.y * steps.t[i])];
    }
    return steps;
}

// flat: horizontal distance for each unit along the ray; cosine: of the azimuth from the light.
float past_lathe(const KeySteps& steps, LatheFace face, float radius_mm, float cosine, float flat,
                 const KeyRay& key) {
    const float x = radius_mm * cosine;
    const float z2 = radius_mm * radius_mm - x * x;
    const float outwards = face == LatheFace::kOuter ? 1.0F : -1.0F;
    float least = 1e3F;
    for (std::size_t i = 0; i < KeySteps::kCount; ++i) {
        const float ahead = x + flat * steps.t[i];
        const float gap = outwards * (std::sqrt(ahead * ahead + z2) - steps.wall_mm[i]);
        least = std::min(least, gap * steps.one_over_t[i]);
    }
    // Along a convex wall the gap opens slowly where the light grazes. The cosine term already shades that,
    // so only points clearly inside the wall count as hidden.
    if (face == LatheFace::kOuter) return smooth_step(-2.0F * key.tangent, 0.25F * key.tangent, least);
    return smooth_step(-key.tangent, key.tangent, least);
}

}  // namespace

void key_columns(const LatheSamples& samples, LatheFace face, vec2 place, vec2 normal, const KeyRay& key,
                 KeyColumns& columns) {
    const float flat = std::hypot(key.towards_light.x, key.towards_light.z);
    const KeyColumns& cosines = column_cosines();
    // Start a little off the wall to avoid self-shadowing.
    const vec2 from = place + 0.5F * normal;
    const KeySteps steps = key_steps(samples, face, from.y, key);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const float cosine = normal.x * flat * cosines[i] + normal.y * key.towards_light.y;
        // Back faces are dark without a shadow test; the light's soft edge must still fade in.
        const bool may_be_lit = cosine > -0.35F;
        columns[i] = may_be_lit ? past_lathe(steps, face, from.x, cosines[i], flat, key)
                                : (face == LatheFace::kOuter ? 1.0F : 0.0F);
    }
}

}  // namespace onggi::render
