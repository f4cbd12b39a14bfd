// How strong clay is by its water, and how it gives and takes water. Any thread; fit for the tick.
// Units: kPa, mm, s, g. The model is a mean of thirty soils (MODEL.md): call it a model. Besides the water in
// each ring a wet hand leaves a film on the faces it touches, which makes them slide and soaks in, and water
// passes between neighbours by Fick's law.
#pragma once

#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

constexpr float kDriestLiquidity = -0.5F;
constexpr float kWettestLiquidity = 1.2F;

// Undrained strength su = 180 (2.3/180)^LI kPa.
double strength_kpa(double liquidity_index);

// How long clay of that strength takes to flow: tau = tau_13 sqrt(su/13).
double flow_time_s(double strength, double flow_time_at_13_kpa_s);

// 1 - exp(-x), for a fraction that relaxes in one step. Precondition: 0 <= x <= 700.
double relaxed_fraction(double x);

// Sets LI of a ring and the strength that follows.
void set_liquidity(Rings& rings, int i, double liquidity_index);

// What the water of a ring does in elapsed_s.
struct WaterPace {
    double elapsed_s = 0.0;
    double evaporation_g_mm2_s = 0.0;
    double film_time_s = 20.0;
    double diffusivity_mm2_s = 0.0;
};

// Lets ring i dry from its faces, thin walls faster; lets the film on it soak in; lets water pass between it
// and the ring above, from the wetter to the drier; and works out its strength again.
void refresh_ring(Rings& rings, int i, const WaterPace& pace);

// The faces of the rings a wet hand touches are as wet as the hand. depth_mm[k] is of ring first + k.
void wet_faces(Rings& rings, int first, int end, const double* depth_mm, double film);

// Gives ring i water; the strength follows at its next refresh. The ledger counts clay: nothing swells.
void wet_ring(Rings& rings, int i, double water_g);

// Takes water from ring i, and that fraction of what stands on it as a film; none out of clay that is as firm
// as fresh clay.
void drain_ring(Rings& rings, int i, double water_g, double film_fraction);

}  // namespace onggi::clay::studio
