// One touch of a finger, from landing to lifting: reads the touch, chooses the grip and moves the rings, step
// by step of simulated time, so that a replay of the recorded finger is bit-exact. The wall's outer face goes
// where the finger goes and never past it; a move that would ruin the pot is left out. Haptic thread; no
// allocation. Units: mm, s.
#pragma once

#include <array>
#include <optional>

#include "game/clay/studio/grip.h"
#include "game/clay/studio/grip_moves.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

// A step of the hands is split into this many stages, one a millisecond, so that no tick does all the work.
constexpr int kGripStages = 4;
constexpr double kGripStageS = 0.001;
constexpr double kGripStepS = kGripStages * kGripStageS;

constexpr double kThumbsMm = 17.0;      // radius of the thumbs that open solid clay
constexpr double kStartsAfterMm = 3.0;  // way of the hands before a wall moves

// The finger's path, which the hands walk behind it. Without it a rim would jump to the finger's distance at
// the wrong height.
struct GripTrail {
    static constexpr int kMost = 240;  // capacity; points are half a millimetre apart
    std::array<dvec2, kMost> point_mm{};
    int first = 0;
    int count = 0;
};

// A second finger while the first presses: the other hand. Its place counts from where it landed, because two
// fingers on a screen are farther apart than a wall is thick.
struct SecondGrip {
    bool presses = false;
    bool is_inside = false;   // of the wall
    double offset_mm = 0.0;   // its face of the wall minus the finger, at landing
    double between_mm = 0.0;  // the wall minus the fingers' distance, at landing
};

// One touch, from landing to lifting. All members are state: hashed, saved, replayed; the second finger only
// while it presses.
struct GripState {
    bool presses = false;
    Grip grip = Grip::kNone;
    GripGuard guard = GripGuard::kNone;        // of the current step
    GripGuard shown_guard = GripGuard::kNone;  // of the previous step
    bool is_spent = false;                     // the rim can rise no higher
    bool pulls = false;
    bool opens_by_itself = false;
    double side = 1.0;     // sign of x where the finger landed; its distance is positive on that side
    dvec2 finger_mm{0.0};  // (distance, height), smoothed
    dvec2 hand_mm{0.0};    // place of the hands on the trail
    GripTrail trail;
    dvec2 landed_mm{0.0};
    double landed_top_mm = 0.0;
    std::array<float, 33> landed_outer_mm{};  // outer radius at landing, by fraction of the height
    double offset_mm = 0.0;                   // wall minus finger at landing; wears off
    double offset_way_mm = 12.0;
    double travel_mm = 0.0;  // of the hands
    double heading = 0.0;    // vertical fraction of the motion, -1 to 1
    double still_s = 0.0;
    double rests_mm = 0.0;   // wall pressed in by a finger that lies still
    double wants_s = 0.0;    // time for which solid clay got a touch that needs hollow clay
    double pulled_mm = 0.0;  // rim rise by moving up below the rim
    double sunk_mm = 0.0;    // rim pressed down
    double bottom_mm = 0.0;  // bottom of the opening
    double bore_mm = 0.0;
    double press_mm = 0.0;    // equivalent depth, for the hands' force
    double bears_n_mm = 0.0;  // torque that the clay below the hands bears safely
    double low_mm = 0.0;
    double high_mm = 0.0;
    double credit_s = 0.0;  // simulated time not yet spent
    int stage = 0;          // of the step, 0 to kGripStages - 1
    SecondGrip second;
};

// Ends the touch within this tick.
void let_go(GripState& state) noexcept;
// The fingers on the clay: the one that presses, and a second one. Places (x, y).
struct GripFingers {
    dvec2 first_mm{0.0};
    std::optional<dvec2> second_mm{};
};
// The report for a display.
GripReport report_of(const GripState& state, const GripFingers& fingers) noexcept;

// Conditions of the clay that scale the hands' moves.
struct GripClimate {
    double load_index = 0.0;  // the largest of the load sweep
    double softness = 1.0;    // how readily the clay flows under this push; 1 for fresh clay and a finger
    double size = 1.0;        // cube root of the lump's mass in kilograms
    double push = 1.0;        // of the finger: of one without a measured pressure
    bool wide = true;         // Manner::kWide
};

// Advances by dt_s fingers that press. Returns the rings that changed; their places are up to date.
Changed work_grip(GripState& state, Rings& rings, GripSpace& space, const GripFingers& fingers,
                  const GripClimate& climate, double dt_s) noexcept;

}  // namespace onggi::clay::studio
