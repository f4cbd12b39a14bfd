// Reshapes rings at constant height, and moves the surplus or missing clay as whole grains to or from walls
// near by, so that the ledger stays exact. Haptic thread; no allocation. Units: mm, mm^3.
#pragma once

#include <vector>

#include "game/clay/studio/moves.h"

namespace onggi::clay::studio {

// Minimum thickness of a drawn wall, at the floor and at the rim.
constexpr double kThinnestAtFloorMm = 8.0;
constexpr double kThinnestAtRimMm = 4.6;
constexpr double kNarrowestBoreMm = 9.0;
constexpr double kWidestGripMm = 135.0;  // largest outer radius to which hands move clay

// Minimum thickness of a drawn wall at that height.
double thinnest_mm(const Rings& rings, double y_mm) noexcept;

// The rise of the rim that would leave every wall at its thinnest.
double spare_rise(const Rings& rings) noexcept;

// Minimum bore for that wall. A thick wall keeps a wider bore, which fingers can find again.
double narrowest_bore(double wall_mm) noexcept;

// Sets the radii of ring i at its present height. Returns the clay that does not fit; negative if clay is
// missing.
double reshape(Rings& rings, int i, double outer_mm, double inner_mm) noexcept;

// Moves surplus clay (free_mm3 > 0) into walls near y_mm, or takes missing clay out of thick ones. The rest
// changes the heights of all hollow clay evenly. weight: work space, one entry a ring. Returns the rings that
// changed; places are updated where heights changed.
Changed share_out(Rings& rings, std::vector<double>& weight, double y_mm, double free_mm3) noexcept;

}  // namespace onggi::clay::studio
