// What a hand does to the rings it touches while the wheel turns: it pushes them out or in, presses the rim,
// fairs a face, or cuts. Volume is kept by construction: only radii change, and heights follow.
// Haptic thread; no allocation. Units: mm, s.
#pragma once

#include "game/clay/studio/contact.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

// The rings that changed, as [first, end); what several moves changed together.
using Changed = Rings::Range;
Changed together(const Changed& a, const Changed& b);

// The local part of a push, and contact.field, the part left to the wall (see wall_field.h). fraction is
// 1 - exp(-dt/tau). other: the hand on the other side of the wall, or null.
//
// What both hands push squeezes the wall. What one pushes beyond the other moves it as a lone hand would, but
// that where the other holds it, all of the clay pushed aside crosses to the far face rather than a part
// (k0): the ring keeps its height, the wall goes along whole. Walls much thicker than the hand is wide do not
// notice the hand on their far side.
Changed push_rings(Rings& rings, Contact& contact, const Hand& hand, const Hand* other, double fraction,
                   const StudioParameters& parameters) noexcept;

// A hand on the rim shortens what is below it and thickens it to both sides: solid clay as a whole, a wall
// over four times its thickness. Clay resists as it gets flat: pressing alone makes no solid lump wider
// than 2.4 times its height from axis to face (1 kg: 31 mm high), and no wall thicker than 1.8 times what is
// left of it.
Changed press_rim(Rings& rings, const Contact& contact, double fraction,
                  const StudioParameters& parameters) noexcept;

// Sponge and rib: the touched face follows its own average over length_mm.
Changed smooth_face(Rings& rings, const Contact& contact, const Hand& hand, double fraction, double length_mm,
                    std::vector<double>& scratch) noexcept;

// Takes up to depth_mm[k] fraction off the touched face; what comes off is whole grains and goes to `off`.
Changed cut_face(Rings& rings, const Contact& contact, const Hand& hand, const std::vector<double>& depth_mm,
                 double fraction, double& off_mm3) noexcept;

// The last guard of every move: whether a ring may change from one shape to another. A number that is none
// passes no comparison.
struct Gate {
    // largest_strain: of a height in one tick.
    Gate(const Rings& rings, double largest_strain)
        : most(1.1 * largest_strain),
          rise(rings.top_mm() <= kTallestMm ? 1.0 : 0.0) {}

    // At least 0 if it may. One number and no truth values, so that compilers see lanes of one kind; the
    // change of height comes last, because all that could be no number is in it.
    [[nodiscard]] double lets(double outer, double inner, double height, double new_outer, double new_inner,
                              double new_height) const {
        const double wall = outer - inner;
        const double thinnest = wall < kThinnestWallMm ? wall : kThinnestWallMm;
        const double narrowest = outer < kNarrowestMm ? outer : kNarrowestMm;
        const double change = new_height - height;
        const double bound = most * height;
        double spare = new_outer - narrowest;
        const double wide = kWidestMm - new_outer;
        spare = wide < spare ? wide : spare;
        spare = new_inner < spare ? new_inner : spare;
        const double thick = (new_outer - new_inner) - thinnest;
        spare = thick < spare ? thick : spare;
        const double sinks = change + bound;
        spare = sinks < spare ? sinks : spare;
        const double rises = rise * bound - change;
        return rises >= spare ? spare : rises;
    }

    double most;
    double rise;  // 1, or 0 where the pot is as tall as it may be
};

// Gives ring i new radii if they keep within every bound; its height follows. Else the ring keeps its own.
bool set_radii(Rings& rings, int i, double outer_mm, double inner_mm, double largest_strain) noexcept;

// The wire, level at that height. What is above or below goes to the trimmings.
void cut_above(Rings& rings, Ledger& ledger, double y_mm) noexcept;
void cut_below(Rings& rings, Ledger& ledger, double y_mm) noexcept;

}  // namespace onggi::clay::studio
