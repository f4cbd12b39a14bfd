// Keeps the heights of the rings within bounds: a ring drawn tall is split, a flat one is joined to its
// neighbour. No volume is lost or found. A cursor looks at the rings at the pace of simulated time, so that
// the rings are the same ones at every tick rate. Haptic thread; no allocation. Units: mm, s.
#pragma once

#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

// The height that rings keep to: 200 mm over the nominal number of rings, or more for a tall pot, so that
// none needs more than the capacity.
double target_height_mm(const Rings& rings, int nominal_rings);

// Splits ring i in two halves on the grid, with radii that follow the slope. Precondition: count < capacity.
void split_ring(Rings& rings, int i);
// Joins rings i and i + 1. Volume and height are kept. Precondition: both solid or both hollow.
void join_rings(Rings& rings, int i);

// What a round of the cursor did, for those who keep a place among the rings.
struct Resplit {
    int changed_ring = -1;  // the ring that was split, or joined to the next one; -1: none
    bool was_split = false;
};

// Looks at ring i and splits or joins it where its height asks for it. Places are not worked out.
Resplit tend_ring(Rings& rings, int i, double target_mm);

}  // namespace onggi::clay::studio
