// Two pots joined rim to rim into one, as a moon jar is made: the second is turned upside down onto the
// first, its floor becomes the mouth. Any thread but the haptic one: it allocates. Units: mm, mm^3.
#pragma once

#include "engine/core/result.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::clay {

struct Joining {
    // The upper pot's floor is cut out, and its wall up to where the opening is this wide inside; 0: the
    // floor alone.
    double mouth_mm = 0.0;
    // Rims that differ are eased towards each other over this length of both walls.
    double eased_mm = 15.0;
    double largest_step_mm = 8.0;  // of the walls' mean radii at the rims; more cannot be eased
    // How far to the side the upper pot is set on, x and z in the lower one's clay frame. Half of it is eased
    // away on either side of the seam.
    dvec2 shift_mm{0.0};
    // Clay pressed into the seam stands out on both faces, this high over this length to either side.
    double ridge_mm = 0.4;
    double ridge_reach_mm = 2.5;
};

// `lower` with `upper` turned about the horizontal direction 0 of its clay and set on its rim: a ring's
// sector s becomes S - 1 - s, its centre (x, y) becomes (x, -y), and is set aside by the shift. Every ring
// keeps its volume to the grain, its water, strength, dents and twist; what is cut out goes to the trimmings,
// and the ledger is the sum of both. Heights follow from the eased radii. The wheel stands, the hands are
// away, the pot can be thrown on. Its lump is the lower one's, as heavy as both. kBadInput if a pot has no
// open rim, if sectors or bodies differ, or if both together are heavier, taller, of more rings or further
// apart than a pot can be.
Result<StudioClay> join_pots(const StudioClay& lower, const StudioClay& upper, const Joining& joining);

// How far apart the rims of two pots are: the lower one's mean radius less the upper one's, mm.
// Precondition: rings.
[[nodiscard]] double rim_step_mm(const StudioClay& lower, const StudioClay& upper);

// How wide a pot is inside where it has become that wide outside, seen from its foot: the mouth_mm that gives
// a mouth of that outer width. 0: its foot is as wide, or it is nowhere.
[[nodiscard]] double bore_at_width_mm(const StudioClay& pot, double outside_mm);

}  // namespace onggi::clay
