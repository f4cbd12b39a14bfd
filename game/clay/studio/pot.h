// What a potter asks of a pot: weight, capacity, walls, and how large it comes out of the kiln. Any thread;
// not for the tick. Units: mm, g, ml.
#pragma once

#include "game/clay/studio/lump.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay {

enum class Firing { kWet, kDry, kBisque, kGlaze };

// Linear shrinkage from wet to glaze-fired: stoneware 12 %, porcelain 14 %, earthenware 8 %.
double linear_shrinkage(ClayBody body);
// What a wet length is times, at that stage: 1 - s when glaze-fired; half of s comes with drying and a
// twelfth more with the bisque fire.
double shrunk_scale(ClayBody body, Firing stage);
// The wet size at which to throw for a fired one: 1/(1 - s).
double wet_scale_of_fired(ClayBody body);

struct PotMeasures {
    double mass_g = 0.0;  // wet
    double height_mm = 0.0;
    double widest_mm = 0.0;  // diameters
    double mouth_mm = 0.0;
    double foot_mm = 0.0;
    double floor_mm = 0.0;
    double capacity_ml = 0.0;       // up to the rim
    double thinnest_wall_mm = 0.0;  // of the hollow part; 0 where there is none
    double thickest_wall_mm = 0.0;
};

// As it stands on the wheel at kWet; lengths, capacity and mass follow the stage. Water and what burns away
// take a fifth of the mass by drying and a tenth of the rest by the bisque fire: a model.
PotMeasures measure_pot(const studio::Rings& rings, ClayBody body, Firing stage = Firing::kWet);

// Thickness of the wall at that height, from outer to inner face; the radius where the clay is solid; 0 above
// it.
double wall_thickness_mm(const studio::Rings& rings, double y_mm);

}  // namespace onggi::clay
