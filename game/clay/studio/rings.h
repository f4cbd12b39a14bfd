// The studio clay's stack of rings. Each ring owns a volume and two radii; its height follows from them, and
// its place is the running sum of the heights below. Plain state of fixed capacity: no allocation after
// construction. Any one thread at a time; fit for the tick. Units: mm, mm^3, kPa.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/math/math.h"
#include "game/clay/sparse_floats.h"

namespace onggi::clay::studio {

// Clay is counted in grains of 2^-20 mm^3. A double holds every integer number of grains up to 2^33 mm^3
// without rounding, so adding, subtracting and halving volumes on this grid is exact in any order, and the
// ledger can be compared with ==. Any thread; fit for the tick.
constexpr double kGrainMm3 = 0x1p-20;

// The nearest volume on the grid. Precondition: 0 <= volume_mm3 < 2^33.
inline double on_grid(double volume_mm3) {
    return static_cast<double>(static_cast<std::int64_t>(volume_mm3 * 0x1p20 + 0.5)) * kGrainMm3;
}

inline bool is_on_grid(double volume_mm3) {
    return volume_mm3 >= 0.0 && volume_mm3 < 0x1p33 && on_grid(volume_mm3) == volume_mm3;
}

// Accounts for every cubic millimetre of the lump. Plain state; fit for the tick. Units: mm^3, all on the
// grid.
struct Ledger {
    double lump_mm3 = 0.0;       // put on the wheel at the start
    double trimmings_mm3 = 0.0;  // cut off by the trimming tool, the wire, or torn off
    double slip_mm3 = 0.0;       // carried away wet by the sponge

    // The volume that must still be on the wheel, while the error is 0.
    [[nodiscard]] double on_wheel_mm3() const { return lump_mm3 - (trimmings_mm3 + slip_mm3); }
    // The volume not accounted for: exactly 0 unless there is a bug.
    [[nodiscard]] double error_mm3(double on_wheel_mm3) const {
        return lump_mm3 - (on_wheel_mm3 + trimmings_mm3 + slip_mm3);
    }
};

// h = V / (pi (ro^2 - ri^2)). All heights of this room are computed by this expression.
inline double ring_height_mm(double volume_mm3, double outer_mm, double inner_mm) {
    return volume_mm3 / (kPi * ((outer_mm - inner_mm) * (outer_mm + inner_mm)));
}

// Rings share a base height in blocks, so that a change below updates a few bases instead of every ring
// above.
constexpr int kBlockRings = 64;

// The height of a ring's middle.
[[nodiscard]] inline double centre_above(double base_mm, double rise_mm, double height_mm) {
    return base_mm + rise_mm + 0.5 * height_mm;
}

// A ring number as an index.
[[nodiscard]] inline std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// The stack, one column a quantity. Ring 0 lies on the wheel head; [0, count) exist.
struct Rings {
    // Precondition: capacity from 1 to 8000, sectors a power of two.
    Rings(int capacity, int sectors);

    int count = 0;
    int capacity = 0;
    int sectors = 0;       // S
    int first_hollow = 0;  // the rings below are solid; count if all are

    std::vector<double> volume_mm3;  // V, whole grains
    std::vector<double> outer_mm;    // ro
    std::vector<double> inner_mm;    // ri, 0 in solid clay
    std::vector<double> height_mm;   // h, always ring_height_mm(V, ro, ri)
    std::vector<double> rise_mm;     // height of the ring's lower face above its block's base
    std::vector<float> centre_x_mm;  // c, off-centre in the clay's frame, without the sectors
    std::vector<float> centre_z_mm;
    std::vector<float> rough_mm;           // largest |w| of the ring's row; 0: the row counts as zero
    std::vector<float> liquidity;          // LI
    std::vector<float> film;               // water on the faces, 0 dry to 1 dripping
    std::vector<float> strength_kpa;       // su, from LI
    std::vector<float> load_index;         // as of the last sweep
    std::vector<float> shear;              // accumulated by twist, rad
    std::vector<float> slump_rate;         // 1/s, as of the last sweep
    std::vector<float> slump_above;        // average rate over the clay above, 1/s
    std::vector<float> slump_axial;        // slump strain along the wall, per unit strain,
    std::vector<float> slump_hoop;         // and around it
    std::vector<std::uint16_t> row;        // index of this ring's row of residuals; rows never move
    SparseFloats residual_mm;              // w, capacity rows of S
    std::vector<std::uint16_t> free_rows;  // the last free_count are free
    int free_count = 0;
    std::vector<double> base_mm;  // base height of each block; one more entry holds the top

    [[nodiscard]] bool is_hollow(int i) const { return inner_mm[at(i)] > 0.0; }
    [[nodiscard]] double wall_mm(int i) const { return outer_mm[at(i)] - inner_mm[at(i)]; }
    [[nodiscard]] double bottom_mm(int i) const { return base_mm[at(i / kBlockRings)] + rise_mm[at(i)]; }
    [[nodiscard]] double centre_mm(int i) const {
        return centre_above(base_mm[at(i / kBlockRings)], rise_mm[at(i)], height_mm[at(i)]);
    }
    [[nodiscard]] double top_mm() const { return top_; }
    // Height of the floor inside, where the hollow begins; the top for a solid lump.
    [[nodiscard]] double floor_mm() const { return first_hollow < count ? bottom_mm(first_hollow) : top_; }
    [[nodiscard]] double on_wheel_mm3() const;

    [[nodiscard]] float* row_of(int i) { return residual_mm.data() + at(row[at(i)]) * at(sectors); }
    [[nodiscard]] const float* row_of(int i) const {
        return residual_mm.data() + at(row[at(i)]) * at(sectors);
    }

    // The ring at that height, in [0, count); the first below the clay, the last above it. Precondition:
    // count > 0.
    [[nodiscard]] int ring_at(double y_mm) const;
    // The rings whose centres lie in [low_mm, high_mm], as [first, end).
    struct Range {
        int first = 0;
        int end = 0;
        [[nodiscard]] int size() const { return end - first; }
    };
    [[nodiscard]] Range rings_between(double low_mm, double high_mm) const;
    // Writes centre_mm(i) for the rings of the range.
    void centres(Range range, double* out) const;
    // Writes centre_mm(i) - from_mm for the rings of the range, rounded otherwise.
    void centres_from(double from_mm, Range range, double* out) const;

    // Updates the places after the heights of [first, end) changed.
    void place(int first, int end);
    // Computes h of [first, end) and the places.
    void settle(int first, int end);
    // Computes first_hollow from all rings.
    void find_floor();

    // Inserts a copy of ring i after it, with a row of its own. The caller updates heights and places.
    // Precondition: count < capacity.
    void duplicate(int i);
    // Removes rings [first, end). The caller updates heights and places.
    void remove(int first, int end);
    // Removes all rings and adds `rings` solid ones without volume.
    void reset(int rings);
    // Copies rings of the same capacity and sectors; the cost depends on the rings in use. No allocation.
    void copy_from(const Rings& other) noexcept;

    static std::size_t at(int i) { return studio::at(i); }

  private:
    void shift(int from, int to);

    double top_ = 0.0;
};

// Keeps the heights of the rings within bounds: a tall ring is split, a flat one is joined to its neighbour.
// Volume is kept exactly. A cursor visits the rings at the pace of simulated time, so that the result is the
// same at every tick rate. Haptic thread; no allocation. Units: mm, s.

// The target ring height: 200 mm over the nominal number of rings; more for a tall pot, so that it fits the
// capacity.
double target_height_mm(const Rings& rings, int nominal_rings);

// Splits ring i in two halves on the grid, with radii that follow the slope. Precondition: count < capacity.
void split_ring(Rings& rings, int i);
// Joins rings i and i + 1. Volume and height are kept. Precondition: both solid or both hollow.
void join_rings(Rings& rings, int i);

// Result of one cursor step, for callers that hold ring indices.
struct Resplit {
    int changed_ring = -1;  // the ring that was split, or joined to the next one; -1 if unchanged
    bool was_split = false;
};

// The first ring of the range that tend_ring() may split or join; the range's end if there is none.
int first_to_tend(const Rings& rings, Rings::Range range, double target_mm);
// Splits or joins ring i if its height calls for it. Does not update places.
Resplit tend_ring(Rings& rings, int i, double target_mm);

}  // namespace onggi::clay::studio
