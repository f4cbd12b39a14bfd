// What a hand does to the rings it touches while the wheel turns: it pushes them out or in, presses the rim,
// fairs a face, or cuts. Volume is kept by construction: only radii change, and heights follow.
// Haptic thread; no allocation. Units: mm, s.
#pragma once

#include "game/clay/studio/contact.h"
#include "game/clay/studio/ledger.h"

namespace onggi::clay::studio {

// The rings that changed, as [first, end); what several moves changed together.
using Changed = Rings::Range;
Changed together(const Changed& a, const Changed& b);

// The local part of a push, and contact.field, the part left to the wall (see wall_field.h). share is
// 1 - exp(-dt/tau). other: the hand on the other side of the wall, or null.
Changed push_rings(Rings& rings, Contact& contact, const Hand& hand, const Hand* other, double share,
                   const StudioParameters& parameters) noexcept;

// A hand on the rim shortens what is below it and thickens it to both sides.
Changed press_rim(Rings& rings, const Contact& contact, double share,
                  const StudioParameters& parameters) noexcept;

// Sponge and rib: the touched face follows its own average over length_mm.
Changed smooth_face(Rings& rings, const Contact& contact, const Hand& hand, double share, double length_mm,
                    std::vector<double>& scratch) noexcept;

// Takes up to depth_mm[k] share off the touched face; what comes off is whole grains and goes to `off`.
Changed cut_face(Rings& rings, const Contact& contact, const Hand& hand, const std::vector<double>& depth_mm,
                 double share, double& off_mm3) noexcept;

// Gives ring i new radii if they keep within every bound; its height follows. Else the ring keeps its own.
bool set_radii(Rings& rings, int i, double outer_mm, double inner_mm, double largest_strain) noexcept;

// The wire, level at that height. What is above or below goes to the trimmings.
void cut_above(Rings& rings, Ledger& ledger, double y_mm) noexcept;
void cut_below(Rings& rings, Ledger& ledger, double y_mm) noexcept;

}  // namespace onggi::clay::studio
