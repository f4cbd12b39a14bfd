// What the clay remembers of a hand: which side of the wall it is on, by how it came there, and how steadily
// it is held. Haptic thread; no allocation. Units: mm, s, rad. "World" is the frame that stands still
// (studio_clay.h); the clay's frame turns with the wheel.
#pragma once

#include "engine/math/math.h"
#include "game/clay/studio/rings.h"
#include "game/clay/studio/studio_parameters.h"

namespace onggi::clay::studio {

enum class Side { kFree, kOut, kIn, kTop };

// Off-centre clay may not be told from an unsteady hand beyond this.
constexpr double kLargestWobbleMm = 3.0;

struct HandState {
    Side side = Side::kFree;
    // The horizontal direction of the hand from the axis, a unit vector in the world: the last valid one.
    dvec2 direction{1.0, 0.0};
    // The mean of its distance from the axis, and its first harmonic over a turn as a vector B in the clay's
    // frame: a hand that follows the wheel once a revolution.
    bool has_mean = false;
    double mean_distance_mm = 0.0;
    dvec2 wobble_mm{0.0};
    dvec3 previous_position_mm{0.0};
    bool has_previous = false;
    // Its height, followed slowly: a hand that climbs is above it.
    bool has_slow_height = false;
    double slow_height_mm = 0.0;
};

// A hand as one tick sees it.
struct Hand {
    dvec3 position_mm{0.0};
    double radius_mm = 10.0;  // r1
    double shaft_mm = 0.0;
    double distance_mm = 0.0;   // r3; negative for a hand outside that crossed the axis
    dvec2 direction{1.0, 0.0};  // from the axis, world
    dvec2 in_clay{1.0, 0.0};    // the same in the clay's frame
    StudioTool tool = StudioTool::kHand;
    Side side = Side::kFree;
    bool is_assist = false;
    bool drinks = false;  // a sponge that was squeezed out takes up water
};

// The side after a hand with that position, from the side it was on. It changes only over the rim: no
// distance, however fast it came about, moves a hand through a wall.
Side next_side(Side side, const Rings& rings, double y_mm, double distance_mm, double radius_mm) noexcept;

// How near the axis a hand that comes down from above goes into the clay instead of onto its rim: into the
// mouth there is; where there is none yet, or one too small to hit again, within a third of the top's radius
// or three quarters of the hand's. Never past the middle of the rim.
double opening_radius_mm(const Rings& rings, double radius_mm) noexcept;

// Takes the position of this tick, dt_s after the last, into the state and says what the tick needs. heading
// is the wheel's angle.
// A hand that comes from free takes the side it wishes for, if that is open to it: outside beyond the inner
// face, inside within the outer one, on top over the rim.
// Precondition: rings.count > 0; the position is finite.
Hand follow_hand(HandState& state, const Rings& rings, const StudioHand& hand, const Rotation& heading,
                 double dt_s) noexcept;

// Whether a hand at that height climbs: 0 while it is still, trembles or sinks, 1 from 7 mm/s on.
double climb_fraction(const HandState& state, double y_mm) noexcept;

// One step of the running mean and of B over the last one and a half turns.
void follow_wobble(HandState& state, const Hand& hand, double turned_rad) noexcept;
void forget_wobble(HandState& state) noexcept;

// A direction of the world in the clay's frame, and where around the clay it points, 0 <= turn < 1.
dvec2 into_clay(const dvec2& direction, const Rotation& heading) noexcept;
double turn_of(const dvec2& in_clay) noexcept;

}  // namespace onggi::clay::studio
