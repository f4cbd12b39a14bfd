// The samples of a pot's surface that a picture of it shows: a depth buffer on a processor. Any thread; pure.
#pragma once

#include <vector>

#include "game/screens/pot_picture.h"
#include "game/screens/pot_shading.h"

namespace onggi::screens {

// Several samples a pixel, each way; rows from the top.
constexpr int kSamplesAcross = 2;

struct PotSamples {
    int width = 0;  // in samples; whole pixels
    int height = 0;
    vec2 foot_px{0.0F};  // where the middle of the foot stands, pixels
    std::vector<PotSurface> surface{};
    std::vector<char> covered{};
};

// Parallel view, elevation_rad above the horizon.
[[nodiscard]] PotSamples sample_pot(const PotShape& shape, float px_per_mm, float elevation_rad);

}  // namespace onggi::screens
