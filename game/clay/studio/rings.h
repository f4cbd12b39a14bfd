// The studio clay's stack of rings: each owns a volume and two radii; its height is a result of them, and its
// place is the running sum of the heights below. Plain state of fixed capacity: nothing here allocates after
// construction. Any one thread at a time; fit for the tick. Units: mm, mm^3, kPa.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/math/math.h"
#include "game/clay/sparse_floats.h"

namespace onggi::clay::studio {

// Clay is counted in grains of 2^-20 mm^3. A double holds every whole number of grains up to 2^33 mm^3
// without rounding, so adding, subtracting and halving volumes on the grid is exact in any order, and the
// ledger can be compared with ==. Any thread; fit for the tick.
constexpr double kGrainMm3 = 0x1p-20;

// The nearest volume on the grid. Precondition: 0 <= volume_mm3 < 2^33.
inline double on_grid(double volume_mm3) {
    return static_cast<double>(static_cast<std::int64_t>(volume_mm3 * 0x1p20 + 0.5)) * kGrainMm3;
}

inline bool is_on_grid(double volume_mm3) {
    return volume_mm3 >= 0.0 && volume_mm3 < 0x1p33 && on_grid(volume_mm3) == volume_mm3;
}

// Where every cubic millimetre of the lump is. Plain state; fit for the tick. Units: mm^3, all on the grid.
struct Ledger {
    double lump_mm3 = 0.0;       // what was put on the wheel
    double trimmings_mm3 = 0.0;  // cut off by the trimming tool, the wire, or torn off
    double slip_mm3 = 0.0;       // carried away wet by the sponge

    // What has to be there still, while the error is 0.
    [[nodiscard]] double on_wheel_mm3() const { return lump_mm3 - (trimmings_mm3 + slip_mm3); }
    // What is not accounted for: 0 exactly, or there is a bug.
    [[nodiscard]] double error_mm3(double on_wheel_mm3) const {
        return lump_mm3 - (on_wheel_mm3 + trimmings_mm3 + slip_mm3);
    }
};

// h = V / (pi (ro^2 - ri^2)), the one expression by which every height of the room is worked out.
inline double ring_height_mm(double volume_mm3, double outer_mm, double inner_mm) {
    return volume_mm3 / (kPi * ((outer_mm - inner_mm) * (outer_mm + inner_mm)));
}

// Rings share a base height in blocks, so that a change below moves a few bases instead of every ring above.
constexpr int kBlockRings = 64;

// A number of a ring as an index.
[[nodiscard]] inline std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// The columns of the stack. Ring 0 lies on the wheel head; [0, count) are real.
struct Rings {
    // Precondition: capacity from 1 to 8000, sectors a power of two.
    Rings(int capacity, int sectors);

    int count = 0;
    int capacity = 0;
    int sectors = 0;       // S
    int first_hollow = 0;  // the rings below are solid; count where all are

    std::vector<double> volume_mm3;  // V, whole grains
    std::vector<double> outer_mm;    // ro
    std::vector<double> inner_mm;    // ri, 0 in solid clay
    std::vector<double> height_mm;   // h, always ring_height_mm(V, ro, ri)
    std::vector<double> rise_mm;     // of the ring's lower face above its block's base
    std::vector<float> centre_x_mm;  // c, off-centre in the clay's frame, apart from the sectors
    std::vector<float> centre_z_mm;
    std::vector<float> rough_mm;           // largest |w| of the ring's row; 0: the row counts as zero
    std::vector<float> liquidity;          // LI
    std::vector<float> film;               // water on the faces, 0 dry to 1 dripping
    std::vector<float> strength_kpa;       // su, of LI
    std::vector<float> load_index;         // as of the last sweep
    std::vector<float> shear;              // accumulated by twist, rad
    std::vector<float> slump_rate;         // 1/s, as of the last sweep
    std::vector<float> slump_above;        // its average over the clay above, 1/s
    std::vector<float> slump_axial;        // how a unit of slump strain divides: along the wall,
    std::vector<float> slump_hoop;         // and around it
    std::vector<std::uint16_t> row;        // which row of residuals is this ring's; rows never move
    SparseFloats residual_mm;              // w, capacity rows of S
    std::vector<std::uint16_t> free_rows;  // the last free_count are free
    int free_count = 0;
    std::vector<double> base_mm;  // of each block; one more holds the top

    [[nodiscard]] bool is_hollow(int i) const { return inner_mm[at(i)] > 0.0; }
    [[nodiscard]] double wall_mm(int i) const { return outer_mm[at(i)] - inner_mm[at(i)]; }
    [[nodiscard]] double bottom_mm(int i) const { return base_mm[at(i / kBlockRings)] + rise_mm[at(i)]; }
    [[nodiscard]] double centre_mm(int i) const { return bottom_mm(i) + 0.5 * height_mm[at(i)]; }
    [[nodiscard]] double top_mm() const { return top_; }
    // Height of the floor inside: where the hollow begins. The top of a solid lump.
    [[nodiscard]] double floor_mm() const { return first_hollow < count ? bottom_mm(first_hollow) : top_; }
    [[nodiscard]] double on_wheel_mm3() const;

    [[nodiscard]] float* row_of(int i) { return residual_mm.data() + at(row[at(i)]) * at(sectors); }
    [[nodiscard]] const float* row_of(int i) const {
        return residual_mm.data() + at(row[at(i)]) * at(sectors);
    }

    // The ring at that height, [0, count); below the clay the first, above it the last.
    // Precondition: count > 0.
    [[nodiscard]] int ring_at(double y_mm) const;
    // The rings whose centres lie in [low_mm, high_mm], as [first, end).
    struct Range {
        int first = 0;
        int end = 0;
        [[nodiscard]] int size() const { return end - first; }
    };
    [[nodiscard]] Range rings_between(double low_mm, double high_mm) const;
    // Writes centre_mm(i) - from_mm for the rings of the range.
    void centres_from(double from_mm, Range range, double* out) const;

    // Works out the places again after the heights of [first, end) changed.
    void place(int first, int end);
    // Works out h of [first, end) and the places.
    void settle(int first, int end);
    // first_hollow by a look at every ring.
    void find_floor();

    // Makes room for a ring after i, a copy of ring i with a row of its own. Heights and places are the
    // caller's. Precondition: count < capacity.
    void duplicate(int i);
    // Takes rings [first, end) away; the same duties.
    void remove(int first, int end);
    // Gives all rings away and takes count solid ones of nothing.
    void reset(int rings);
    // Becomes a copy of rings of the same capacity and sectors, at the cost of what they use. No allocation.
    void copy_from(const Rings& other) noexcept;

    static std::size_t at(int i) { return studio::at(i); }

  private:
    void shift(int from, int to);

    double top_ = 0.0;
};

// Keeps the heights of the rings within bounds: a ring drawn tall is split, a flat one is joined to its
// neighbour. No volume is lost or found. A cursor looks at the rings at the pace of simulated time, so that
// the rings are the same ones at every tick rate. Haptic thread; no allocation. Units: mm, s.

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
