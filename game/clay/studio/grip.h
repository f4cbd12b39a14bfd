// One finger throws with two skilled hands: what a touch on the clay takes hold of, and what the hands are
// doing. A pointer has no depth and no force, so it does not place a ball in the clay; it chooses a grip, and
// the grip carries it out (grip_work.h). Places are on the upright plane through the axis that faces the
// camera: x is signed, y up from the wheel head. Any thread; fit for the tick. Units: mm.
#pragma once

#include <cstdint>

#include "engine/math/math.h"

namespace onggi::clay::studio {

constexpr double kHollowMm = 8.0;  // deeper than this the clay counts as hollow

enum class Grip : std::uint8_t {
    kNone,    // the finger is off the clay
    kAsking,  // on the top of solid clay: the first millimetres say whether it opens or moves the wall
    kOpen,    // thumbs press down into the middle, then outward
    kWall,    // two palms carry the wall's outer face to the finger; past the rim they pull it up
    kInside,  // fingers inside carry the wall outward
    kRim,     // a palm on the rim presses it down
};

// Why the clay does less than the finger asks.
enum class GripGuard : std::uint8_t {
    kNone,
    kNoMoreClay,  // no wall is thick enough to give what a pull asks for
    kAsNarrow,    // as narrow as one touch goes
    kAsWide,      // as wide as the clay, the foot or the wheel bears
    kAsLow,       // pressed down as far as one touch goes
    kNearLimit,   // the clay would give way
};

// What a tick tells of the hands.
struct GripReport {
    Grip grip = Grip::kNone;
    GripGuard guard = GripGuard::kNone;
    bool pulls = false;            // at the rim, which rises with the finger
    bool opens_by_itself = false;  // the other hand goes in, because the touch asks for hollow clay
    dvec2 hand_mm{0.0};            // where the hands are: behind the finger
    dvec2 finger_mm{0.0};
    double low_mm = 0.0;  // what of the wall they hold
    double high_mm = 0.0;
};

// The outline that a landing finger meets.
struct GripOutline {
    double height_mm = 0.0;
    double floor_mm = 0.0;  // where the hollow begins; the height of solid clay
    double outer_mm = 0.0;  // radius of the outer face at the finger's height, at the rim above it
    double rim_outer_mm = 0.0;
    double rim_inner_mm = 0.0;  // 0: solid
};

// What a touch there would take hold of.
Grip grip_of_touch(const GripOutline& outline, const dvec2& finger_mm) noexcept;

}  // namespace onggi::clay::studio
