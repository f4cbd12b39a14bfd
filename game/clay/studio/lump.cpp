#include "game/clay/studio/lump.h"

#include <algorithm>
#include <cmath>

#include "game/clay/exact_math.h"
#include "game/clay/studio/rings.h"
#include "game/clay/studio/strength.h"
#include "game/clay/studio/studio_parameters.h"

namespace onggi::clay::studio {
namespace {

// A low dome r^2 = R^2 (1 - 3/5 (y/H)^4) of H = 4/5 R, with a flat top that can be pressed. Its volume is
// 22/25 pi R^2 H.
constexpr double kHeightPerRadius = 0.8;
constexpr double kRounding = 0.6;
constexpr double kFullness = 1.0 - kRounding / 5.0;

}  // namespace

int ring_capacity(const StudioLump& lump) {
    return 2 * lump.rings;
}

void put_lump(Rings& rings, Ledger& ledger, const StudioLump& lump) {
    const double volume = on_grid(lump.mass_g / kDensityGPerMm3);
    const double cubed = volume / (kPi * kFullness * kHeightPerRadius);
    const double radius = exponential(natural_log(cubed) / 3.0);
    const double height = kHeightPerRadius * radius;
    const int count = std::clamp(static_cast<int>(height * lump.rings / 200.0), 8, rings.capacity);
    rings.reset(count);

    double placed = 0.0;
    for (int i = count - 1; i >= 0; --i) {
        const double y = (i + 0.5) / count;
        const double square = radius * radius * (1.0 - kRounding * y * y * y * y);
        const double outer = std::max(std::sqrt(square), kNarrowestMm);
        const std::size_t at = Rings::at(i);
        // The foot takes what rounding left over.
        const double wanted = i > 0 ? on_grid(kPi * outer * outer * height / count) : volume - placed;
        rings.volume_mm3[at] = wanted;
        placed += wanted;
        rings.outer_mm[at] = outer;
        rings.centre_x_mm[at] = static_cast<float>(lump.off_centre_mm);
        set_liquidity(rings, i, lump.liquidity_index);
    }
    rings.first_hollow = count;
    rings.settle(0, count);
    ledger = {.lump_mm3 = volume};
}

}  // namespace onggi::clay::studio
