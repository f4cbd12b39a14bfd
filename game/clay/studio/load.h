// The load on the clay, ring by ring, and how it fails: weight, spin, overhang and twist against twice its
// strength. A cursor goes from the top down at the pace of simulated time. If a ring is overloaded, a second
// pass goes up and lets the wall slump. Haptic thread; no allocation. Units: mm, s, kPa, rad, N mm.
#pragma once

#include <cmath>
#include <cstdint>

#include "game/clay/studio/moves.h"

namespace onggi::clay::studio {

// Load indices at which something reacts; a ring gives way at 1. All are chosen.
// A picture of the pot cut open hatches the wall earlier still (kLoadWarns in shaders/load.h): it is a still
// for study, and shows early where the wall bears much.
// The clay begins to feel soft: a sign that disturbs nothing, so it comes early.
constexpr double kSoftensAtLoad = 0.70;
// A forgiving wheel slows down: it corrects its own speed before the visitor needs a warning.
constexpr double kForgivenLoad = 0.80;
// Guided moves that thin or widen stop here, and fade over kGuardWidth before: a finger alone hardly gets
// beyond it.
constexpr double kGuardedLoad = 0.85;
constexpr double kGuardWidth = 0.20;
// The kiosk shows a warning: only where the guard no longer helps, because a warning interrupts ...
constexpr double kWarnedLoad = kGuardedLoad;
// ... and it takes the warning back far enough below that it does not flicker.
constexpr double kRelaxedLoad = 0.70;

enum class Cause { kNone, kWeight, kSpin, kOverhang, kTwist };

// The stresses in one ring, kPa; tension positive, pressure negative. The limit is 2 su, the load that clay
// of undrained strength su bears along one axis (Tresca). They are combined after von Mises; MODEL.md states
// the source of each law.
//   sz   -rho g (S0 + V/2)/(pi (ro^2 - ri^2)), the weight above; S0 the volume above
//   sth  rho w^2 ro^2, hoop of the spin (0.41 of it in solid clay), and rho g R T of the slope
//   sb   3 rho g Le^2/tn, bending by the overhang L = 2 |S1/S0 - R|, held by the shell: 1/Le^2 = 1/L^2 +
//        1/(0.5 R tn |T|), tn = t/sqrt(1 + T^2); S1 the sum of V R above
//   tau  Q/(2 pi R^2 t), twist by the hands' friction Q above the ring; 2 Q/(pi ro^3) in solid clay
struct Stress {
    double weight_kpa = 0.0;  // sz, negative
    double spin_kpa = 0.0;    // part of sth from the spin
    double slope_kpa = 0.0;   // part of sth from the slope
    double bending_kpa = 0.0;
    double twist_kpa = 0.0;

    [[nodiscard]] double axial_kpa() const { return weight_kpa - bending_kpa; }
    [[nodiscard]] double hoop_kpa() const { return spin_kpa + slope_kpa; }
    // sqrt(sz^2 + sth^2 - sz sth + 3 tau^2), after von Mises.
    [[nodiscard]] double equivalent_kpa() const {
        const double sz = axial_kpa();
        const double sth = hoop_kpa();
        return std::sqrt(sz * sz + sth * sth - sz * sth + 3.0 * twist_kpa * twist_kpa);
    }
    [[nodiscard]] Cause cause() const;  // the largest stress
};

// Sums over the rings above a ring.
struct Above {
    double volume_mm3 = 0.0;         // S0
    double volume_radius_mm4 = 0.0;  // S1
};

Stress stress_in(const Rings& rings, int i, const Above& above, double wheel_speed_rad_s,
                 double twist_n_mm) noexcept;

// The first ring that gave way, and why.
struct Failure {
    Cause cause = Cause::kNone;
    double height_mm = 0.0;
    double radius_mm = 0.0;
    double load_index = 0.0;
    double stress_kpa = 0.0;
    double strength_kpa = 0.0;
    double wheel_speed_rad_s = 0.0;
    bool torn = false;  // the wall tore off
};

// The sweep's cursor and running sums. Plain state.
struct LoadSweep {
    bool goes_up = false;  // the pass that applies a slump
    int next = 0;          // going down: one past the next ring; going up: the next ring
    double credit = 0.0;   // rings paid for by simulated time
    std::uint64_t round = 0;
    Above above;
    float running = 0.0F;  // running average of slump rates, down or up
    bool last_hollow = false;
    bool slumps = false;      // some ring of this round slumps
    double peak_index = 0.0;  // of the previous round
    double peak_height_mm = 0.0;
    Cause peak_cause = Cause::kNone;
    double growing_peak = 0.0;  // of this round
    double growing_height_mm = 0.0;
    Cause growing_cause = Cause::kNone;
    int tear_at = -1;
    Failure failure;
};

// Duration of a round over all rings.
constexpr double kSweepS = 0.025;

struct LoadInput {
    double wheel_speed_rad_s = 0.0;
    double twist_n_mm = 0.0;  // friction of the hands; rings above twist_height_mm are not twisted
    double twist_height_mm = 0.0;
    double evaporation_g_mm2_s = 0.0;
    double film_time_s = 20.0;
    double diffusivity_mm2_s = 0.0;
    bool slumps = true;
    double dt_s = 0.001;
};

// Does one tick's share of the work. Returns the rings whose radii changed.
Changed sweep_load(LoadSweep& sweep, Rings& rings, const LoadInput& input) noexcept;

// Keep the cursor at its ring when rings are split or joined.
void after_split(LoadSweep& sweep, int ring) noexcept;
void after_join(LoadSweep& sweep, int lower_ring) noexcept;
// Starts a new round, for a stack that has changed.
void restart(LoadSweep& sweep, const Rings& rings) noexcept;

}  // namespace onggi::clay::studio
