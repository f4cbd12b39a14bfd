// The part of the haptic loop's snapshot that the picture needs: a view, not a copy. Any thread; mm, N,
// rad/s.
#pragma once

#include "engine/math/math.h"
#include "engine/render/scene.h"
#include "game/clay/studio/hand.h"
#include "game/clay/studio/load.h"
#include "game/clay/studio/studio_parameters.h"
#include "game/pot/pot.h"

namespace onggi::wheel {

// One hand and its tool.
struct HandView {
    dvec3 position_mm{0.0, 260.0, 0.0};  // centre of the sphere
    double radius_mm = 10.0;
    tool::Tool tool = tool::Tool::kHand;
    tool::Side side = tool::Side::kFree;
    bool shown = true;
    bool touching = false;
    // Follows a finger on a screen, which may jump: the hand then goes and comes back, and moves more slowly
    // while it hovers.
    bool guided = false;
    bool digs = false;  // with the thumbs straight down; `side` is the top
};

// Pot and material must live until apply() and the draw have returned.
struct WheelView {
    const pot::Pot* pot = nullptr;
    const render::LatheMaterial* material = nullptr;  // of the pot; null: clay_material()
    const render::LatheMarks* marks = nullptr;        // on the pot's outside; null without marks
    double peak_load = 0.0;
    double peak_load_height_mm = 0.0;
    clay::studio::Cause peak_load_cause = clay::studio::Cause::kNone;
    HandView hand{};
    HandView second_hand{.shown = false};
    // Volume cut off since the trimmer was taken up, and the place of the cut: shavings fall from there, and
    // lie about until it is 0 again.
    double shaved_mm3 = 0.0;
    dvec3 shaved_at_mm{0.0};
    bool rib_on_bench = false;  // on the bench of the photographed workshop, against the cup
    bool wire_shown = false;
    double wire_height_mm = 0.0;
    dvec2 wheel_direction{1.0,
                          0.0};  // unit vector (cos, sin) of the angle turned, counter-clockwise from above
    bool wheel_turning = false;
    double wheel_speed_rad_s = 0.0;
    int contacts = 0;  // rings in contact with the hand
};

}  // namespace onggi::wheel
