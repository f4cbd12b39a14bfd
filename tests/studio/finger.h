// A finger that guides simulated hands on a pot: shared by the tests of grips and tools.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/core/units.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::clay::studio {

// The way of a second finger, if it is there.
struct FingerWay {
    dvec2 from{0.0};
    dvec2 to{0.0};
    bool is_there = false;
};

// A finger on the clay's plane, a millisecond at a time whatever the rate.
struct Finger {
    explicit Finger(double rate_hz = 1000.0, double mass_g = 1000.0) : clay({.mass_g = mass_g}) {
        parameters.rate_hz = rate_hz;
        parameters.forgiving = true;
        input.guided = true;
        input.pressing = false;
        input.water = 0.5;
        pedal(11.5);
        wait(1.0);
    }

    // The speed that the pedal asks for.
    void pedal(double speed_rad_s) {
        input.wheel_button = true;
        input.wheel_speed_rev_min = units::rev_min_from_rad_s(speed_rad_s);
    }
    void tick() {
        const bool counts = input.pressing;
        forces = clay.tick(input, parameters);
        EXPECT_TRUE(!counts || clay.ledger_error_mm3() == 0.0);
    }
    void wait(double seconds) {
        input.pressing = false;
        for (int i = 0; i < static_cast<int>(seconds * parameters.rate_hz); ++i)
            tick();
    }
    // Presses from one place to another; both at the same moments at every rate.
    void stroke(const dvec2& from, const dvec2& to, double seconds) {
        move(from, to, seconds);
        lift();
    }
    void lift() {
        input.pressing = false;
        input.second = {};
        tick();
    }
    // The same without lifting, and with a second finger if it is there.
    void move(const dvec2& from, const dvec2& to, double seconds, const FingerWay& second = {}) {
        input.pressing = true;
        input.second.present = second.is_there;
        const int ticks = static_cast<int>(seconds * parameters.rate_hz);
        const int each = static_cast<int>(parameters.rate_hz / 1000.0);
        for (int i = 0; i < ticks; ++i) {
            const double part = static_cast<double>(i / each) * each / ticks;
            const dvec2 place = from + (to - from) * part;
            input.position_mm = {place.x, place.y, tool::z_of_push(push)};
            if (second.is_there)
                input.second.position_mm = dvec3(second.from + (second.to - second.from) * part, 0.0);
            tick();
        }
    }
    void open() { stroke({0.0, clay.height_mm()}, {0.0, 10.0}, 2.0); }
    void pull(double to_mm) {
        const double rim = clay.outer_mm().back();
        stroke({clay.outer_mm()[clay.outer_mm().size() / 4] + 1.0, 0.3 * clay.height_mm()}, {rim, to_mm},
               3.0);
    }
    [[nodiscard]] std::vector<double> faces() const {
        std::vector<double> all(clay.outer_mm().begin(), clay.outer_mm().end());
        all.insert(all.end(), clay.inner_mm().begin(), clay.inner_mm().end());
        return all;
    }

    StudioClay clay;
    StudioParameters parameters;
    tool::ToolState input;
    StudioForces forces;
    double push = 1.0;
};

}  // namespace onggi::clay::studio
