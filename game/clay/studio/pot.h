// Measures of a pot: weight, capacity, walls, and its size after firing. Any thread; not for the tick. Units:
// mm, g, ml.
#pragma once

#include "game/clay/studio/lump.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay {

enum class Firing { kWet, kDry, kBisque, kGlaze };

// Linear shrinkage from wet to glaze-fired: stoneware 12 %, porcelain 14 %, earthenware 8 %.
double linear_shrinkage(ClayBody body);
// Factor on a wet length at that stage: 1 - s when glaze-fired, with half of s from drying and a twelfth of s
// more from the bisque fire.
double shrunk_scale(ClayBody body, Firing stage);
// Factor on a fired length for the wet size to throw: 1/(1 - s).
double wet_scale_of_fired(ClayBody body);

struct PotMeasures {
    double mass_g = 0.0;  // wet
    double height_mm = 0.0;
    double widest_mm = 0.0;  // outer diameters, as museums measure: the largest, at the rim, at the foot
    double mouth_mm = 0.0;
    double foot_mm = 0.0;
    double floor_mm = 0.0;
    double capacity_ml = 0.0;       // up to the rim
    double thinnest_wall_mm = 0.0;  // of the hollow part; 0 without one
    double thickest_wall_mm = 0.0;
};

// At kWet, the pot as it stands on the wheel; lengths, capacity and mass follow the stage. Drying takes a
// fifth of the mass and the bisque fire a tenth of the rest: a model.
PotMeasures measure_pot(const studio::Rings& rings, ClayBody body, Firing stage = Firing::kWet);

// Thickness of the wall at that height, from outer to inner face; the radius where the clay is solid; 0 above
// the pot.
double wall_thickness_mm(const studio::Rings& rings, double y_mm);

}  // namespace onggi::clay
