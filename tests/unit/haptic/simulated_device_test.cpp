#include "game/haptic/simulated_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/haptics/safety_chain.h"

namespace onggi::haptic {
namespace {

constexpr double kRates[] = {100.0, 250.0, 500.0, 1000.0, 4000.0, 10000.0};

// A device that is open and has read once, at rest at x = 90 mm.
void start_at_rest(SimulatedDevice& device) {
    device.set_target({.position_mm = {90.0, 100.0, 0.0}});
    ASSERT_TRUE(device.open());
    EXPECT_EQ(device.read_tool(0, 0.001).position_mm, dvec3(90.0, 100.0, 0.0));
}

TEST(SimulatedDevice, SettlesAtItsTargetAtEveryRateWithoutOvershoot) {
    for (const double rate_hz : kRates) {
        SimulatedDevice device;
        start_at_rest(device);
        device.set_target({.position_mm = {60.0, 120.0, 5.0}});
        double nearest_x = 90.0;
        dvec3 at(0.0);
        for (int k = 0; k < static_cast<int>(rate_hz * 0.3); ++k) {
            at = device.read_tool(0, 1.0 / rate_hz).position_mm;
            nearest_x = std::min(nearest_x, at.x);
        }
        EXPECT_NEAR(at.x, 60.0, 1e-3) << rate_hz;
        EXPECT_NEAR(at.y, 120.0, 1e-3) << rate_hz;
        EXPECT_NEAR(at.z, 5.0, 1e-3) << rate_hz;
        EXPECT_GT(nearest_x, 60.0 - 0.05) << rate_hz;
    }
}

TEST(SimulatedDevice, ReachesItsTargetWithinATenthOfASecond) {
    SimulatedDevice device;
    start_at_rest(device);
    device.set_target({.position_mm = {60.0, 100.0, 0.0}});
    dvec3 at(0.0);
    for (int k = 0; k < 100; ++k)
        at = device.read_tool(0, 0.001).position_mm;
    EXPECT_NEAR(at.x, 60.0, 0.03);
}

TEST(SimulatedDevice, LagsBehindTheHandByTheForceOverTheCoupling) {
    for (const double rate_hz : kRates) {
        SimulatedDevice device;
        start_at_rest(device);
        device.write({3.3, 0.0, -1.0});
        dvec3 at(0.0);
        for (int k = 0; k < static_cast<int>(rate_hz * 0.5); ++k)
            at = device.read_tool(0, 1.0 / rate_hz).position_mm;
        EXPECT_NEAR(at.x - 90.0, 16.5, 1e-3) << rate_hz;
        EXPECT_NEAR(at.z, -5.0, 1e-3) << rate_hz;
    }
}

// A wall at x = 60 as the standing clay is one: 0.5 N/mm, and 0.002 N s/mm while in contact, from velocity as
// the clay sees it, by difference.
struct Wall {
    double before_x = 0.0;
    dvec3 force(double x, double dt_s) {
        const double v = (x - before_x) / dt_s;
        before_x = x;
        return x < 60.0 ? dvec3(0.5 * (60.0 - x) - 0.002 * v, 0.0, 0.0) : dvec3(0.0);
    }
};

TEST(SimulatedDevice, ComesToRestAgainstAStiffWallAtEveryRate) {
    for (const bool limited : {false, true}) {
        for (const double rate_hz : kRates) {
            const double dt_s = 1.0 / rate_hz;
            SimulatedDevice device;
            start_at_rest(device);
            Wall wall{.before_x = 90.0};
            haptics::SafetyState safety;
            const haptics::SafetyLimits limits = haptics::limits_for(device.capabilities());
            // The hand pushes 10 mm into the wall: 0.2 (x - 50) = 0.5 (60 - x), so x = 57.14 and 1.43 N.
            const auto run = [&](double seconds, auto&& watch) {
                for (int k = 0; k < static_cast<int>(seconds * rate_hz); ++k) {
                    const dvec3 at = device.read_tool(0, dt_s).position_mm;
                    dvec3 force = wall.force(at.x, dt_s);
                    if (limited) force = haptics::apply_safety_chain(force, {at, dt_s}, limits, safety);
                    device.write(force);
                    watch(at);
                }
            };
            run(1.2, [](const dvec3&) {});  // calm: the chain's ramp waits for that
            device.set_target({.position_mm = {50.0, 100.0, 0.0}});
            run(2.0, [&](const dvec3& at) {
                ASSERT_GT(at.x, 45.0) << rate_hz;
                ASSERT_LT(at.x, 90.1) << rate_hz;
            });
            double low = 1e9;
            double high = -1e9;
            run(0.5, [&](const dvec3& at) {
                low = std::min(low, at.x);
                high = std::max(high, at.x);
            });
            EXPECT_NEAR(low, 60.0 - 20.0 / 7.0, 0.01) << rate_hz << (limited ? " limited" : "");
            EXPECT_LT(high - low, 0.01) << rate_hz << (limited ? " limited" : "") << ": no limit cycle";
        }
    }
}

TEST(SimulatedDevice, IsUnstableWhereItsBoundSaysSo) {
    // The bound of simulated_device.h is real: a wall four times as stiff exceeds it at 100 Hz.
    const auto grows = [](double stiffness_n_per_mm, double rate_hz) {
        SimulatedDevice device;
        start_at_rest(device);
        double at = 90.01;
        for (int k = 0; k < 200; ++k) {
            device.write({stiffness_n_per_mm * (90.01 - at), 0.0, 0.0});
            at = device.read_tool(0, 1.0 / rate_hz).position_mm.x;
        }
        return std::abs(at - 90.0) > 1.0;
    };
    // K dt^2/m < 4 + 2 b dt/m + k dt^2/m = 9 at 100 Hz, so K < 1.8 N/mm.
    EXPECT_FALSE(grows(1.7, 100.0));
    EXPECT_TRUE(grows(1.9, 100.0));
    EXPECT_FALSE(grows(1.9, 1000.0));
}

TEST(SimulatedDevice, TakesButtonAndRadiusFromTheTargetAtOnce) {
    SimulatedDevice device;
    start_at_rest(device);
    device.set_target({.position_mm = {90.0, 100.0, 0.0}, .radius_mm = 25.0, .wheel_button = true});
    const tool::ToolState tool = device.read_tool(1, 0.001);
    EXPECT_EQ(tool.radius_mm, 25.0);
    EXPECT_TRUE(tool.wheel_button);
}

TEST(SimulatedDevice, IgnoresATargetThatIsNoNumberAndStaysWithinTheWorkspace) {
    constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    SimulatedDevice device;
    start_at_rest(device);
    device.set_target({.position_mm = {kNoNumber, 0.0, 0.0}, .radius_mm = kNoNumber});
    EXPECT_EQ(device.read_tool(1, 0.001).position_mm, dvec3(90.0, 100.0, 0.0));
    EXPECT_EQ(device.read_tool(1, 0.001).radius_mm, 10.0);
    device.set_target({.position_mm = {1e9, 0.0, -1e9}, .radius_mm = 1000.0});
    tool::ToolState tool;
    for (int k = 0; k < 1000; ++k)
        tool = device.read_tool(1, 0.001);
    EXPECT_NEAR(tool.position_mm.x, haptics::kWorkspaceMm, 1e-6);
    EXPECT_NEAR(tool.position_mm.z, -haptics::kWorkspaceMm, 1e-6);
    EXPECT_EQ(tool.radius_mm, tool::kMaxToolRadiusMm);
}

// A loop that is late by a frame sees only the next frame's target.
TEST(SimulatedDevice, CutsOnceThoughItsTargetWasReplacedBeforeARead) {
    constexpr tool::Wire kCut = tool::Wire::kCutRim;
    for (const bool guided : {false, true}) {
        SimulatedDevice device;
        start_at_rest(device);
        const auto asks = [&](tool::Wire wire, double height_mm) {
            device.set_target({.position_mm = {90.0, 100.0, 0.0},
                               .wire = wire,
                               .wire_height_mm = height_mm,
                               .guided = guided});
        };
        for (const double height_mm : {94.0, 81.0}) {
            asks(kCut, height_mm);
            asks(tool::Wire::kNone, 0.0);
            asks(tool::Wire::kNone, 0.0);
            const tool::ToolState tool = device.read_tool(0, 0.001);
            EXPECT_EQ(tool.wire, kCut);
            EXPECT_EQ(tool.wire_height_mm, height_mm);
            EXPECT_EQ(device.read_tool(1, 0.001).wire, tool::Wire::kNone);
            asks(tool::Wire::kNone, 0.0);
            EXPECT_EQ(device.read_tool(2, 0.001).wire, tool::Wire::kNone);
        }
    }
}

TEST(SimulatedDevice, ForgetsAnUnreadCutAtRest) {
    SimulatedDevice device;
    start_at_rest(device);
    device.set_target({.position_mm = {90.0, 100.0, 0.0}, .wire = tool::Wire::kCutRim});
    device.set_target({.position_mm = {90.0, 100.0, 0.0}});
    device.rest();
    EXPECT_EQ(device.read_tool(0, 0.001).wire, tool::Wire::kNone);
}

TEST(SimulatedDevice, HoldsTheWireOnForAsLongAsItsTargetDoes) {
    constexpr tool::Wire kCut = tool::Wire::kCutRim;
    SimulatedDevice device;
    start_at_rest(device);
    device.set_target({.position_mm = {90.0, 100.0, 0.0}, .wire = kCut, .wire_height_mm = 94.0});
    for (int tick = 0; tick < 16; ++tick)
        EXPECT_EQ(device.read_tool(0, 0.001).wire, kCut) << tick;
    device.set_target({.position_mm = {90.0, 100.0, 0.0}});
    EXPECT_EQ(device.read_tool(0, 0.001).wire, tool::Wire::kNone);
}

TEST(SimulatedDevice, StartsAtRestAgainWhenItIsOpenedAgain) {
    SimulatedDevice device;
    start_at_rest(device);
    device.write({3.3, 0.0, 0.0});
    for (int k = 0; k < 10; ++k)
        static_cast<void>(device.read_tool(0, 0.001));
    device.close();
    start_at_rest(device);
    EXPECT_EQ(device.read_tool(1, 0.001).position_mm, dvec3(90.0, 100.0, 0.0));
}

}  // namespace
}  // namespace onggi::haptic
