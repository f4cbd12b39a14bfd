#include "game/screens/pots/pot_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "game/screens/pots/pot_pixels.h"

namespace onggi::screens {

PotExtent pot_extent(const pot::Section& shape, float px_per_mm, float elevation_rad) {
    constexpr float kMarginPx = 2.0F;
    const float sine = std::sin(elevation_rad);
    const float half_width = shape.radius_mm() * px_per_mm + kMarginPx;
    const float above =
        (shape.height_mm() * std::cos(elevation_rad) + shape.radius_mm() * sine) * px_per_mm + kMarginPx;
    const float below = shape.radius_mm() * sine * px_per_mm + kMarginPx;
    const auto whole = [](float value) { return std::max(1, static_cast<int>(std::ceil(value))); };
    PotExtent extent{.width_px = whole(2.0F * half_width), .height_px = whole(above + below)};
    extent.foot_px = {0.5F * static_cast<float>(extent.width_px), above};
    return extent;
}

PotPicture paint_pot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
                     float elevation_rad, double turn, int samples_across) {
    const LitPot pot(shape, glaze, px_per_mm, elevation_rad, turn, samples_across);
    PotPicture picture{.painting = empty_painting(pot.view.extent()), .foot_px = pot.view.extent().foot_px};
    paint_view(pot.view, pot, turn, picture.painting);
    return picture;
}

}  // namespace onggi::screens
