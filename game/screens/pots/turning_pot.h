// A picture of a finished pot that turns. The fixed part (light, gloss, outline) is computed once; each
// picture then costs one colour lookup per pixel. One thread at a time.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "game/screens/pots/pot_picture.h"
#include "game/screens/pots/pot_pixels.h"

namespace onggi::screens {

class TurningPot {
  public:
    // Takes about as long as paint_pot(), which paints one view.
    TurningPot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
               float elevation_rad);

    [[nodiscard]] vec2 foot_px() const { return extent_.foot_px; }
    [[nodiscard]] int width_px() const { return extent_.width_px; }
    [[nodiscard]] int height_px() const { return extent_.height_px; }
    // Bytes of memory in use.
    [[nodiscard]] std::size_t bytes() const { return pixels_.size() * sizeof(PotPixel) + colours_.bytes(); }
    // Returns the picture at a rotation of `turn` turns, modulo 1.
    [[nodiscard]] std::shared_ptr<const ui::Painting> at(double turn) const;

  private:
    explicit TurningPot(LitPot&& pot);

    PotExtent extent_;
    std::vector<PotPixel> pixels_;
    PotColours colours_;
};

}  // namespace onggi::screens
