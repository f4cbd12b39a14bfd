// A picture of a finished pot that turns: what stays where it is - light, gloss, outline - is worked out
// once, and each picture then costs one look at the pot's own colours a pixel. Any one thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "game/screens/pots/pot_picture.h"
#include "game/screens/pots/pot_samples.h"

namespace onggi::screens {

class TurningPot {
  public:
    // As slow as paint_pot(), which shows it as it stands.
    TurningPot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
               float elevation_rad);

    [[nodiscard]] vec2 foot_px() const { return foot_px_; }
    [[nodiscard]] int width_px() const { return width_; }
    [[nodiscard]] int height_px() const { return height_; }
    // What it holds.
    [[nodiscard]] std::size_t bytes() const {
        return pixels_.size() * sizeof(Pixel) + colours_.size() * sizeof(Colour);
    }
    // turn: how far it has turned, 0 to 1 and round again.
    [[nodiscard]] std::shared_ptr<const ui::Painting> at(double turn) const;

  private:
    using Colour =
        std::array<std::uint16_t, 3>;  // of the clay or glaze: linear, 65535 is all that falls on it
    // A pixel of the picture that shows some of the pot.
    struct Pixel {
        std::uint32_t place = 0;  // of its first byte
        float row = 0.0F;         // of the colours, from the foot up
        float column = 0.0F;      // of them, before it turns
        vec3 factor{0.0F};        // of a colour's numbers
        vec3 gloss{0.0F};
        float cover = 1.0F;  // fraction of the pixel
    };
    // Those of a band's pixels.
    void add_pixels(const PotSamples& samples, const PotShading& shading, const pot::Section& shape,
                    float foot_bare_mm);
    void fill_colours(const pot::Section& shape, const PotShading& shading, bool differs);

    int width_ = 0;
    int height_ = 0;
    vec2 foot_px_{0.0F};
    int columns_ = 0;  // of the colours
    int rows_ = 0;
    std::vector<Pixel> pixels_;
    int inside_from_ = 0;  // the row of the colours where those of the inside begin
    // Rows from the foot up, then the foot's own, then the inside's if it differs.
    std::vector<Colour> colours_;
};

}  // namespace onggi::screens
