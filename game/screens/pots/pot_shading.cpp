#include "game/screens/pots/pot_shading.h"

#include <algorithm>
#include <cmath>

#include "game/finish/glaze_surface.h"
#include "game/finish/mark_colour.h"

namespace onggi::screens {
namespace {

const vec3 kKey = glm::normalize(vec3(-0.62F, 0.50F, 0.60F));
const vec3 kFill = glm::normalize(vec3(0.85F, 0.15F, 0.50F));
constexpr vec3 kKeyLight{1.02F, 0.97F, 0.88F};

finish::GlazePlace place_of(const PotSurface& at) {
    return {.height_mm = at.height_mm, .angle = at.angle, .inside = at.inside};
}

}  // namespace

PotShading::PotShading(const finish::GlazeMaterial& glaze, float height_mm, float elevation_rad,
                       const DrawnOn& drawn_on)
    : glaze_(glaze),
      drawn_on_(drawn_on),
      height_mm_(height_mm),
      to_eye_(0.0F, std::sin(elevation_rad), std::cos(elevation_rad)) {}

PotLight PotShading::light(const PotSurface& at) const {
    const vec3 normal =
        glm::normalize(at.normal + vec3(0.0F, finish::kFingerLean * finish::finger_ring(place_of(at)), 0.0F));
    const float facing = glm::dot(normal, kKey);
    const float key = glm::clamp((facing + 0.25F) / 1.25F, 0.0F, 1.0F);
    const float sky = 0.5F + 0.5F * normal.y;
    const float fill = glm::clamp(glm::dot(normal, kFill), 0.0F, 1.0F);
    // The shelf reflects warm light upwards, and the foot is in shadow.
    const float shelf = glm::clamp(-normal.y, 0.0F, 1.0F) * 0.18F;
    const float closed = 1.0F - 0.55F * std::exp(-at.height_mm / (0.08F * height_mm_ + 2.0F));
    const float open = at.inside ? depth_light(at) : closed;
    const vec3 light = kKeyLight * (key * key) + vec3(0.30F, 0.29F, 0.28F) * sky +
                       vec3(0.16F, 0.14F, 0.12F) * fill + vec3(0.9F, 0.65F, 0.42F) * shelf;
    const float coat = finish::is_bare(glaze_, place_of(at)) ? 0.0F : glaze_.clear_coat;
    if (coat > 0.0F) {
        const float cosine = glm::clamp(glm::dot(normal, to_eye_), 0.0F, 1.0F);
        const float f0 =
            (glaze_.ior - 1.0F) * (glaze_.ior - 1.0F) / ((glaze_.ior + 1.0F) * (glaze_.ior + 1.0F));
        const float fresnel = coat * (f0 + (1.0F - f0) * std::pow(1.0F - cosine, 5.0F));
        return {light * (open * (1.0F - fresnel)),
                reflected(glm::reflect(-to_eye_, normal)) * (fresnel * open)};
    }
    const vec3 half = glm::normalize(kKey + to_eye_);
    const float dull = 0.03F * std::pow(glm::clamp(glm::dot(normal, half), 0.0F, 1.0F), 12.0F);
    return {light * open, vec3(dull * open)};
}

vec3 PotShading::colour(const PotSurface& at) const {
    const vec3 own = finish::glaze_colour(glaze_, height_mm_, place_of(at));
    if (drawn_on_.texture() == nullptr || at.inside) return own;
    return finish::marked(
        own, finish::mark_colour(glaze_.marks, drawn_on_.at(at.angle, at.height_mm / height_mm_)));
}

// The light decreases with depth inside the pot.
float PotShading::depth_light(const PotSurface& at) const {
    return 0.22F + 0.78F * std::exp(-(height_mm_ - at.height_mm) / (0.22F * height_mm_ + 4.0F));
}

// A tall window with one bar on the left, a pale room elsewhere.
vec3 PotShading::reflected(const vec3& direction) const {
    const float softness = 0.02F + 0.35F * glaze_.coat_roughness;
    const auto within = [&](float value, float low, float high) {
        return glm::smoothstep(low - softness, low + softness, value) *
               (1.0F - glm::smoothstep(high - softness, high + softness, value));
    };
    const float side = std::atan2(direction.x, direction.z);  // 0: towards the visitor
    const float up = direction.y;
    const float bar = 1.0F - 0.7F * within(side, -0.93F, -0.87F);
    const float window = within(side, -1.28F, -0.55F) * within(up, 0.05F, 0.80F) * bar;
    return vec3(0.10F, 0.09F, 0.08F) * (1.0F + up) + vec3(4.2F, 4.3F, 4.4F) * window;
}

vec3 encoded_pot_light(const vec3& light) {
    const vec3 mapped = light * (1.0F + light / 6.0F) / (1.0F + 0.55F * light);
    return glm::clamp(glm::pow(glm::max(mapped, vec3(0.0F)), vec3(1.0F / 2.2F)), vec3(0.0F), vec3(1.0F));
}

}  // namespace onggi::screens
