#include "game/clay/studio/trimming.h"

#include <algorithm>
#include <cmath>

#include "game/clay/studio/pot.h"
#include "game/clay/studio/strength.h"

namespace onggi::clay::studio {

double foot_wall_mm(const Rings& rings) {
    constexpr double kAboveFloorMm = 4.0;
    if (rings.first_hollow >= rings.count) return 0.0;
    const double y_mm = rings.floor_mm() + kAboveFloorMm;
    return y_mm < rings.top_mm() ? wall_thickness_mm(rings, y_mm) : 0.0;
}

double least_outer_mm(const Rings& rings, int i) noexcept {
    constexpr int kBeside = 6;  // rings, for the slope
    const int first = rings.first_hollow;
    if (first >= rings.count) return kTrimmedFootMm;
    const double corner_mm = rings.inner_mm[Rings::at(first)];
    if (!rings.is_hollow(i)) {
        const double below_mm = rings.floor_mm() - rings.centre_mm(i);
        return below_mm < kTrimmedWallMm ? std::max(corner_mm + kTrimmedWallMm, kTrimmedFootMm)
                                         : std::max(0.5 * corner_mm, kTrimmedFootMm);
    }
    const int low = std::max(i - kBeside, first);
    const int high = std::min(i + kBeside, rings.count - 1);
    const double rise_mm = rings.centre_mm(high) - rings.centre_mm(low);
    const double lean =
        rise_mm > 0.0 ? (rings.inner_mm[Rings::at(high)] - rings.inner_mm[Rings::at(low)]) / rise_mm : 0.0;
    return rings.inner_mm[Rings::at(i)] + kTrimmedWallMm * std::sqrt(1.0 + lean * lean);
}

void dry_to_leather(Rings& rings) noexcept {
    constexpr auto kLeather = static_cast<float>(kLeatherHardLiquidity);
    for (int i = 0; i < rings.count; ++i) {
        rings.film[Rings::at(i)] = 0.0F;
        if (rings.liquidity[Rings::at(i)] > kLeather) set_liquidity(rings, i, kLeatherHardLiquidity);
    }
}

}  // namespace onggi::clay::studio
