#include "game/clay/studio/strength.h"

#include <algorithm>
#include <cmath>

#include "game/clay/exact_math.h"

namespace onggi::clay::studio {
namespace {

// Water by mass at which clay turns from plastic to liquid, beyond the plastic limit: the plasticity index of
// a throwing clay; and the dry share of a gram of plastic clay.
constexpr double kPlasticityIndex = 0.20;
constexpr double kDryShare = 0.80;

constexpr double kReferenceKpa = 13.0;

}  // namespace

double strength_kpa(double liquidity_index) {
    constexpr double kLogRatio = -4.360047727955107;  // ln(2.3/180)
    return 180.0 * exponential(kLogRatio * liquidity_index);
}

double flow_time_s(double strength, double flow_time_at_13_kpa_s) {
    return flow_time_at_13_kpa_s * std::sqrt(strength / kReferenceKpa);
}

double relaxed_share(double x) {
    constexpr double kSmall = 0.125;
    if (!(x < kSmall)) return 1.0 - exponential(-x);
    // x (1 - x/2 (1 - x/3 (1 - ...))): nothing cancels where x is small, as it is in a tick. Next term:
    // x^10/10!.
    constexpr double kParts[] = {1.0 / 9, 1.0 / 8, 1.0 / 7, 1.0 / 6, 1.0 / 5, 1.0 / 4, 1.0 / 3, 1.0 / 2, 1.0};
    double series = 1.0;
    for (int k = 0; k < 8; ++k)
        series = 1.0 - x * kParts[k] * series;
    return x * series;
}

void set_liquidity(Rings& rings, int i, double liquidity_index) {
    const double liquidity = std::clamp(liquidity_index, static_cast<double>(kDriestLiquidity),
                                        static_cast<double>(kWettestLiquidity));
    rings.liquidity[Rings::at(i)] = static_cast<float>(liquidity);
    rings.strength_kpa[Rings::at(i)] = static_cast<float>(strength_kpa(liquidity));
}

void refresh_ring(Rings& rings, int i, double elapsed_s, double evaporation_g_mm2_s) {
    const std::size_t at = Rings::at(i);
    // Faces per volume of a wall 2/t; of solid clay 2/ro, its outer face alone.
    const double faces = rings.is_hollow(i) ? 2.0 / rings.wall_mm(i) : 2.0 / rings.outer_mm[at];
    const double lost = evaporation_g_mm2_s * elapsed_s * faces / (kDensityGPerMm3 * kDryShare);
    set_liquidity(rings, i, static_cast<double>(rings.liquidity[at]) - lost / kPlasticityIndex);
}

void wet_ring(Rings& rings, int i, double water_g) {
    const std::size_t at = Rings::at(i);
    const double dry_g = rings.volume_mm3[at] * kDensityGPerMm3 * kDryShare;
    rings.liquidity[at] = std::min(
        rings.liquidity[at] + static_cast<float>(water_g / (dry_g * kPlasticityIndex)), kWettestLiquidity);
}

}  // namespace onggi::clay::studio
