// The pixels of a picture of a pot in two parts: what stays where it is while the pot turns - light, gloss,
// outline - and the pot's own colours, which go round under it. Any thread. mm; linear light.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/ui/painting.h"
#include "game/screens/pots/pot_samples.h"

namespace onggi::screens {

// The colours of a pot's outside and inside, laid flat: about one for each pixel of its picture.
class PotColours {
  public:
    // extent: of the picture that they are for.
    PotColours(float height_mm, const finish::GlazeMaterial& glaze, const PotShading& shading,
               const PotExtent& extent, bool is_drawn_on);

    // Rows from the foot up, then the foot's own, then the inside's if it differs.
    [[nodiscard]] float row_of(const PotSurface& surface, bool inside) const;
    // Before the pot turns.
    [[nodiscard]] float column_of(const PotSurface& surface) const;
    // turn: how far it has turned, 0 to 1 and round again; in columns.
    [[nodiscard]] float columns_turned(double turn) const;
    // Between two columns, so that it turns smoothly, and two rows, so that its rings have no steps.
    // column: with those turned, not negative.
    [[nodiscard]] vec3 at(float row, float column) const;

    [[nodiscard]] std::size_t bytes() const { return colours_.size() * sizeof(Colour); }

  private:
    using Colour = std::array<std::uint16_t, 3>;  // 65535: all the light that falls on it comes back

    void fill(int first_row, bool inside, const PotShading& shading);

    int columns_;
    int rows_;
    float height_mm_;
    float foot_bare_mm_;
    int inside_from_ = 0;  // the row where those of the inside begin
    std::vector<Colour> colours_;
};

// One that shows some of the pot.
struct PotPixel {
    std::uint32_t place = 0;  // of its first byte
    float row = 0.0F;         // of the colours
    float column = 0.0F;      // of them, before it turns
    vec3 factor{0.0F};
    vec3 gloss{0.0F};
    float cover = 1.0F;  // fraction of the pixel
};

// A finished pot in one view and one light.
struct LitPot {
    LitPot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
           float elevation_rad);
    LitPot(const LitPot&) = delete;  // its shading knows what was drawn on it
    LitPot& operator=(const LitPot&) = delete;

    DrawnOn drawn_on;
    PotShading shading;
    PotView view;
    PotColours colours;
};

// Those of a band's samples, after what is there.
void add_pixels(const PotSamples& samples, const LitPot& pot, std::vector<PotPixel>& pixels);

// Sets them in a painting of the picture's size.
void paint_pixels(const std::vector<PotPixel>& pixels, const PotColours& colours, double turn,
                  ui::Painting& painting);

// All of it transparent.
[[nodiscard]] ui::Painting empty_painting(const PotExtent& extent);

}  // namespace onggi::screens
