// What a finished pot looks like at one place of its surface, for pictures that a processor paints: glaze and
// clay, and the window light they stand in. Any thread; pure. mm, rad; linear light.
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
    float angle = 0.0F;  // about the axis, of the pot itself; 0 was in front when it came out of the kiln
    vec3 normal{0.0F, 0.0F, 1.0F};  // as it stands: x right, y up, z to the eye
    bool inside = false;
};

// The light of a place is its own colour times `factor`, and `gloss` besides.
struct PotLight {
    vec3 factor{1.0F};
    vec3 gloss{0.0F};
};

// What was drawn on a pot, laid for its pictures.
class DrawnOn {
  public:
    explicit DrawnOn(const pot::Section& shape) {
        if (!shape.marks) return;
        texture_.emplace(decoration::texture_of(*shape.marks));
        front_ = decoration::front_of(shape.marks->recorded.strokes);
    }
    // The texel at an angle about the axis that is 0 in front. Precondition: something was.
    [[nodiscard]] const decoration::Texel& at(float angle, float height_fraction) const {
        const float turns = front_ + 0.5F * angle * std::numbers::inv_pi_v<float>;
        return texture_->at(decoration::column_at(turns), decoration::row_at(height_fraction));
    }
    // Null: nothing was.
    [[nodiscard]] const decoration::Texture* texture() const { return texture_ ? &*texture_ : nullptr; }

  private:
    std::optional<decoration::Texture> texture_;
    float front_ = decoration::kPlainFront;  // the direction that is shown in front
};

class PotShading {
  public:
    // Both outlive it.
    PotShading(const finish::GlazeMaterial& glaze, float height_mm, float elevation_rad,
               const DrawnOn& drawn_on);

    // What stays where it is while the pot turns.
    [[nodiscard]] PotLight light(const PotSurface& at) const;
    // What turns with it.
    [[nodiscard]] vec3 colour(const PotSurface& at) const;

  private:
    [[nodiscard]] float depth_light(const PotSurface& at) const;
    [[nodiscard]] vec3 reflected(const vec3& direction) const;

    const finish::GlazeMaterial& glaze_;
    const DrawnOn& drawn_on_;
    float height_mm_;
    vec3 to_eye_;
};

// A soft shoulder for the highlights, then sRGB, nearly: 0 to 1.
[[nodiscard]] vec3 encoded_pot_light(const vec3& light);

}  // namespace onggi::screens
