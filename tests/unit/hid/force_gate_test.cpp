// The last gate before a device's motors.
#include "engine/haptics/hid/force_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/haptics/hid/device_input.h"

namespace onggi::haptics::hid {
namespace {

double size_of(const ForceOrder& order) {
    return std::sqrt(order.force_n.x * order.force_n.x + order.force_n.y * order.force_n.y +
                     order.tangential_n * order.tangential_n);
}

// A gate whose ramp is done at the returned time.
std::int64_t ready(ForceGate& gate, std::uint64_t& ticks) {
    std::int64_t now_ns = 5'000 * kMs;
    for (int round = 0; round <= 300; ++round, now_ns += 4 * kMs)
        (void)gate.passed({.ticks = ++ticks}, now_ns);
    return now_ns;
}

TEST(ForceGate, HasNoForceBeforeTheFirstTick) {
    ForceGate gate;
    EXPECT_EQ(size_of(gate.passed({.force_n = {1.0, 0.0}, .ticks = 0}, 0)), 0.0);
    // Not even a small force, as soon as the clock has begun.
    for (const std::int64_t now_ns : {std::int64_t{0}, 10 * kMs, 19 * kMs})
        EXPECT_EQ(size_of(gate.passed({.force_n = {0.1, 0.0}, .ticks = 0}, now_ns)), 0.0) << now_ns;
}

TEST(ForceGate, RampsUpFromZeroInASecond) {
    ForceGate gate;
    std::uint64_t ticks = 0;
    (void)gate.passed({.ticks = ++ticks}, 0);
    double before = 0.0;
    for (std::int64_t now_ns = 4 * kMs; now_ns <= 1000 * kMs; now_ns += 4 * kMs) {
        const double force = gate.passed({.force_n = {2.0, 0.0}, .ticks = ++ticks}, now_ns).force_n.x;
        EXPECT_NEAR(force, 2.0 * static_cast<double>(now_ns) / 1e9, 1e-9);
        EXPECT_GT(force, before);
        before = force;
    }
    EXPECT_EQ(before, 2.0);
}

TEST(ForceGate, NeverPassesMoreThanThePeakNorBendsADirection) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-20.0, 20.0);
    ForceGate gate({.peak_n = 3.3});
    std::uint64_t ticks = 0;
    std::int64_t now_ns = ready(gate, ticks);
    for (int round = 0; round < 10'000; ++round, now_ns += kMs) {
        const ForceOrder order{
            .force_n = {any(random), any(random)}, .tangential_n = any(random), .ticks = ++ticks};
        const ForceOrder passed = gate.passed(order, now_ns);
        EXPECT_LE(size_of(passed), 3.3 + 1e-12);
        EXPECT_NEAR(passed.force_n.x * order.force_n.y, passed.force_n.y * order.force_n.x, 1e-9);
        EXPECT_GE(passed.force_n.x * order.force_n.x, 0.0);
    }
}

TEST(ForceGate, HasNoForceAfterTwentyMillisecondsWithoutANewTick) {
    ForceGate gate;
    std::uint64_t ticks = 0;
    const std::int64_t now_ns = ready(gate, ticks);
    const ForceOrder order{.force_n = {0.1, 0.0}, .ticks = ++ticks};
    EXPECT_GT(size_of(gate.passed(order, now_ns)), 0.0);
    EXPECT_GT(size_of(gate.passed(order, now_ns + 20 * kMs)), 0.0);
    EXPECT_EQ(size_of(gate.passed(order, now_ns + 21 * kMs)), 0.0);
    ForceOrder next = order;
    next.ticks = ++ticks;
    EXPECT_LT(size_of(gate.passed(next, now_ns + 22 * kMs)), 1e-3) << "it returns through the ramp";
}

TEST(ForceGate, SaysThatTheLoopIsDeadAfterATenthOfASecond) {
    ForceGate gate;
    EXPECT_FALSE(gate.passed({}, 10'000 * kMs).is_starved) << "it has not begun yet";
    EXPECT_FALSE(gate.passed({.ticks = 1}, 20'000 * kMs).is_starved);
    EXPECT_FALSE(gate.passed({.ticks = 1}, 20'100 * kMs).is_starved);
    EXPECT_TRUE(gate.passed({.ticks = 1}, 20'101 * kMs).is_starved);
    EXPECT_FALSE(gate.passed({.ticks = 2}, 20'102 * kMs).is_starved);
}

TEST(ForceGate, HasNoForceForAnOrderWithNan) {
    for (const double wrong :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()}) {
        for (int field = 0; field < 5; ++field) {
            ForceGate gate;
            std::uint64_t ticks = 0;
            const std::int64_t now_ns = ready(gate, ticks);
            ForceOrder order{.force_n = {0.1, 0.1}, .tangential_n = 0.1, .ticks = ++ticks};
            ASSERT_GT(size_of(gate.passed(order, now_ns)), 0.1);
            if (field < 2) order.force_n[field] = wrong;
            if (field == 2) order.tangential_n = wrong;
            if (field > 2) order.tool_mm[field - 3] = wrong;
            order.ticks = ++ticks;
            EXPECT_EQ(size_of(gate.passed(order, now_ns)), 0.0) << field;
            EXPECT_EQ(gate.fraction(), 0.0) << field;
            EXPECT_LT(size_of(gate.passed({.force_n = {0.1, 0.0}, .ticks = ++ticks}, now_ns + 4 * kMs)), 1e-3)
                << "it returns through the ramp";
        }
    }
}

TEST(ForceGate, BeginsItsRampAtAFifthOfANewtonOrLess) {
    const double too_much_n = std::nextafter(0.2, 1.0);
    ForceGate deep;
    for (std::uint64_t ticks = 1; ticks <= 500; ++ticks)
        (void)deep.passed({.force_n = {0.0, too_much_n}, .ticks = ticks},
                          static_cast<std::int64_t>(ticks) * 4 * kMs);
    EXPECT_EQ(deep.fraction(), 0.0);
    ForceGate out;
    for (std::uint64_t ticks = 1; ticks <= 500; ++ticks)
        (void)out.passed({.force_n = {0.0, 0.2}, .ticks = ticks}, static_cast<std::int64_t>(ticks) * 4 * kMs);
    EXPECT_EQ(out.fraction(), 1.0);
}

TEST(ForceGate, PassesTheKiosksPeakAndNoMoreInAnyDirection) {
    for (const double sign : {-1.0, 1.0}) {
        for (int axis = 0; axis < 3; ++axis) {
            ForceGate gate;
            std::uint64_t ticks = 0;
            const std::int64_t now_ns = ready(gate, ticks);
            ForceOrder order{.ticks = ++ticks};
            (axis < 2 ? order.force_n[axis] : order.tangential_n) = sign * 3.3;
            EXPECT_EQ(size_of(gate.passed(order, now_ns)), 3.3);
            EXPECT_EQ(gate.fraction(), 1.0);
            (axis < 2 ? order.force_n[axis] : order.tangential_n) = sign * 6.6;
            EXPECT_NEAR(size_of(gate.passed(order, now_ns)), 3.3, 1e-12);
            EXPECT_NEAR(gate.fraction(), 0.5, 1e-12);
        }
    }
}

TEST(ForceGate, RampsUpAgainAfterARestart) {
    ForceGate gate;
    std::uint64_t ticks = 0;
    const std::int64_t now_ns = ready(gate, ticks);
    ASSERT_EQ(gate.passed({.force_n = {1.0, 0.0}, .ticks = ++ticks}, now_ns).force_n.x, 1.0);
    gate.restart();
    EXPECT_EQ(gate.fraction(), 0.0);
    EXPECT_EQ(size_of(gate.passed({.force_n = {1.0, 0.0}, .ticks = ++ticks}, now_ns + 4 * kMs)), 0.0);
    EXPECT_EQ(size_of(gate.passed({.force_n = {0.1, 0.0}, .ticks = ++ticks}, now_ns + 8 * kMs)), 0.0);
    EXPECT_NEAR(gate.passed({.force_n = {1.0, 0.0}, .ticks = ++ticks}, now_ns + 18 * kMs).force_n.x, 0.01,
                1e-12);
}

TEST(LocalWall, GivesAtTheToolTheOrderedForce) {
    for (const double force_n : {-3.0, -0.1, 0.1, 3.0}) {
        const auto wall = local_wall({.force_n = {force_n, 0.0}, .tool_mm = {60.0, 20.0}}, 0.5);
        ASSERT_TRUE(wall);
        EXPECT_NEAR(wall->force_n(60.0), force_n, 1e-12);
        // Deeper pushes harder, and beyond the contact there is nothing: it never pulls.
        const double deeper = force_n > 0.0 ? -1.0 : 1.0;
        EXPECT_NEAR(std::abs(wall->force_n(60.0 + deeper)), std::abs(force_n) + 0.5, 1e-12);
        EXPECT_EQ(wall->force_n(60.0 - deeper * 100.0), 0.0);
    }
    EXPECT_FALSE(local_wall({.force_n = {0.0, 3.0}}, 0.5));
}

}  // namespace
}  // namespace onggi::haptics::hid
