#include "game/clay/studio/grip.h"

#include <cmath>

namespace onggi::clay::studio {
namespace {

// A finger farther from the clay than this holds nothing.
constexpr double kAboveMm = 70.0;
constexpr double kBesideMm = 75.0;

constexpr double kOpensWithin = 0.35;    // fraction of the radius, on solid clay
constexpr double kAsksWithin = 0.62;     // fraction of the radius; the first motion decides
constexpr double kTopZoneMm = 12.0;      // below the top of solid clay
constexpr double kThickRimMm = 18.0;     // opening continues while the rim is thicker than this
constexpr double kMouthZone = 0.3;       // fraction of the depth below the rim that counts as the mouth
constexpr double kOpensOnWithin = 0.62;  // fraction of the rim's radius
constexpr double kMouthFraction = 0.85;  // fraction of the mouth's radius; a touch farther out means the wall
constexpr double kRimZoneMm = 5.0;
constexpr double kRimSideMm = 10.0;

}  // namespace

Grip grip_of_touch(const GripOutline& outline, const dvec2& finger) noexcept {
    const double r = std::fabs(finger.x);
    const double y = finger.y;
    const double top = outline.height_mm;
    if (!(top > 0.0) || !(y <= top + kAboveMm) || !(r <= outline.outer_mm + kBesideMm)) return Grip::kNone;
    const double depth = top - outline.floor_mm;
    if (depth <= kHollowMm) {
        if (y <= top - kTopZoneMm || r > kAsksWithin * outline.outer_mm) return Grip::kWall;
        return r <= kOpensWithin * outline.outer_mm ? Grip::kOpen : Grip::kAsking;
    }
    if (y > top - kMouthZone * depth) {
        const bool is_thick = outline.rim_outer_mm - outline.rim_inner_mm > kThickRimMm;
        if (is_thick && r < kOpensOnWithin * outline.rim_outer_mm) return Grip::kOpen;
        if (r < kMouthFraction * outline.rim_inner_mm) return Grip::kInside;
    }
    const bool is_over_rim = y > top - kRimZoneMm && r > outline.rim_inner_mm - kRimSideMm &&
                             r < outline.rim_outer_mm + kRimSideMm;
    return is_over_rim ? Grip::kRim : Grip::kWall;
}

}  // namespace onggi::clay::studio
