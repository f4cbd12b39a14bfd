// What the picture needs of a snapshot of the haptic loop: a view, not a copy. Any thread; mm, N, rad/s.
#pragma once

#include "engine/math/math.h"
#include "engine/render/scene.h"
#include "game/clay/studio/hand.h"
#include "game/clay/studio/load.h"
#include "game/clay/studio/studio_parameters.h"
#include "game/pot/pot.h"

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

// Pot and material must live until apply() and the draw have returned.
struct WheelView {
    const pot::Pot* pot = nullptr;
    const render::LatheMaterial* material = nullptr;  // that the pot wears; null: as clay_material() says
    const render::LatheMarks* marks = nullptr;        // on the pot's outside; null: none
    double peak_load = 0.0;
    double peak_load_height_mm = 0.0;
    clay::studio::Cause peak_load_cause = clay::studio::Cause::kNone;
    HandView hand{};
    HandView second_hand{.shown = false};
    // What a trimmer has cut off since it was taken up, and where it does: shavings fall from there, and lie
    // about until there is none.
    double shaved_mm3 = 0.0;
    dvec3 shaved_at_mm{0.0};
    bool rib_on_bench = false;  // of the photographed workshop, against the cup
    bool wire_shown = false;
    double wire_height_mm = 0.0;
    dvec2 wheel_direction{1.0,
                          0.0};  // unit vector (cos, sin) of the angle turned, counter-clockwise from above
    bool wheel_turning = false;
    double wheel_speed_rad_s = 0.0;
    int contacts = 0;  // rings that the hand touches
};

}  // namespace onggi::wheel
