// The device's part of the clay's forces, and fit_to_device() for a device's capabilities.
#include "game/haptic/device_force.h"

#include <gtest/gtest.h>

#include "game/haptic/tick.h"

namespace onggi::haptic {
namespace {

// Pressed obliquely into clay of 4 N/mm, with the wheel's drag.
clay::ContactForces pressed() {
    clay::ContactForces forces;
    forces.contacts = 3;
    forces.local_stiffness_n_per_mm = 4.0;
    forces.stiffness_n = {2.0, 1.0, 0.0};
    forces.friction_n = {0.0, 0.0, -0.8};
    return forces;
}

DeviceForce told(const DeviceFeel& feel, bool shows_wall) {
    return device_force(pressed(), {1.0, 2.0, 0.0}, 0.1, true, feel, shows_wall);
}

// A device that renders walls itself on one axis and not on the other.
haptics::DeviceCapabilities walled() {
    return {.name = "walled",
            .force_axes = 2,
            .peak_force_n = 3.3,
            .continuous_force_n = 3.3,
            .max_stiffness_n_per_mm = 0.5,
            .has_own_walls = true,
            .wire_rate_hz = 250.0,
            .moving_mass_kg = 0.1,
            .damping_n_s_per_mm = 0.0003,
            .coulomb_friction_n = 0.1};
}

TEST(DeviceForce, IsSofterByTheSameShareOnEachAxisThatIsToldItsForceOverAWire) {
    const DeviceForce raw = told({}, true);
    EXPECT_EQ(raw.wanted_n, dvec3(1.9, 0.8, -0.8));
    const DeviceFeel feel{.most_wire_stiffness_n_per_mm = 1.0};
    // A quarter of the stiffness, so a quarter of all: the spring's radius and the stick's own friction stay.
    const DeviceForce with_wall = told(feel, true);
    EXPECT_NEAR(with_wall.wanted_n.x, 1.9, 1e-12);
    EXPECT_NEAR(with_wall.wanted_n.y, 0.2, 1e-12);
    EXPECT_NEAR(with_wall.wanted_n.z, -0.8, 1e-12);
    const DeviceForce without = told(feel, false);
    EXPECT_NEAR(without.wanted_n.x, 0.475, 1e-12);
    EXPECT_NEAR(without.wanted_n.y, 0.2, 1e-12);
    EXPECT_NEAR(without.driven_n.z, -0.8, 1e-12);
}

TEST(DeviceForce, IsCappedAsAWholeFirst) {
    // At 2 N/mm everything is half; the axis over the wire is half of that again.
    const DeviceForce force =
        told({.most_stiffness_n_per_mm = 2.0, .most_wire_stiffness_n_per_mm = 1.0}, true);
    EXPECT_NEAR(force.wanted_n.x, 0.5 * 2.0 - 0.1, 1e-12);
    EXPECT_NEAR(force.wanted_n.y, 0.5 * (0.5 * 1.0 - 0.2), 1e-12);
    EXPECT_NEAR(force.wanted_n.z, -0.4, 1e-12);
}

TEST(DeviceForce, OfSoftClayIsUnchanged) {
    const DeviceFeel feel{.most_stiffness_n_per_mm = 5.0, .most_wire_stiffness_n_per_mm = 4.0};
    EXPECT_EQ(told(feel, false).wanted_n, told({}, false).wanted_n);
}

TEST(FitToDevice, BindsTheWireAndLeavesTheWallItsOwnStiffness) {
    for (const bool is_paper : {false, true}) {
        HapticParameters parameters;
        ASSERT_TRUE(fit_to_device(parameters, walled(), is_paper));
        EXPECT_EQ(parameters.feel.most_stiffness_n_per_mm, 0.5) << "the wall's own";
        EXPECT_GT(parameters.feel.most_wire_stiffness_n_per_mm, 0.02);
        EXPECT_LT(parameters.feel.most_wire_stiffness_n_per_mm, 0.5);
    }
    haptics::DeviceCapabilities no_wire = walled();
    no_wire.wire_rate_hz = 0.0;
    HapticParameters parameters;
    ASSERT_TRUE(fit_to_device(parameters, no_wire, false));
    EXPECT_EQ(parameters.feel.most_wire_stiffness_n_per_mm, 0.0);
}

TEST(FitToDevice, RefusesADeviceWithoutAStableStiffness) {
    haptics::DeviceCapabilities far = walled();
    far.wire_rate_hz = 20.0;
    far.wire_delay_s = 0.5;
    far.coulomb_friction_n = far.damping_n_s_per_mm = 0.0;
    HapticParameters parameters;
    const Result<void> fits = fit_to_device(parameters, far, false);
    ASSERT_FALSE(fits);
    EXPECT_EQ(fits.error().message,
              "walled: expected a device on which some clay is stable, found none at 20 Hz");
}

TEST(FitToDevice, AssumesALightDeviceIfItsMassIsUnknown) {
    haptics::DeviceCapabilities unknown{
        .name = "unknown", .force_axes = 3, .peak_force_n = 3.3, .continuous_force_n = 0.88};
    HapticParameters parameters;
    parameters.set_rate_hz(500.0);
    const Result<void> paper = fit_to_device(parameters, unknown, true);
    ASSERT_FALSE(paper);
    EXPECT_NE(paper.error().message.find("the largest that is stable on it"), std::string::npos);
    ASSERT_TRUE(fit_to_device(parameters, unknown, false)) << "the studio's clay is shown softer";
    EXPECT_GT(parameters.feel.most_stiffness_n_per_mm, 0.1);
    EXPECT_LT(parameters.feel.most_stiffness_n_per_mm, 0.6);
}

// The tick passes on the device's shows_wall.
TEST(Tick, ShowsTheRadiusSofterOnlyWhereTheDeviceHasNoWall) {
    const auto radial_n = [](bool shows_wall) {
        HapticState state;
        state.safety.ramp = 1.0;
        state.safety.calm_ticks = 100;
        HapticParameters parameters;
        parameters.feel.most_wire_stiffness_n_per_mm = 0.1;  // a fifth of the standing paper clay
        DeviceTick device;
        device.signs.shows_wall = shows_wall;
        TickResult result;
        for (int k = 0; k < 100; ++k)
            result = tick(state, {.position_mm = {69.0, 100.0, 0.0}, .radius_mm = 10.0}, parameters, device);
        return result.limited_force_n.x;
    };
    ASSERT_GT(radial_n(true), 0.1);
    EXPECT_NEAR(radial_n(false), 0.2 * radial_n(true), 1e-9);
}

}  // namespace
}  // namespace onggi::haptic
