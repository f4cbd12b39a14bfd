// A picture of a finished pot that turns. Of a round one the fixed part (light, gloss, outline) is computed
// once; each picture then costs one colour lookup per pixel. One that is not round is painted anew for each
// of kBentViews views. One thread at a time.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "game/screens/pots/pot_picture.h"
#include "game/screens/pots/pot_pixels.h"

namespace onggi::screens {

class TurningPot {
  public:
    // A whole turn: a view takes 0.1 to 0.2 s of a core, so that more would cost more than the colours of a
    // round pot.
    static constexpr int kBentViews = 8;

    // Takes about as long as paint_pot(), which paints one view.
    TurningPot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
               float elevation_rad);
    ~TurningPot();
    TurningPot(const TurningPot&) = delete;
    TurningPot& operator=(const TurningPot&) = delete;

    [[nodiscard]] vec2 foot_px() const { return extent_.foot_px; }
    [[nodiscard]] int width_px() const { return extent_.width_px; }
    [[nodiscard]] int height_px() const { return extent_.height_px; }
    // Bytes of memory in use.
    [[nodiscard]] std::size_t bytes() const;
    // Returns the picture at a rotation of `turn` turns, modulo 1.
    [[nodiscard]] std::shared_ptr<const ui::Painting> at(double turn) const;

  private:
    struct Bent;  // a pot that is not round

    PotExtent extent_;
    std::vector<PotPixel> pixels_;
    std::optional<PotColours> colours_;
    std::unique_ptr<Bent> bent_;
};

}  // namespace onggi::screens
