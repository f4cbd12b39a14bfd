// Joins two pots rim to rim into one, as a moon jar is made: the second is turned upside down onto the first,
// and its floor becomes the mouth. Any thread but the haptic one: it allocates. Units: mm, mm^3.
#pragma once

#include "engine/core/result.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::clay {

struct Joining {
    // The upper pot's floor is cut out, and its wall up to where it is this wide inside; 0: only the floor.
    double bore_mm = 0.0;
    // Rims that differ are blended towards each other over this length of both walls.
    double eased_mm = 15.0;
    double largest_step_mm = 8.0;  // of the walls' mean radii at the rims; a larger step cannot be blended
    // Sideways offset of the upper pot, x and z in the lower pot's clay frame. On either side of the seam,
    // half the offset is blended in.
    dvec2 shift_mm{0.0};
    // Clay pressed into the seam stands out on both faces, this high, over this length to either side.
    double ridge_mm = 0.4;
    double ridge_reach_mm = 2.5;
};

// Returns `lower` with `upper` set on its rim, turned about the horizontal direction 0 of its clay: a ring's
// sector s becomes S - 1 - s, its centre (x, y) becomes (x, -y) plus the shift. Every ring keeps its volume
// to the grain, its water, strength, dents and twist. Cut-out clay goes to the trimmings, and the ledger is
// the sum of both. Heights follow from the blended radii. The wheel stands, the hands are away, the pot can
// be thrown on. Its lump is the lower one's with the mass of both. kBadInput if a pot has no open rim, if
// sectors or bodies differ, or if the result would be heavier, taller, wider apart or of more rings than a
// pot can be.
Result<StudioClay> join_pots(const StudioClay& lower, const StudioClay& upper, const Joining& joining);

// Step between the rims of two pots: the lower one's mean radius minus the upper one's, mm. Precondition:
// both have rings.
[[nodiscard]] double rim_step_mm(const StudioClay& lower, const StudioClay& upper);

// Inner diameter of a pot at the lowest height where its outer diameter reaches outside_mm: the bore_mm for
// a mouth of that outer width. Returns 0 if the foot is as wide, or if no part is.
[[nodiscard]] double bore_at_width_mm(const StudioClay& pot, double outside_mm);

}  // namespace onggi::clay
