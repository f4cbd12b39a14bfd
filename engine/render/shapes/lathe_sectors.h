// At which angles a lathe's rows have their vertices. Any thread; pure functions. rad from +X towards +Z, px.
#pragma once

#include <vector>

#include "engine/render/scene.h"

namespace onggi::render {

// Evenly round, or from one side of a cut to the other: sectors + 1 angles, the last a whole turn (or half a
// turn) after the first.
[[nodiscard]] std::vector<float> even_sectors(const Lathe& lathe, int sectors);

struct SectorBudget {
    float error_px = 0.35F;  // wanted: how far an edge of the pot may lie from its circle
    int max_sectors = 48;    // hard
};

// As seen by the eye: close to each other where the wall turns away and its edge is seen against what lies
// behind, further apart in front and behind, where only the rim's edge shows a corner. An even number of
// sectors, the same on both sides of the line of sight.
struct LatheSeen {
    float widest_px = 0.0F;  // radii
    float rim_px = 0.0F;
    float azimuth_rad = 0.0F;  // of the eye
    float pitch_rad = 0.0F;    // how far it looks down
};
[[nodiscard]] std::vector<float> seen_sectors(const LatheSeen& seen, const SectorBudget& budget);

}  // namespace onggi::render
