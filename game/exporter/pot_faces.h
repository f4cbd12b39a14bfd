// A pot's faces for sharing: reduces thousands of rings to the few rows of corners that a smooth wall needs,
// with dents and off-centre kept. Any thread but the haptic one. mm, wet size, the clay's frame: x along its
// direction 0, y up, corners counter-clockwise seen from above.
#pragma once

#include <vector>

#include "game/exporter/pot_rings.h"
#include "game/pot/surface_builder.h"

namespace onggi::exporter {

// Bottom first, heights never falling; two rows at the same height are a ledge.
using Face = std::vector<pot::SurfaceRow>;

// Adjacent rings that are all solid or all hollow.
struct RingRun {
    int first = 0;
    int end = 0;
    bool hollow = false;
};

// The stack as runs, bottom first, neighbours of different kind. A run lower than 0.05 mm is a flake: it
// joins the run below it, or the one above if it is the first.
std::vector<RingRun> ring_runs(const PotRings& rings);

enum class Which { kOuter, kInner };

// The face of rings [first, end) through the middle of each ring, straight between them, upright in the lower
// half of the first and the upper half of the last. Rings flatter than a micrometre are skipped. The steps
// between rings are mostly an artefact of their finite number. A step is kept as a ledge only if a straight
// slope in its place would be steeper than 4 : 1 and would cost more than a thousandth of the two rings'
// clay. corners: of each row; divides twice the sectors, or the other way round.
Face face_of(const PotRings& rings, Which which, int first, int end, int corners);

// Reduces the rows so that no radius, centre or dent changes by more than tolerance_mm. Ledges stay.
Face thinned(const Face& face, double tolerance_mm);

// Without the rows that are nearer than that to the one before, ledges included; both ends stay.
Face spread(const Face& face, double nearest_mm);

// The smallest distance between two faces, or between a face and the axis.
double thinnest_mm(const PotRings& rings);

}  // namespace onggi::exporter
