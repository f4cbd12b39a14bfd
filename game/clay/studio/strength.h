// Strength of the clay from its water, and how it takes up and loses water. Any thread; fit for the tick.
// Units: kPa, mm, s, g. The strength law is a mean of thirty soils (MODEL.md), so it is only a model. Besides
// the water in each ring, a wet hand leaves a film on the faces it touches, which makes them slide and soaks
// in. Water passes between neighbours by Fick's law.
#pragma once

#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

constexpr float kDriestLiquidity = -0.5F;
constexpr float kWettestLiquidity = 1.2F;

// Undrained strength su = 180 (2.3/180)^LI kPa.
double strength_kpa(double liquidity_index);

// Flow time of clay of that strength: tau = tau_13 sqrt(su/13).
double flow_time_s(double strength, double flow_time_at_13_kpa_s);

// 1 - exp(-x), the fraction that relaxes in one step. Precondition: 0 <= x <= 700.
double relaxed_fraction(double x);

// Sets LI of a ring and its strength.
void set_liquidity(Rings& rings, int i, double liquidity_index);

// Rates of a ring's water, and the time to apply.
struct WaterPace {
    double elapsed_s = 0.0;
    double evaporation_g_mm2_s = 0.0;
    double film_time_s = 20.0;
    double diffusivity_mm2_s = 0.0;
};

// Dries ring i from its faces (thin walls dry faster), soaks its film in, passes water between it and the
// ring above from the wetter to the drier, and updates its strength.
void refresh_ring(Rings& rings, int i, const WaterPace& pace);

// Wets the faces that a wet hand touches up to the hand's film. depth_mm[k] belongs to ring first + k.
void wet_faces(Rings& rings, int first, int end, const double* depth_mm, double film);

// Adds water to ring i; the strength follows at its next refresh. The ledger counts clay only: the clay does
// not swell.
void wet_ring(Rings& rings, int i, double water_g);

// Takes water and that fraction of the film from ring i. Clay as firm as fresh clay loses no water.
void drain_ring(Rings& rings, int i, double water_g, double film_fraction);

}  // namespace onggi::clay::studio
