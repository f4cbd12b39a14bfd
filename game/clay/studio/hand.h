// A hand in the clay: the side of the wall it is on, from its history, and how steadily it is held.
// Haptic thread; no allocation. Units: mm, s, rad. "World" is the frame that stands still (studio_clay.h);
// the clay's frame turns with the wheel.
#pragma once

#include "engine/math/math.h"
#include "game/clay/studio/rings.h"
#include "game/clay/studio/studio_parameters.h"
#include "game/tool/tool_state.h"

namespace onggi::clay::studio {

using tool::Side;
using tool::Tool;

// Bound of B: beyond it off-centre clay could not be told from an unsteady hand.
constexpr double kLargestWobbleMm = 3.0;

// A hand's memory, and its place in this tick.
struct Hand {
    // From tick to tick: hashed, saved, replayed.
    Side side = Side::kFree;
    dvec2 direction{1.0, 0.0};  // unit, from the axis to the hand, world frame; the last valid one
    // The hand's mean distance from the axis, and its first harmonic over a turn as a vector B in the clay's
    // frame: a hand that follows the wheel once a revolution.
    bool has_mean = false;
    double mean_distance_mm = 0.0;
    dvec2 wobble_mm{0.0};
    dvec3 previous_position_mm{0.0};
    bool has_previous = false;
    // Low-pass filtered height; a hand that climbs is above it.
    bool has_slow_height = false;
    double slow_height_mm = 0.0;

    // In this tick.
    dvec3 position_mm{0.0};
    double radius_mm = 10.0;  // r1
    double shaft_mm = 0.0;
    double distance_mm = 0.0;  // r3; negative for a hand outside that crossed the axis
    dvec2 in_clay{1.0, 0.0};   // `direction` in the clay's frame
    Tool tool = Tool::kHand;
    bool is_assist = false;
    bool drinks = false;  // a squeezed-out sponge that takes up water
};

// The side of a hand at that position, given its previous side. It changes only over the rim: no jump in
// distance moves a hand through a wall.
Side next_side(Side side, const Rings& rings, double y_mm, double distance_mm, double radius_mm) noexcept;

// Within this radius a hand that descends from above enters the clay instead of landing on its rim: the
// mouth's radius; if the mouth is missing or too small to hit again, a third of the top's radius or three
// quarters of the hand's. Never past the middle of the rim.
double opening_radius_mm(const Rings& rings, double radius_mm) noexcept;

// Takes the hand to its place in this tick, dt_s after the last: the first hand of the tool, or its second.
// heading is the wheel's angle.
// A hand that comes from kFree takes the side that the tool wants if that side is open to it: outside beyond
// the inner face, inside within the outer one, on top over the rim. The second wants none.
// Precondition: rings.count > 0; the position is finite.
void follow_hand(Hand& hand, const Rings& rings, const tool::ToolState& tool, const Rotation& heading,
                 double dt_s) noexcept;
void follow_hand(Hand& hand, const Rings& rings, const tool::SecondHand& second, const Rotation& heading,
                 double dt_s) noexcept;

// How fast a hand climbs: 0 while it is still, trembles or sinks, 1 from 7 mm/s on.
double climb_fraction(const Hand& hand) noexcept;

// One step of the running mean and of B over the last one and a half turns.
void follow_wobble(Hand& hand, double turned_rad) noexcept;
void forget_wobble(Hand& hand) noexcept;

// into_clay: turns a world direction into the clay's frame. turn_of: its angle around the clay, 0 <= turn <
// 1.
dvec2 into_clay(const dvec2& direction, const Rotation& heading) noexcept;
double turn_of(const dvec2& in_clay) noexcept;

}  // namespace onggi::clay::studio
