// The pot as everybody sees it: the picture, the screens, the sounds. Made once of a clay (haptic/pot_copy.h)
// or of whatever else has a shape, and read by all. Any thread; plain data. mm.
#pragma once

#include <vector>

#include "engine/math/dents.h"
#include "engine/math/math.h"
#include "game/clay/studio/pot.h"

namespace onggi::pot {

// Columns, one entry a ring, bottom first; a ring is an element of the paper's clay or a ring of the
// studio's. What the clay does not have is an empty column: the paper's has outer faces alone.
struct Pot {
    std::vector<float> outer_mm{};
    std::vector<float> inner_mm{};    // 0 where a ring is solid; empty: solid everywhere, with a flat top
    std::vector<float> top_mm{};      // upper edges, ascending; empty: equal heights over height_mm
    std::vector<vec2> centre_mm{};    // x and z in the clay's frame, which turns with it; empty: on the axis
    std::vector<float> film{};        // water on the surface, 0 to 1
    std::vector<float> liquidity{};   // water in the clay: 0 plastic limit, 1 liquid limit
    std::vector<float> load_index{};  // 1: it gives way
    // Rows of kDentSectors, evenly spaced: row k of n at (k + 1/2)/n of the height, sectors counter-clockwise
    // in the clay's frame, the first from direction +X on; each adds to both faces. Empty: round everywhere.
    std::vector<float> dents_mm{};
    double height_mm = 0.0;
    double floor_mm = 0.0;  // where the hollow begins
    clay::ClayBody body = clay::ClayBody::kStoneware;
    clay::Firing stage = clay::Firing::kWet;

    [[nodiscard]] int ring_count() const { return static_cast<int>(outer_mm.size()); }
    // It has an inside, and all that goes with it, though every ring may still be solid.
    [[nodiscard]] bool can_be_hollow() const { return !inner_mm.empty(); }
};

// Up its outside from the foot to the rim: (radius, height), heights rising. Of a pot with rings.
[[nodiscard]] std::vector<vec2> outer_outline(const Pot& pot);

// The pot at a stage of drying and firing: every length times clay::shrunk_scale.
[[nodiscard]] Pot fired(Pot pot, clay::Firing stage);

}  // namespace onggi::pot
