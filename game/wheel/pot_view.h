// What the picture needs of a snapshot of the haptic loop: a view, not a copy. Any thread; mm, N, rad/s.
#pragma once

#include <span>

#include "engine/math/math.h"
#include "game/clay/studio/hand.h"
#include "game/clay/studio/load.h"
#include "game/clay/studio/pot.h"
#include "game/clay/studio/studio_parameters.h"

namespace onggi::wheel {

// One hand, and what it holds.
struct HandView {
    dvec3 position_mm{0.0, 260.0, 0.0};  // centre of the sphere
    double radius_mm = 10.0;
    clay::StudioTool tool = clay::StudioTool::kHand;
    clay::studio::Side side = clay::studio::Side::kFree;
    bool shown = true;
    bool touching = false;
    // It follows a finger on a screen, which may leap: then it goes and comes again, and takes its time where
    // it only hovers.
    bool guided = false;
    bool digs = false;  // with the thumbs straight down; `side` is the top
};

// All spans must live until apply() and the draw have returned. A ring is an element of the paper's clay or a
// ring of the studio's; rings go from the bottom up. What the clay does not have is an empty span.
struct PotView {
    std::span<const float> radii_mm;    // outer faces
    std::span<const float> inner_mm{};  // inner faces, 0 where solid; empty: solid
    std::span<const float>
        top_mm{};  // upper edge of each ring, ascending; empty: equal heights over height_mm
    double height_mm = 200.0;
    double floor_mm = 0.0;  // where the hollow begins
    // Of each ring, x and z of its centre in the clay's frame, which turns with the wheel; empty: on the
    // axis.
    std::span<const float> centre_mm{};
    // Dents, added to both faces: rows evenly spaced in height, row k at (k + 1/2)/rows of it, dent_sectors
    // each, counter-clockwise in the clay's frame, the first from direction +X on. Empty: round.
    std::span<const float> dents_mm{};
    int dent_sectors = 64;
    std::span<const float> film{};        // water on the surface, 0 to 1
    std::span<const float> liquidity{};   // water in the clay: 0 plastic limit, 1 liquid limit
    std::span<const float> load_index{};  // 1: it gives way
    double peak_load = 0.0;
    double peak_load_height_mm = 0.0;
    clay::studio::Cause peak_load_cause = clay::studio::Cause::kNone;
    HandView hand{};
    HandView second_hand{.shown = false};
    bool wire_shown = false;
    double wire_height_mm = 0.0;
    dvec2 wheel_direction{1.0,
                          0.0};  // unit vector (cos, sin) of the angle turned, counter-clockwise from above
    bool wheel_turning = false;
    double wheel_speed_rad_s = 0.0;
    int contacts = 0;  // rings that the hand touches
    clay::ClayBody body = clay::ClayBody::kStoneware;
    clay::Firing stage = clay::Firing::kWet;
};

}  // namespace onggi::wheel
