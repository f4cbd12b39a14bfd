// A studio clay on a wheel of constant speed, and a hand to move over it: shared by the tests with known
// answers.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/units.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::clay::studio {

// 120 rev/min.
constexpr double kThrowingSpeed = 4.0 * std::numbers::pi;

// As StudioClay::set_wall() takes it.
struct Wall {
    double outer_mm;
    double thickness_mm;
    double floor_mm;
    double height_mm;
    int rings;
};

struct Bench {
    explicit Bench(const StudioLump& lump = {.mass_g = 500.0}, double rate_hz = 1000.0) : clay(lump) {
        parameters.rate_hz = rate_hz;
        parameters.wheel.inertia_kg_m2 = 100.0;  // no hand slows it
        parameters.evaporation_g_mm2_s = 0.0;
        turn_at(kThrowingSpeed);
    }

    Bench(const StudioLump& lump, const Wall& of, double rate_hz = 1000.0) : Bench(lump, rate_hz) {
        wall(of.outer_mm, of.thickness_mm, of.floor_mm, of.height_mm, of.rings);
    }

    // The speed that the pedal asks for; the wheel comes to it by itself.
    void pedal(double speed_rad_s) {
        input.wheel_button = true;
        input.wheel_speed_rev_min = units::rev_min_from_rad_s(speed_rad_s);
    }
    void turn_at(double speed_rad_s) {
        pedal(speed_rad_s);
        clay.set_wheel_speed(speed_rad_s);
    }
    void wall(double outer, double thickness, double floor, double height, int rings) {
        clay.set_wall(outer, thickness, floor, height, rings);
    }
    StudioForces tick() { return clay.tick(input, parameters); }
    StudioForces at(double x, double y, double z = 0.0) {
        input.position_mm = {x, y, z};
        return tick();
    }
    // Moves the hand in a straight line, for that long.
    StudioForces move(const dvec3& to, double seconds) {
        const dvec3 from = input.position_mm;
        const int ticks = std::max(1, static_cast<int>(seconds * parameters.rate_hz + 0.5));
        StudioForces forces;
        for (int k = 1; k <= ticks; ++k) {
            input.position_mm = from + (to - from) * (static_cast<double>(k) / ticks);
            forces = tick();
        }
        return forces;
    }
    StudioForces hold(double seconds) { return move(input.position_mm, seconds); }
    void lift() { at(0.0, 1000.0); }

    [[nodiscard]] int ring_at(double y) const { return clay.rings().ring_at(y); }
    [[nodiscard]] double outer_at(double y) const {
        return clay.outer_mm()[static_cast<std::size_t>(ring_at(y))];
    }
    [[nodiscard]] double inner_at(double y) const {
        return clay.inner_mm()[static_cast<std::size_t>(ring_at(y))];
    }
    [[nodiscard]] double wall_at(double y) const { return outer_at(y) - inner_at(y); }

    StudioClay clay;
    StudioParameters parameters;
    tool::ToolState input{.position_mm = {0.0, 1000.0, 0.0}};
};

// Every ring's height is what its volume and radii make it, and no ring left its bounds.
inline void expect_sound(const StudioClay& clay) {
    for (int i = 0; i < clay.ring_count(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double outer = clay.outer_mm()[at];
        const double inner = clay.inner_mm()[at];
        ASSERT_EQ(clay.rings().height_mm[at], ring_height_mm(clay.rings().volume_mm3[at], outer, inner))
            << "ring " << i;
        ASSERT_GT(clay.rings().height_mm[at], 0.0) << "ring " << i;
        ASSERT_GE(inner, 0.0) << "ring " << i;
        ASSERT_GT(outer - inner, 1.0) << "ring " << i;
        ASSERT_LE(outer, kWidestMm) << "ring " << i;
        ASSERT_GE(outer, kNarrowestMm * 0.999) << "ring " << i;
    }
    ASSERT_EQ(clay.ledger_error_mm3(), 0.0);
}

}  // namespace onggi::clay::studio
