// Constants of the studio clay. Plain values. Units: mm, N, s, rad, kPa, g, ml.
#pragma once

#include <cstdint>

#include "engine/core/result.h"
#include "engine/math/math.h"
#include "game/clay/studio/wheel.h"

namespace onggi::clay {

namespace studio {

// Bounds that no ring leaves, whatever the hands do.
constexpr double kThinnestWallMm = 1.5;
constexpr double kNarrowestMm = 6.0;  // outer radius
constexpr double kWidestMm = 150.0;   // the wheel head
constexpr double kTallestMm = 350.0;
constexpr double kDeepestMm = 10.0;  // flow and force of a deeper tool stop growing here

constexpr double kDensityGPerMm3 = 1.9e-3;
constexpr double kGravityMmS2 = 9810.0;
constexpr double kKpaPerNMm2 = 1000.0;

// How skilled hands follow a finger (grip_work.h). A session states its manner and replays with it.
enum class Manner : std::uint8_t {
    kNarrow = 1,  // sessions before HST4: the opening stays as narrow as the thumbs
    kWide = 2,    // the opening grows as wide as a potter's, and a pull takes a part of what is left
};

}  // namespace studio

struct StudioParameters {
    double rate_hz = 1000.0;  // f

    // Flow: Eq. (2) with a yield, d <- dy + (d - dy) exp(-dt/tau).
    double flow_time_s = 0.10;       // tau at the reference strength
    double yield_depth_mm = 0.25;    // dy
    double wall_fraction_k0 = 0.5;   // fraction of the displaced clay that crosses the wall to its other face
    double thin_wall_mm = 7.0;       // t0, where yielding as a whole is as easy as denting
    double hoop_fraction_chi = 0.5;  // fraction of a wall's hoop strain that goes into thickness
    double field_length_beta = 2.5;  // L = beta sqrt(R t)
    double floor_mm = 12.0;          // kept when opening
    double largest_strain_rate = 8.0;  // of a ring's height, 1/s

    double centring_time_s = 1.0;   // tau_c
    double rounding_time_s = 0.25;  // tau_w, of sectors under the tool while the wheel turns
    double denting_time_s = 0.5;    // of sectors under the tool while the wheel stands

    double sponge_length_mm = 0.7;  // lambda
    double rib_length_mm = 1.2;     // a rib is stiffer than a sponge
    double trim_time_s = 0.05;      // shorter than the flow: a trimming tool cuts, it does not knead

    // Strength and water.
    double sponge_water_ml_s = 0.5;       // water from a dripping sponge while it touches
    double slip_mm_s = 0.01;              // clay carried off by a wet sponge
    double evaporation_g_mm2_s = 5.6e-8;  // 0.2 kg per square metre and hour
    double film_time_s = 20.0;            // decay of the film on hands and faces
    double diffusivity_mm2_s = 5e-3;      // of water from ring to ring: 1.5 mm in five minutes
    bool slumps = true;                   // overloaded clay gives way
    bool forgiving = false;               // the wheel slows by itself before the clay fails

    studio::Manner manner = studio::Manner::kWide;  // of the hands that follow a finger

    // Feel.
    double bearing_factor_nc = 6.0;          // Nc
    double viscosity_c2_n_s_per_mm = 0.002;  // c2 of Eq. (6)
    double friction_dry = 0.5;               // mu
    double friction_wet = 0.2;
    double largest_force_n = 30.0;  // bound of every hand's force

    studio::WheelParameters wheel;

    [[nodiscard]] double dt_s() const { return 1.0 / rate_hz; }
};

// Refuses parameters that the tick cannot use; the message names the parameter.
Result<void> check(const StudioParameters& parameters);

}  // namespace onggi::clay
