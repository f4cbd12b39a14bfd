// What a lump and the clay's parameters must be to be taken, and what is said of a pot that gave way.
#include <fmt/format.h>

#include "engine/core/units.h"
#include "game/clay/bounds.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::clay {
Result<void> check(const StudioLump& lump) {
    const Bound bounds[] = {
        {"mass, g", lump.mass_g, kLeastLumpG, kLargestLumpG},
        {"body", static_cast<double>(lump.body), 0.0, 2.0},
        {"liquidity index", lump.liquidity_index, 0.0, 1.2},
        {"rings", static_cast<double>(lump.rings), kFewestRings, kMostRings},
        {"sectors", static_cast<double>(lump.sectors), 16.0, 256.0},
        {"off-centre, mm", lump.off_centre_mm, 0.0, 5.0},
    };
    if (auto checked = check_bounds("lump", bounds); !checked) return checked;
    if ((lump.sectors & (lump.sectors - 1)) != 0)
        return bad_input(fmt::format("lump sectors: expected a power of two, found {}", lump.sectors));
    return {};
}

Result<void> check(const StudioParameters& p) {
    const Bound bounds[] = {
        {"rate, Hz", p.rate_hz, 100.0, 10000.0},
        {"flow time, s", p.flow_time_s, 0.01, 10.0},
        {"yield depth, mm", p.yield_depth_mm, 0.0, 5.0},
        {"wall share k0", p.wall_fraction_k0, 0.0, 0.95},
        {"thin wall, mm", p.thin_wall_mm, 1.0, 50.0},
        {"hoop share chi", p.hoop_fraction_chi, 0.0, 1.0},
        {"field length beta", p.field_length_beta, 0.1, 10.0},
        {"floor, mm", p.floor_mm, 1.0, 100.0},
        {"largest strain rate, 1/s", p.largest_strain_rate, 0.1, 50.0},
        {"centring time, s", p.centring_time_s, 0.05, 100.0},
        {"rounding time, s", p.rounding_time_s, 0.05, 100.0},
        {"denting time, s", p.denting_time_s, 0.05, 100.0},
        {"sponge length, mm", p.sponge_length_mm, 0.1, 3.0},
        {"rib length, mm", p.rib_length_mm, 0.1, 3.0},
        {"trim time, s", p.trim_time_s, 0.01, 10.0},
        {"sponge water, ml/s", p.sponge_water_ml_s, 0.0, 100.0},
        {"slip, mm/s", p.slip_mm_s, 0.0, 1.0},
        {"evaporation, g/(mm^2 s)", p.evaporation_g_mm2_s, 0.0, 1e-3},
        {"film time, s", p.film_time_s, 0.1, 1e4},
        {"diffusivity, mm^2/s", p.diffusivity_mm2_s, 0.0, 1.0},
        {"bearing factor Nc", p.bearing_factor_nc, 0.1, 100.0},
        {"viscosity c2, N s/mm", p.viscosity_c2_n_s_per_mm, 0.0, 1.0},
        {"dry friction", p.friction_dry, 0.0, 2.0},
        {"wet friction", p.friction_wet, 0.0, 2.0},
        {"largest force, N", p.largest_force_n, 0.1, 1000.0},
        {"wheel inertia, kg m^2", p.wheel.inertia_kg_m2, 1e-3, 100.0},
        {"wheel torque, N mm", p.wheel.largest_torque_n_mm, 0.0, 1e6},
        {"wheel drag, N mm s", p.wheel.drag_n_mm_s, 0.0, 1e5},
        {"wheel pull, N mm s", p.wheel.pull_n_mm_s, 0.0, 1e6},
    };
    return check_bounds("clay parameter", bounds);
}

std::string sentence(const studio::Failure& failure) {
    const double speed = units::rev_min_from_rad_s(failure.wheel_speed_rad_s);
    const std::string what = fmt::format("at {:.0f} mm the clay held {:.1f} kPa and had to carry {:.1f}",
                                         failure.height_mm, 2.0 * failure.strength_kpa, failure.stress_kpa);
    switch (failure.cause) {
        case studio::Cause::kNone:
            return {};
        case studio::Cause::kWeight:
            return fmt::format("The wall sank under its own weight: {}.", what);
        case studio::Cause::kSpin:
            return fmt::format("The wheel spun the wall apart: {:.0f} rev/min on {:.0f} mm across, {}.",
                               speed, 2.0 * failure.radius_mm, what);
        case studio::Cause::kOverhang:
            return fmt::format("The wall leaned out too far and sagged: {}.", what);
        case studio::Cause::kTwist:
            return fmt::format("The hands {} the wall: {}; more water on them would let it slide.",
                               failure.torn ? "tore off" : "twisted", what);
    }
    return {};
}

}  // namespace onggi::clay
