// The pot as the picture, the screens and the sounds read it. Built once from a clay (haptic/pot_copy.h) or
// another shape, and shared by all readers. Any thread; plain data. mm.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/math/dents.h"
#include "engine/math/math.h"
#include "game/clay/studio/pot.h"

namespace onggi::pot {

// Columns, one entry a ring, bottom first; a ring is an element of the paper's clay or a ring of the
// studio's. A column is empty if the clay lacks that property: the paper's clay has only outer faces.
struct Pot {
    std::vector<float> outer_mm{};
    std::vector<float> inner_mm{};    // 0 if the ring is solid; empty: solid everywhere, with a flat top
    std::vector<float> top_mm{};      // upper edges, ascending; empty: equal heights over height_mm
    std::vector<vec2> centre_mm{};    // x and z in the clay's frame, which turns with it; empty: on the axis
    std::vector<float> film{};        // water on the surface, 0 to 1
    std::vector<float> liquidity{};   // water in the clay: 0 plastic limit, 1 liquid limit
    std::vector<float> load_index{};  // 1 and more: the clay fails
    // Rows of kDentSectors, evenly spaced: row k of n at (k + 1/2)/n of the height, sectors counter-clockwise
    // in the clay's frame, the first from direction +X; added to both faces. Empty: round everywhere.
    std::vector<float> dents_mm{};
    double height_mm = 0.0;
    double floor_mm = 0.0;  // where the hollow begins
    clay::ClayBody body = clay::ClayBody::kStoneware;
    clay::Firing stage = clay::Firing::kWet;

    [[nodiscard]] int ring_count() const { return static_cast<int>(outer_mm.size()); }
    // Has columns for an inside, even if every ring is still solid.
    [[nodiscard]] bool can_be_hollow() const { return !inner_mm.empty(); }
};

// The outside from the foot up to the rim: (radius, height), heights rising. Precondition: a pot with rings.
[[nodiscard]] std::vector<vec2> outer_outline(const Pot& pot);

// Outer and inner radius of the pot at a height; inner 0 where it is solid, both 0 above and below it.
struct Wall {
    double outer_mm = 0.0;
    double inner_mm = 0.0;
};
[[nodiscard]] Wall wall_at(const Pot& pot, double y_mm);
// The wall at the uppermost ring.
[[nodiscard]] Wall rim_of(const Pot& pot);
// Whether the pot has no notable hollow.
[[nodiscard]] bool is_solid(const Pot& pot);
// Index of the ring at this height, the nearest one above and below the pot. 0 without rings.
[[nodiscard]] std::size_t ring_at(const Pot& pot, double y_mm);

// The pot at a stage of drying and firing: all lengths times clay::shrunk_scale.
[[nodiscard]] Pot fired(Pot pot, clay::Firing stage);

}  // namespace onggi::pot
