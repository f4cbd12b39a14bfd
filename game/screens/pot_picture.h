// A small picture of a finished pot, painted on a processor beside the frame: for shelves, niches and cards,
// where many pots stand that nobody touches. Parallel view, slightly from above; window light from the left.
// Any thread; pure.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ui/painting.h"
#include "game/finish/glaze.h"

namespace onggi::screens {

// The wall's section, mm: up the outside from the foot, over the rim, down the inside to the axis. An inside
// that is missing is a solid lump.
struct PotSection {
    std::vector<vec2> outside;  // (radius, height), heights rising
    std::vector<vec2> inside;   // (radius, height), rim first, heights falling; may be empty

    [[nodiscard]] float height_mm() const;
    [[nodiscard]] float radius_mm() const;  // the largest
    [[nodiscard]] std::uint64_t hash() const;
};

// A wall of this thickness inside an outline that is only known from without.
[[nodiscard]] PotSection hollowed(std::vector<vec2> outside, float wall_mm, float floor_mm);

// A fresh lump of one kilogram: about as wide as it is high.
[[nodiscard]] const PotSection& fresh_lump();

// How large its picture is, pixels, and where in it the middle of the foot stands.
struct PotExtent {
    int width_px = 0;
    int height_px = 0;
    vec2 foot_px{0.0F};
};
[[nodiscard]] PotExtent pot_extent(const PotSection& shape, float px_per_mm, float elevation_rad);

struct PotPicture {
    ui::Painting painting;
    // Where the middle of the foot stands, pixels from the top left.
    vec2 foot_px{0.0F};
};

// elevation: of the eye above the horizon. turn: how far the pot has turned, 0 to 1.
[[nodiscard]] PotPicture paint_pot(const PotSection& shape, const finish::GlazeMaterial& glaze,
                                   float px_per_mm, float elevation_rad, float turn = 0.0F);

}  // namespace onggi::screens
