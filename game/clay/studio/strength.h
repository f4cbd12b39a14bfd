// How strong clay is by its water, and how it gives and takes water. Any thread; fit for the tick.
// Units: kPa, mm, s, g. The model is a mean of thirty soils: call it a model.
#pragma once

#include "game/clay/studio/rings.h"
#include "game/clay/studio/studio_parameters.h"

namespace onggi::clay::studio {

constexpr float kDriestLiquidity = -0.5F;
constexpr float kWettestLiquidity = 1.2F;

// Undrained strength su = 180 (2.3/180)^LI kPa.
double strength_kpa(double liquidity_index);

// How long clay of that strength takes to flow: tau = tau_13 sqrt(su/13).
double flow_time_s(double strength, double flow_time_at_13_kpa_s);

// 1 - exp(-x), for a share that relaxes in one step. Precondition: 0 <= x <= 700.
double relaxed_share(double x);

// Sets LI of a ring and the strength that follows.
void set_liquidity(Rings& rings, int i, double liquidity_index);

// Lets ring i dry from its faces for elapsed_s, thin walls faster, and works out its strength again.
void refresh_ring(Rings& rings, int i, double elapsed_s, double evaporation_g_mm2_s);

// Gives ring i water; the strength follows at its next refresh. The ledger counts clay: nothing swells.
void wet_ring(Rings& rings, int i, double water_g);

}  // namespace onggi::clay::studio
