#include "game/clay/studio/pot.h"

#include <algorithm>

#include "game/clay/studio/studio_parameters.h"

namespace onggi::clay {

double linear_shrinkage(ClayBody body) {
    switch (body) {
        case ClayBody::kStoneware:
            return 0.12;
        case ClayBody::kPorcelain:
            return 0.14;
        case ClayBody::kEarthenware:
            return 0.08;
    }
    return 0.0;
}

double shrunk_scale(ClayBody body, Firing stage) {
    const double s = linear_shrinkage(body);
    switch (stage) {
        case Firing::kWet:
            return 1.0;
        case Firing::kDry:
            return 1.0 - 0.5 * s;
        case Firing::kBisque:
            return 1.0 - (0.5 + 1.0 / 12.0) * s;
        case Firing::kGlaze:
            return 1.0 - s;
    }
    return 1.0;
}

double wet_scale_of_fired(ClayBody body) {
    return 1.0 / shrunk_scale(body, Firing::kGlaze);
}

double wall_thickness_mm(const studio::Rings& rings, double y) {
    if (rings.count == 0 || !(y >= 0.0 && y <= rings.top_mm())) return 0.0;
    return rings.wall_mm(rings.ring_at(y));
}

PotMeasures measure_pot(const studio::Rings& rings, ClayBody body, Firing stage) {
    constexpr double kMm3PerMl = 1000.0;
    const double scale = shrunk_scale(body, stage);
    PotMeasures pot;
    if (rings.count == 0) return pot;
    double kept = 1.0;
    if (stage != Firing::kWet) kept *= 0.8;
    if (stage == Firing::kBisque || stage == Firing::kGlaze) kept *= 0.9;
    pot.mass_g = rings.on_wheel_mm3() * studio::kDensityGPerMm3 * kept;
    pot.height_mm = rings.top_mm() * scale;
    pot.floor_mm = rings.floor_mm() * scale;
    pot.foot_mm = 2.0 * rings.outer_mm.front() * scale;
    pot.mouth_mm = 2.0 * rings.outer_mm[studio::Rings::at(rings.count - 1)] * scale;
    // The hollow that is open above and has a floor; a film of clay is none.
    constexpr double kLidMm = 0.05;
    double hollow_mm3 = 0.0;
    double solid_mm = 0.0;
    bool has_floor = false;
    for (int i = 0; i < rings.count; ++i) {
        const std::size_t at = studio::Rings::at(i);
        pot.widest_mm = std::max(pot.widest_mm, 2.0 * rings.outer_mm[at] * scale);
        if (!rings.is_hollow(i)) {
            solid_mm += rings.height_mm[at];
            if (solid_mm < kLidMm) continue;
            hollow_mm3 = 0.0;
            has_floor = true;
            continue;
        }
        solid_mm = 0.0;
        const double wall = rings.wall_mm(i) * scale;
        pot.thickest_wall_mm = std::max(pot.thickest_wall_mm, wall);
        pot.thinnest_wall_mm = pot.thinnest_wall_mm > 0.0 ? std::min(pot.thinnest_wall_mm, wall) : wall;
        hollow_mm3 += kPi * rings.inner_mm[at] * rings.inner_mm[at] * rings.height_mm[at];
    }
    if (has_floor) pot.capacity_ml = hollow_mm3 * scale * scale * scale / kMm3PerMl;
    return pot;
}

}  // namespace onggi::clay
