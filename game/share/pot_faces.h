// The studio clay's faces for sharing: from thousands of rings to the few rows of corners that a smooth wall
// needs, dents and off-centre as they are. Any thread but the haptic one. mm, wet size, the clay's frame: x
// along its direction 0, y up, corners counter-clockwise seen from above.
#pragma once

#include <span>
#include <vector>

#include "engine/math/math.h"
#include "game/clay/studio/rings.h"

namespace onggi::share {

// One row of a face: a circle about a centre of its own, whose corners lie that much further out.
struct FaceRow {
    double y_mm = 0.0;
    double radius_mm = 0.0;
    dvec2 centre_mm{0.0};
    std::vector<double> dents_mm;  // one a corner; none where the whole pot is round

    [[nodiscard]] double corner_mm(std::size_t k) const {
        return dents_mm.empty() ? radius_mm : radius_mm + dents_mm[k];
    }
};
using Face = std::vector<FaceRow>;  // bottom first, heights rising

// Rings without a gap that are all solid or all hollow.
struct RingRun {
    int first = 0;
    int end = 0;
    bool hollow = false;
};

// The stack as runs, bottom first, neighbours of different kind. A run lower than 0.05 mm is a flake and goes
// with the run below it, or above the first.
std::vector<RingRun> ring_runs(const clay::studio::Rings& rings);

// How many corners a row gets, and whether rows carry dents at all.
struct Corners {
    int count = 128;  // divides twice the sectors, or the other way round
    bool dented = false;
};
bool has_dents(const clay::studio::Rings& rings);

enum class Which { kOuter, kInner };

// The face of rings [first, end) through the middle of each ring, straight between them, upright in the lower
// half of the first and the upper half of the last. Rings flatter than a micrometre are passed over.
Face face_of(const clay::studio::Rings& rings, Which which, int first, int end, const Corners& corners);

// Fewer rows, such that no radius, centre or dent is off by more than tolerance_mm.
Face thinned(const Face& face, double tolerance_mm);

// The thinnest wall of the hollow rings; 0 if there are none.
double thinnest_wall_mm(const clay::studio::Rings& rings);

}  // namespace onggi::share
