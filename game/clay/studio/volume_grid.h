// Clay is counted in grains of 2^-20 mm^3. A double holds every whole number of grains up to 2^33 mm^3
// without rounding, so adding, subtracting and halving volumes on the grid is exact in any order, and the
// ledger can be compared with ==. Any thread; fit for the tick.
#pragma once

#include <cstdint>

namespace onggi::clay::studio {

constexpr double kGrainMm3 = 0x1p-20;

// The nearest volume on the grid. Precondition: 0 <= volume_mm3 < 2^33.
inline double on_grid(double volume_mm3) {
    return static_cast<double>(static_cast<std::int64_t>(volume_mm3 * 0x1p20 + 0.5)) * kGrainMm3;
}

inline bool is_on_grid(double volume_mm3) {
    return volume_mm3 >= 0.0 && volume_mm3 < 0x1p33 && on_grid(volume_mm3) == volume_mm3;
}

}  // namespace onggi::clay::studio
