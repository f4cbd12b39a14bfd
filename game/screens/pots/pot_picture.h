// A small picture of a finished pot, painted on a processor beside the frame: for shelves, niches and cards,
// where many pots stand that nobody touches. Parallel view, slightly from above; window light from the left.
// Any thread; pure.
#pragma once

#include "engine/ui/painting.h"
#include "game/finish/glaze.h"
#include "game/pot/section.h"

namespace onggi::screens {

// How large its picture is, pixels, and where in it the middle of the foot stands.
struct PotExtent {
    int width_px = 0;
    int height_px = 0;
    vec2 foot_px{0.0F};
};
[[nodiscard]] PotExtent pot_extent(const pot::Section& shape, float px_per_mm, float elevation_rad);

struct PotPicture {
    ui::Painting painting;
    // Where the middle of the foot stands, pixels from the top left.
    vec2 foot_px{0.0F};
};

// elevation: of the eye above the horizon.
[[nodiscard]] PotPicture paint_pot(const pot::Section& shape, const finish::GlazeMaterial& glaze,
                                   float px_per_mm, float elevation_rad);

}  // namespace onggi::screens
