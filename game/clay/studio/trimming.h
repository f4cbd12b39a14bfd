// Turning a foot: where a pot bears it, and how far a trimmer may go. Any thread; fit for the tick. mm.
#pragma once

#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

// Chosen: what a potter leaves of a wall, at the least, and of a foot.
constexpr double kTrimmedWallMm = 3.0;
constexpr double kTrimmedFootMm = 15.0;

// Of leather-hard clay: it keeps its shape and can still be cut. At the plastic limit.
constexpr double kLeatherHardLiquidity = 0.0;

// How thick the wall is right above the floor; 0 where nothing is hollow.
double foot_wall_mm(const Rings& rings);

// The outer radius that a careful trimmer leaves ring i: three millimetres of wall across it, and as much
// round the floor's corner; of what is solid below, a foot.
double least_outer_mm(const Rings& rings, int i) noexcept;

// Dries all of it to leather hard, at once. Clay that is drier stays as it is.
void dry_to_leather(Rings& rings) noexcept;

}  // namespace onggi::clay::studio
