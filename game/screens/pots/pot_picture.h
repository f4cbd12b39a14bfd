// A small picture of a finished pot, rendered on the CPU beside the frame, for the many pots of shelves,
// niches and cards. Orthographic view, slightly from above; window light from the left. Any thread; pure.
#pragma once

#include "engine/ui/painting.h"
#include "game/finish/glaze.h"
#include "game/pot/section.h"

namespace onggi::screens {

// The size of a pot's picture in pixels, and the foot's centre in it.
struct PotExtent {
    int width_px = 0;
    int height_px = 0;
    vec2 foot_px{0.0F};
};
[[nodiscard]] PotExtent pot_extent(const pot::Section& shape, float px_per_mm, float elevation_rad);

struct PotPicture {
    ui::Painting painting;
    // The foot's centre, in pixels from the top left.
    vec2 foot_px{0.0F};
};

// Samples per pixel in each direction: of the screens' pictures, and of those that leave the kiosk, which
// have time. Fewer break ridges that are finer than a pixel into dots.
constexpr int kScreenSamples = 2;
constexpr int kLeavingSamples = 4;

// elevation_rad: of the eye above the horizon. The pot is turned by `turn` turns.
[[nodiscard]] PotPicture paint_pot(const pot::Section& shape, const finish::GlazeMaterial& glaze,
                                   float px_per_mm, float elevation_rad, double turn = 0.0,
                                   int samples_across = kScreenSamples);

}  // namespace onggi::screens
