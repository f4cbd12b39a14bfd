// The shading of a finished pot at a point of its surface, for pictures rendered on the CPU: glaze, clay and
// window light. Any thread; pure. mm, rad; linear light.
#pragma once

#include <numbers>
#include <optional>

#include "engine/math/math.h"
#include "game/decoration/texture.h"
#include "game/finish/glaze.h"
#include "game/pot/section.h"

namespace onggi::screens {

// One sample of the surface.
struct PotSurface {
    float height_mm = 0.0F;
    float angle = 0.0F;  // about the axis, in the pot's frame; 0 is the side that faced front in the kiln
    vec3 normal{0.0F, 0.0F, 1.0F};  // in the view: x right, y up, z to the eye
    bool inside = false;
};

// A point's light is its colour times `factor`, plus `gloss`.
struct PotLight {
    vec3 factor{1.0F};
    vec3 gloss{0.0F};
};

// A pot's decoration as a texture for its pictures.
class DrawnOn {
  public:
    explicit DrawnOn(const pot::Section& shape) {
        if (!shape.marks) return;
        texture_.emplace(decoration::texture_of(*shape.marks));
        front_ = shape.front_turns();
    }
    // The texel at an angle about the axis, 0 in front. Precondition: there is a decoration.
    [[nodiscard]] const decoration::Texel& at(float angle, float height_fraction) const {
        const float turns = front_ + 0.5F * angle * std::numbers::inv_pi_v<float>;
        return texture_->at(decoration::column_at(turns), decoration::row_at(height_fraction));
    }
    // Null without decoration.
    [[nodiscard]] const decoration::Texture* texture() const { return texture_ ? &*texture_ : nullptr; }

  private:
    std::optional<decoration::Texture> texture_;
    float front_ = decoration::kPlainFront;  // the direction that is in front
};

class PotShading {
  public:
    // Glaze and decoration must outlive it.
    PotShading(const finish::GlazeMaterial& glaze, float height_mm, float elevation_rad,
               const DrawnOn& drawn_on);

    // The light, which is fixed while the pot turns.
    [[nodiscard]] PotLight light(const PotSurface& at) const;
    // The colour, which turns with the pot.
    [[nodiscard]] vec3 colour(const PotSurface& at) const;

  private:
    [[nodiscard]] float depth_light(const PotSurface& at) const;
    [[nodiscard]] vec3 reflected(const vec3& direction) const;

    const finish::GlazeMaterial& glaze_;
    const DrawnOn& drawn_on_;
    float height_mm_;
    vec3 to_eye_;
};

// Softly compresses highlights, then encodes approximately as sRGB, 0 to 1.
[[nodiscard]] vec3 encoded_pot_light(const vec3& light);

}  // namespace onggi::screens
