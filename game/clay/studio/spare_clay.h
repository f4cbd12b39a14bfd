// Rings that are given new radii at the height they have, and the clay that this leaves over or asks for:
// whole grains, which pass to and from walls near by, so that the ledger is exact. Haptic thread; no
// allocation. Units: mm, mm^3.
#pragma once

#include <vector>

#include "game/clay/studio/moves.h"

namespace onggi::clay::studio {

// No wall is drawn thinner: at the floor, and at the rim.
constexpr double kThinnestAtFloorMm = 8.0;
constexpr double kThinnestAtRimMm = 4.6;
constexpr double kNarrowestBoreMm = 9.0;
constexpr double kWidestGripMm = 135.0;  // outer radius to which hands carry clay

// The thinnest that a wall is drawn at that height.
double thinnest_mm(const Rings& rings, double y_mm) noexcept;

// A thick wall is no neck: it keeps a bore that fingers find again.
double narrowest_bore(double wall_mm) noexcept;

// Takes ring i to those radii at the height it has. Returns the clay that does not fit; less than nothing
// where clay is missing.
double reshape(Rings& rings, int i, double outer_mm, double inner_mm) noexcept;

// Clay that came free (above 0) near a height goes into walls near by, or what is missing comes out of thick
// ones; what they do not bear changes the heights of all hollow clay evenly. weight: work space of one entry
// a ring. Returns the rings that changed; their places are worked out where heights did.
Changed share_out(Rings& rings, std::vector<double>& weight, double y_mm, double free_mm3) noexcept;

}  // namespace onggi::clay::studio
