// One finger throws with two skilled hands: the grip that a touch on the clay chooses, and the report of
// those hands. A pointer has no depth and no force, so it cannot place a ball in the clay; it chooses a grip,
// and grip_work.h carries it out. Places are on the upright plane through the axis that faces the camera: x
// is signed, y up from the wheel head. Any thread; fit for the tick. Units: mm.
#pragma once

#include <cstdint>

#include "engine/math/math.h"

namespace onggi::clay::studio {

constexpr double kHollowMm = 8.0;  // deeper than this the clay counts as hollow

enum class Grip : std::uint8_t {
    kNone,    // the finger is off the clay
    kAsking,  // on the top of solid clay: the first millimetres of motion choose between opening and wall
    kOpen,    // thumbs press down into the middle, then outward
    kWall,    // two palms move the wall's outer face to the finger; past the rim they pull it up
    kInside,  // fingers inside move the wall outward
    kRim,     // a palm on the rim presses it down
};

// Why the clay does less than the finger requests.
enum class GripGuard : std::uint8_t {
    kNone,
    kNoMoreClay,  // no wall is thick enough to supply clay for a pull
    kAsNarrow,    // as narrow as one touch goes
    kAsWide,      // as wide as the clay, the foot or the wheel allows
    kAsLow,       // pressed down as far as one touch goes
    kNearLimit,   // the clay would give way
    kAsHigh,      // pulled up as far as one touch goes
};

// The hands' state for display, once a tick.
struct GripReport {
    Grip grip = Grip::kNone;
    GripGuard guard = GripGuard::kNone;
    bool pulls = false;            // holds the rim, which rises with the finger
    bool opens_by_itself = false;  // the other hand opens solid clay, because the touch needs hollow clay
    dvec2 hand_mm{0.0};            // place of the hands, behind the finger
    dvec2 finger_mm{0.0};
    double low_mm = 0.0;  // the held part of the wall, low_mm to high_mm
    double high_mm = 0.0;
    // A second finger is the other hand: on which face, and its place, within reach of the first.
    bool has_second = false;
    bool second_is_inside = false;
    dvec2 second_mm{0.0};
};

// The outline at a landing finger.
struct GripOutline {
    double height_mm = 0.0;
    double floor_mm = 0.0;  // where the hollow begins; height_mm if the clay is solid
    double outer_mm = 0.0;  // of the outer face at the finger's height; of the rim for a finger above it
    double rim_outer_mm = 0.0;
    double rim_inner_mm = 0.0;  // 0 if the clay is solid
};

// The grip that a touch there chooses.
Grip grip_of_touch(const GripOutline& outline, const dvec2& finger_mm) noexcept;

}  // namespace onggi::clay::studio
