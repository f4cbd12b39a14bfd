// The pixels of a pot's picture in two parts: light, gloss and outline are fixed, and the pot's own colours
// rotate under them. Any thread. mm; linear light.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/ui/painting.h"
#include "game/screens/pots/pot_samples.h"

namespace onggi::screens {

// The colours of a pot's outside and inside as a flat texture, about one texel per pixel of its picture.
class PotColours {
  public:
    // extent: the size of the picture.
    PotColours(float height_mm, const finish::GlazeMaterial& glaze, const PotShading& shading,
               const PotExtent& extent, bool is_drawn_on);

    // Rows ascend from the foot, then follow the foot's own row and, if it differs, the inside's.
    [[nodiscard]] float row_of(const PotSurface& surface, bool inside) const;
    // The column at rotation 0.
    [[nodiscard]] float column_of(const PotSurface& surface) const;
    // Converts a rotation, in turns modulo 1, to columns.
    [[nodiscard]] float columns_turned(double turn) const;
    // Interpolates between columns, so that the rotation is smooth, and between rows, so that rings show no
    // steps. `column` includes the rotation and is not negative.
    [[nodiscard]] vec3 at(float row, float column) const;

    [[nodiscard]] std::size_t bytes() const { return colours_.size() * sizeof(Colour); }

  private:
    using Colour = std::array<std::uint16_t, 3>;  // 65535: reflects all light

    void fill(int first_row, bool inside, const PotShading& shading);

    int columns_;
    int rows_;
    float height_mm_;
    float foot_bare_mm_;
    int inside_from_ = 0;  // first row of the inside
    std::vector<Colour> colours_;
};

// A pixel that shows part of the pot.
struct PotPixel {
    std::uint32_t place = 0;  // offset of its first byte
    float row = 0.0F;         // row in the colours
    float column = 0.0F;      // column at rotation 0
    vec3 factor{0.0F};
    vec3 gloss{0.0F};
    float cover = 1.0F;  // covered fraction of the pixel
};

// A finished pot in one view and one light.
struct LitPot {
    LitPot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
           float elevation_rad, double turn = 0.0, int samples_across = kScreenSamples);
    LitPot(const LitPot&) = delete;  // its shading points to its decoration
    LitPot& operator=(const LitPot&) = delete;

    DrawnOn drawn_on;
    PotShading shading;
    PotView view;
    PotColours colours;
};

// Appends the pixels of a band's samples.
void add_pixels(const PotSamples& samples, const LitPot& pot, std::vector<PotPixel>& pixels);

// Writes the pixels into a painting of the picture's size.
void paint_pixels(const std::vector<PotPixel>& pixels, const PotColours& colours, double turn,
                  ui::Painting& painting);

// Paints a whole view of the pot, a band at a time, because the pixels of a large picture take many MB.
// `turn` is the view's.
void paint_view(const PotView& view, const LitPot& pot, double turn, ui::Painting& painting);

// Returns a transparent painting.
[[nodiscard]] ui::Painting empty_painting(const PotExtent& extent);

}  // namespace onggi::screens
