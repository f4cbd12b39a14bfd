#include "game/haptic/tick.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/scripted_device.h"

namespace onggi::haptic {
namespace {

using tool::ToolState;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const ToolState kInTheWall{.position_mm = {69.0, 100.013, 0.0}, .radius_mm = 10.0};
const ToolState kAway{.position_mm = {90.0, 100.0, 0.0}, .radius_mm = 10.0};

ToolState with_button(ToolState tool, bool held) {
    tool.wheel_button = held;
    return tool;
}

struct HapticTick : testing::Test {
    HapticState state;
};

TEST_F(HapticTick, GivesTheForcesOfTheClay) {
    const HapticParameters parameters;
    clay::PaperClay clay;
    for (std::uint64_t k = 0; k < 4000; ++k) {
        const ToolState tool = test::scripted_tool(k);
        const TickResult result = tick(state, tool, parameters);
        const clay::ContactForces forces =
            clay.tick({tool.position_mm, tool.radius_mm, tool.wheel_button}, parameters.paper);
        ASSERT_EQ(result.forces.contacts, forces.contacts);
        ASSERT_EQ(result.forces.total_n(), forces.total_n());
    }
    EXPECT_EQ(state.paper()->state_hash(), clay.state_hash());
}

TEST_F(HapticTick, TurnsTheWheelExactlyWhileTheButtonIsHeld) {
    const HapticParameters parameters;
    for (int k = 0; k < 100; ++k)
        tick(state, kAway, parameters);
    EXPECT_EQ(state.wheel.heading().cosine, 1.0);
    EXPECT_EQ(state.wheel.heading().sine, 0.0);
    // 120 rev/min: a quarter turn takes 125 ms. Counter-clockwise from above.
    for (int k = 0; k < 125; ++k)
        tick(state, with_button(kAway, true), parameters);
    EXPECT_NEAR(state.wheel.heading().cosine, 0.0, 1e-9);
    EXPECT_NEAR(state.wheel.heading().sine, 1.0, 1e-9);
    const double sine = state.wheel.heading().sine;
    for (int k = 0; k < 100; ++k)
        tick(state, kAway, parameters);
    EXPECT_EQ(state.wheel.heading().sine, sine);
}

TEST_F(HapticTick, LimitsTheDevicesForceButNotTheRecordedOne) {
    const HapticParameters parameters;
    const ToolState deep{.position_mm = {30.0, 100.013, 0.0}, .radius_mm = 10.0};
    const TickResult first = tick(state, deep, parameters);
    EXPECT_GT(first.forces.total_n().x, 10.0);
    EXPECT_EQ(first.limited_force_n, dvec3(0.0));  // the ramp waits for a calm moment

    for (int k = 0; k < 1200; ++k)
        tick(state, kAway, parameters);
    // As fast as a hand may be: a jump would count as a throw and stop the force.
    ToolState on_the_way = kAway;
    TickResult later;
    for (int k = 0; k < 1800; ++k) {
        on_the_way.position_mm.x = std::max(30.0, on_the_way.position_mm.x - 0.1);
        later = tick(state, on_the_way, parameters);
    }
    EXPECT_GT(later.forces.total_n().x, 10.0);
    EXPECT_NEAR(glm::length(later.limited_force_n), 3.3, 1e-9);
}

TEST_F(HapticTick, IsTheSameForTheSameInput) {
    HapticState one;
    HapticState other;
    const HapticParameters parameters;
    for (std::uint64_t k = 0; k < 5000; ++k) {
        const TickResult a = tick(one, test::scripted_tool(k), parameters);
        const TickResult b = tick(other, test::scripted_tool(k), parameters);
        ASSERT_EQ(a.forces.total_n(), b.forces.total_n());
        ASSERT_EQ(a.limited_force_n, b.limited_force_n);
    }
    EXPECT_EQ(one.hash(), other.hash());
}

TEST(HapticState, HashesClayWheelAndCount) {
    const HapticParameters parameters;
    const HapticState fresh;
    HapticState waited;
    tick(waited, kAway, parameters);
    HapticState turned;
    tick(turned, with_button(kAway, true), parameters);
    HapticState pressed;
    tick(pressed, kInTheWall, parameters);
    tick(pressed, with_button(kInTheWall, true), parameters);
    EXPECT_NE(fresh.hash(), waited.hash());
    EXPECT_NE(waited.hash(), turned.hash());
    EXPECT_NE(turned.hash(), pressed.hash());
}

TEST_F(HapticTick, KeepsTheLastGoodToolWhenTheDeviceTalksNonsenseAndLatchesAFault) {
    const HapticParameters parameters;
    tick(state, kInTheWall, parameters);
    const ToolState nonsense{.position_mm = {kNan, 0.0, 0.0}, .radius_mm = kNan, .wheel_button = true};
    const TickResult result = tick(state, nonsense, parameters);
    EXPECT_EQ(state.tool, with_button(kInTheWall, true));
    EXPECT_GT(result.forces.contacts, 0);
    EXPECT_EQ(state.safety.fault, haptics::Fault::kPositionNotFinite);
    EXPECT_EQ(result.limited_force_n, dvec3(0.0));
}

TEST_F(HapticTick, HasNoContactIfTheFirstToolIsInvalid) {
    const std::uint64_t clay_before = HapticState().paper()->state_hash();
    const TickResult result =
        tick(state, {.position_mm = dvec3(kNan), .wheel_button = true}, HapticParameters{});
    EXPECT_EQ(result.forces.contacts, 0);
    EXPECT_EQ(result.forces.total_n(), dvec3(0.0));
    EXPECT_EQ(state.paper()->volume_mm3(), HapticState().paper()->volume_mm3());
    EXPECT_EQ(clay_before, HapticState().paper()->state_hash());
}

TEST_F(HapticTick, RecordsToolsThatReplayToTheSameState) {
    // Invalid live values are clamped in the record, which gives the same clay.
    HapticState live;
    HapticState replayed;
    const HapticParameters parameters;
    for (std::uint64_t k = 0; k < 3000; ++k) {
        ToolState wild = test::scripted_tool(k);
        if (k % 97 == 0) wild.position_mm.y = kNan;
        if (k % 101 == 0) wild.position_mm.x *= 1e6;
        if (k % 103 == 0) wild.radius_mm = -4.0;
        const TickResult a = tick(live, wild, parameters);
        const TickResult b = tick(replayed, live.tool, parameters);
        ASSERT_EQ(a.forces.total_n(), b.forces.total_n());
    }
    EXPECT_EQ(live.hash(), replayed.hash());
    EXPECT_NE(live.safety.fault, haptics::Fault::kNone);
}

TEST(HapticState, RestartsOnAFreshLumpWithTheDevicesSafetyAsItWas) {
    const HapticParameters parameters;
    const HapticState fresh;
    HapticState state;
    for (std::uint64_t k = 0; k < 2500; ++k)
        tick(state, test::scripted_tool(k), parameters);
    const haptics::SafetyState safety = state.safety;
    ASSERT_NE(state.hash(), fresh.hash());
    state.restart_from(fresh);
    EXPECT_EQ(state.hash(), fresh.hash());
    EXPECT_EQ(state.safety.ramp, safety.ramp);
    EXPECT_EQ(state.safety.applied_force_n, safety.applied_force_n);
    // And it is a lump like the first: the same gesture gives the same pot.
    HapticState first;
    for (std::uint64_t k = 0; k < 2500; ++k) {
        ASSERT_EQ(tick(state, test::scripted_tool(k), parameters).forces.total_n(),
                  tick(first, test::scripted_tool(k), parameters).forces.total_n());
    }
    EXPECT_EQ(state.hash(), first.hash());
}

}  // namespace
}  // namespace onggi::haptic
