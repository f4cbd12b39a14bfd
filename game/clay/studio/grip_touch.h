// One touch of a finger, from landing to letting go: how the finger is followed, where the hands are behind
// it, what they mean to do. It changes no clay; grip_work.h does. Haptic thread; no allocation.
// Units: mm, s.
#pragma once

#include <array>

#include "game/clay/studio/grip.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

// A step of the hands is worked in so many stages, which take turns, so that no tick bears all of it.
constexpr int kGripStages = 4;
constexpr double kGripStageS = 0.001;
constexpr double kGripStepS = kGripStages * kGripStageS;

constexpr double kThumbsMm = 17.0;      // radius of what opens solid clay
constexpr double kStartsAfterMm = 3.0;  // of the hands' way, before a wall is moved
constexpr double kFloorMm = 11.0;       // that is left when a pot is opened

// The way the finger went, which the hands walk behind it: without it a rim would jump to the finger's
// distance at the wrong height.
struct GripTrail {
    static constexpr int kMost = 240;  // points half a millimetre apart
    std::array<dvec2, kMost> point_mm{};
    int first = 0;
    int count = 0;
};

// One touch, from landing to letting go. All of it is state: hashed, saved, replayed.
struct GripState {
    bool presses = false;
    Grip grip = Grip::kNone;
    GripGuard guard = GripGuard::kNone;        // of the step that is worked
    GripGuard shown_guard = GripGuard::kNone;  // of the one before
    bool is_spent = false;                     // the rim comes no higher
    bool pulls = false;
    bool opens_by_itself = false;
    double side = 1.0;     // of the axis, on which the finger landed; its distance is positive there
    dvec2 finger_mm{0.0};  // (distance, height), smoothed
    dvec2 hand_mm{0.0};    // the hands, on the way behind it
    GripTrail trail;
    dvec2 landed_mm{0.0};
    double landed_top_mm = 0.0;
    std::array<float, 33> landed_outer_mm{};  // outer radius by fraction of the height
    double offset_mm = 0.0;                   // of the wall from the finger, as it landed; it wears off
    double offset_way_mm = 12.0;
    double travel_mm = 0.0;  // of the hands
    double heading = 0.0;    // fraction of the way that goes up, -1 to 1
    double still_s = 0.0;
    double rests_mm = 0.0;   // pressed in by a finger that lies still
    double wants_s = 0.0;    // for how long solid clay has been asked for what only hollow clay can do
    double pulled_mm = 0.0;  // by moving up below the rim
    double sunk_mm = 0.0;    // pressed down
    double bottom_mm = 0.0;  // of the opening
    double bore_mm = 0.0;
    double press_mm = 0.0;    // depth that the hands feel
    double bears_n_mm = 0.0;  // torque of the hands that the clay below them takes without harm
    double low_mm = 0.0;
    double high_mm = 0.0;
    double credit_s = 0.0;  // simulated time not yet worked
    int stage = 0;          // of the step
};

// The fraction of a step that relaxes in tau_s.
double relaxed(double tau_s) noexcept;

bool is_hollow(const Rings& rings) noexcept;
// Of the ring at that height, the rim's above it.
double outer_face_mm(const Rings& rings, double y_mm) noexcept;

// A finger comes down at (x, y).
void land(GripState& state, const Rings& rings, const dvec2& finger_mm) noexcept;
// The finger a step later, as the hands see it, and the way that it leaves for them.
void follow_finger(GripState& state, const dvec2& finger_mm) noexcept;
// The hands walk that way, slower where the wall is not where it should be yet, and wait at highest_mm.
void walk(GripState& state, double error_mm, double highest_mm) noexcept;
// What they mean may change on the way.
void decide(GripState& state, const Rings& rings) noexcept;
// Where the hands want the wall's outer face to be, at their height.
double wall_target(const GripState& state, const Rings& rings) noexcept;
// Ends the touch in this very tick.
void let_go(GripState& state) noexcept;

// What grip_of_touch() needs, of these rings.
GripOutline outline_of(const Rings& rings, double y_mm) noexcept;
// What a display is told.
GripReport report_of(const GripState& state, const dvec2& finger_mm) noexcept;

}  // namespace onggi::clay::studio
