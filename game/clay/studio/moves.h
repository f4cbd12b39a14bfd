// Moves of a hand on the rings it touches while the wheel turns: push out or in, press the rim, smooth a
// face, or cut. Volume is kept by construction: only radii change, and heights follow. Haptic thread; no
// allocation. Units: mm, s.
#pragma once

#include <cmath>
#include <limits>

#include "game/clay/studio/contact.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

// Changed: the rings that changed, as [first, end). together(): the union of two.
using Changed = Rings::Range;
Changed together(const Changed& a, const Changed& b);

// Applies the local part of a push, and fills contact.field with the part left to the wall (see
// wall_field.h). fraction is 1 - exp(-dt/tau). other: the hand on the other side of the wall, or null.
//
// The common part of both hands' pushes squeezes the wall. The excess of one hand moves the wall as a lone
// hand would, with one difference: where the other hand holds the wall, all displaced clay crosses to the far
// face instead of a part (k0), so the ring keeps its height and the wall moves whole. The effect fades for
// walls much thicker than the hand is wide.
Changed push_rings(Rings& rings, Contact& contact, const Hand& hand, const Hand* other, double fraction,
                   const StudioParameters& parameters) noexcept;

// A hand on the rim shortens the clay below it and thickens it to both sides: solid clay as a whole, a wall
// over four times its thickness. Flat clay resists: pressing alone makes no solid lump wider than 2.4 times
// its height from axis to face (1 kg: 31 mm high), and no wall thicker than 1.8 times the height of the
// pressed part.
Changed press_rim(Rings& rings, const Contact& contact, double fraction,
                  const StudioParameters& parameters) noexcept;

// Sponge and rib: moves the touched face towards its own average over length_mm.
Changed smooth_face(Rings& rings, const Contact& contact, const Hand& hand, double fraction, double length_mm,
                    std::vector<double>& scratch) noexcept;

// Removes up to depth_mm[k] * fraction from the touched face. Whole grains are removed; they are added to
// `off`.
Changed cut_face(Rings& rings, const Contact& contact, const Hand& hand, const std::vector<double>& depth_mm,
                 double fraction, double& off_mm3) noexcept;

// The final check of every move: whether a ring may change from one shape to another. A NaN fails every
// comparison. The bounds are members, not literals, because GCC takes the least of two values in one
// instruction only where neither is a literal.
struct Gate {
    // largest_strain: of a ring's height in one tick.
    Gate(const Rings& rings, double largest_strain)
        : most(1.1 * largest_strain),
          highest_rise_mm(rings.top_mm() <= kTallestMm ? std::numeric_limits<double>::infinity() : 0.0) {}

    // Without branches, so that a loop over rings vectorises.
    [[nodiscard]] bool lets(double outer, double inner, double height, double new_outer, double new_inner,
                            double new_height) const {
        const double wall = outer - inner;
        const double change = new_height - height;
        return (new_outer >= (outer < narrowest_mm ? outer : narrowest_mm)) & (new_outer <= widest_mm) &
               (new_inner >= axis_mm) & (new_outer - new_inner >= (wall < thinnest_mm ? wall : thinnest_mm)) &
               (std::fabs(change) <= most * height) & (change <= highest_rise_mm);
    }

    double most;
    double highest_rise_mm;  // 0 if the pot already has the maximum height
    double axis_mm = 0.0;
    double narrowest_mm = kNarrowestMm;
    double widest_mm = kWidestMm;
    double thinnest_mm = kThinnestWallMm;
};

// Sets the radii of ring i if they keep all bounds; its height follows. Returns false and keeps the ring
// otherwise.
bool set_radii(Rings& rings, int i, double outer_mm, double inner_mm, double largest_strain) noexcept;

// Wire cuts, level at that height. The clay above (cut_above) or below (cut_below) goes to the trimmings.
void cut_above(Rings& rings, Ledger& ledger, double y_mm) noexcept;
void cut_below(Rings& rings, Ledger& ledger, double y_mm) noexcept;

}  // namespace onggi::clay::studio
