// The stages that depend on time, work and the hand: speed, late, passivity, hand, budget; the rest is in
// safety_chain_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/haptics/safety_chain.h"
#include "tests/support/engaged.h"

namespace onggi::haptics {
namespace {

SafetyInput at_speed(double mm_s) {
    return {.position_mm = {60.0, 100.0, 0.0}, .dt_s = kSafetyDt, .velocity_mm_s = {-mm_s, 0.0, 0.0}};
}

TEST(SafetySpeed, LeavesAHandsOwnSpeedsAlone) {
    for (const double mm_s : {0.0, 100.0, 600.0}) {
        SafetyState state = engaged();
        EXPECT_EQ(speed(kPush, at_speed(mm_s), {}, state), kPush);
        EXPECT_EQ(state.ramp, 1.0);
    }
}

TEST(SafetySpeed, BrakesATooFastToolAndThenLetsItGo) {
    SafetyState state = engaged();
    const SafetyLimits limits;
    // Halfway: half of the force, half of the brake, against the motion.
    const dvec3 braked = speed({0.0, 1.0, 0.0}, at_speed(900.0), limits, state);
    EXPECT_NEAR(braked.y, 0.5, 1e-12);
    EXPECT_NEAR(braked.x, 900.0 * limits.brake_n_s_per_mm * 0.5, 1e-12);
    EXPECT_EQ(state.speed_stops, 0U);
    EXPECT_EQ(speed(kPush, at_speed(1200.0), limits, state), dvec3(0.0));
    EXPECT_EQ(state.speed_stops, 1U);
    EXPECT_EQ(state.ramp, 0.0);
    EXPECT_EQ(state.calm_ticks, 0);
}

TEST(SafetySpeed, LetsAToolFlyThroughTheAir) {
    SafetyState state = engaged();
    EXPECT_EQ(speed(dvec3(0.0), at_speed(5000.0), {}, state), dvec3(0.0));
    EXPECT_EQ(state.ramp, 1.0);
    EXPECT_EQ(state.speed_stops, 0U);
}

// Misses every n-th period for `seconds`. Returns the force left of 1 N at the end.
double after_missing(SafetyState& state, int every, double seconds) {
    const SafetyLimits limits;
    double left = 0.0;
    for (int k = 0; k < static_cast<int>(seconds * kSafetyRateHz); ++k) {
        const bool misses = every > 0 && k % every == 0;
        const SafetyInput input{.dt_s = misses ? 2.0 * kSafetyDt : kSafetyDt, .late = misses ? 1U : 0U};
        left = late(kPush, input, limits, state).x;
    }
    return left;
}

TEST(SafetyLate, ForgivesAFewMissedPeriods) {
    SafetyState state = engaged();
    EXPECT_EQ(after_missing(state, 200, 10.0), 1.0);
    EXPECT_EQ(state.late_count, 200U);
}

TEST(SafetyLate, SoftensTheClayWhileManyAreMissedAndHardensItAgainSlowly) {
    SafetyState state = engaged();
    EXPECT_NEAR(after_missing(state, 20, 5.0), 0.2 + 0.05, 0.06);  // 5 % missed: a fifth, but for the floor
    EXPECT_EQ(after_missing(state, 2, 3.0), SafetyLimits{}.least_gain);
    EXPECT_LT(after_missing(state, 0, 0.5), 1.0);
    EXPECT_EQ(after_missing(state, 0, 10.0), 1.0);
}

TEST(SafetyLate, SoftensWithoutAJump) {
    SafetyState state = engaged();
    const SafetyLimits limits;
    double before = 1.0;
    for (int k = 0; k < 4000; ++k) {
        const double now = late(kPush, {.dt_s = kSafetyDt, .late = 3}, limits, state).x;
        ASSERT_LE(std::abs(now - before), kSafetyDt / limits.soften_s + 1e-12);
        before = now;
    }
    EXPECT_EQ(before, limits.least_gain);
}

TEST(SafetyPassivity, AddsUpTheWorkOfTheForceReallyAppliedExactly) {
    // Forces and steps of any kind: the counters are their products, not what was asked for.
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const SafetyLimits limits;
    SafetyState state = engaged();
    dvec3 at(60.0, 100.0, 0.0);
    passivity(kPush, {.position_mm = at, .dt_s = kSafetyDt}, limits, state);
    double taken = 0.0;
    double given = 0.0;
    for (int k = 0; k < 1000; ++k) {
        state.applied_force_n = {any(random), any(random), any(random)};
        const dvec3 step{any(random), any(random), any(random)};
        at += step;
        const double work = -glm::dot(state.applied_force_n, step);
        (work > 0.0 ? taken : given) += std::abs(work);
        passivity({9.0, 9.0, 9.0}, {.position_mm = at, .dt_s = kSafetyDt}, limits, state);
        ASSERT_LE(state.energy_mj, limits.energy_credit_mj);
        ASSERT_GE(state.energy_mj, -limits.energy_debt_mj);
    }
    EXPECT_NEAR(state.taken_mj, taken, 1e-9);
    EXPECT_NEAR(state.given_mj, given, 1e-9);
}

TEST(SafetyPassivity, AddsDampingOnlyWhileMoreWasGivenThanTaken) {
    const SafetyLimits limits;
    SafetyState state = engaged();
    const auto moved = [&](double x_mm, double mm_s) {
        return passivity(
            kPush, {.position_mm = {x_mm, 0.0, 0.0}, .dt_s = kSafetyDt, .velocity_mm_s = {mm_s, 0.0, 0.0}},
            limits, state);
    };
    moved(60.0, 0.0);
    state.applied_force_n = kPush;
    EXPECT_EQ(moved(59.9, -400.0), kPush);  // into the clay: taken
    EXPECT_EQ(state.damping_n_s_per_mm, 0.0);
    const dvec3 damped = moved(60.3, 800.0);  // out again, and farther: given
    EXPECT_LT(damped.x, kPush.x);
    EXPECT_EQ(state.damping_n_s_per_mm, limits.damping_n_s_per_mm);
    EXPECT_NEAR(damped.x, 1.0 - 800.0 * limits.damping_n_s_per_mm, 1e-12);
    // A small debt is paid by as much damping as it takes, no more.
    state.energy_mj = 0.0;
    state.applied_force_n = {0.001, 0.0, 0.0};
    moved(60.4, 400.0);
    EXPECT_NEAR(state.damping_n_s_per_mm * 400.0 * 400.0 * kSafetyDt, 0.0001, 1e-12);
}

TEST(SafetyPassivity, LetsTheMotorOfTheWheelDragTheHand) {
    const SafetyLimits limits;
    SafetyState state = engaged();
    dvec3 at(60.0, 100.0, 0.0);
    const dvec3 drag(0.0, 0.0, -0.07);
    for (int k = 0; k < 4000; ++k) {
        at.z -= 0.01;
        state.applied_force_n = state.applied_driven_n = drag;
        const SafetyInput input{.position_mm = at, .dt_s = kSafetyDt, .velocity_mm_s = {0.0, 0.0, -40.0}};
        ASSERT_EQ(passivity(drag, input, limits, state), drag);
    }
    EXPECT_NEAR(state.given_mj, 0.07 * 40.0, 0.01);
}

// Drags a hand along for 100 ms with a limited force. Returns the energy balance, which starts at a debt of 5
// mJ.
double balance_after_a_drag(const SafetyLimits& limits, SafetyState& state, double gain, double fraction) {
    dvec3 at(60.0, 100.0, 0.0);
    const dvec3 drag(0.0, 0.0, -20.0);
    state.gain = gain;
    for (int k = 0; k < 400; ++k) {
        at.z -= 0.01;
        const SafetyInput input{
            .position_mm = at, .dt_s = kSafetyDt, .driven_force_n = drag, .applied_fraction = fraction};
        apply_safety_chain(drag, input, limits, state);
        if (k == 0) state.energy_mj = -5.0;
    }
    return state.energy_mj;
}

TEST(SafetyPassivity, CreditsTheWheelWithTheAppliedPartOfItsDrag) {
    // The same drag after each stage that reduces it: the wheel is credited with the remaining drag only.
    SafetyState clamped = engaged();
    EXPECT_NEAR(balance_after_a_drag({}, clamped, 1.0, 1.0), -5.0, 1e-9);
    EXPECT_GT(clamped.given_mj, 5.0);
    SafetyState spent = engaged();
    spent.heat_n2 = 0.88 * 0.88;
    EXPECT_NEAR(balance_after_a_drag({.continuous_force_n = 0.88}, spent, 1.0, 1.0), -5.0, 1e-9);
    SafetyState late = engaged();
    EXPECT_NEAR(balance_after_a_drag({.peak_force_n = 100.0}, late, 0.25, 1.0), -5.0, 1e-9);
    SafetyState ramped = engaged();
    ramped.ramp = 0.0;
    EXPECT_NEAR(balance_after_a_drag({}, ramped, 1.0, 1.0), -5.0, 1e-9);
    // Force that the device itself holds back is neither counted nor credited.
    SafetyState held_back = engaged();
    EXPECT_NEAR(balance_after_a_drag({}, held_back, 1.0, 0.25), -5.0, 1e-9);
    EXPECT_NEAR(held_back.given_mj, 0.25 * clamped.given_mj, 1e-9);
}

TEST(SafetyPassivity, TracksTheMotorsPartOfEveryForce) {
    // A third of every force is the motor's: then it is a third of what goes out, through every stage, while
    // the force jumps, turns, ramps and is late; brake and damping belong to the chain, not to the motor.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-4.0, 4.0);
    SafetyState state;
    const SafetyLimits limits{.continuous_force_n = 0.88};
    dvec3 wanted(0.0);
    double largest = 0.0;
    for (int k = 0; k < 40'000; ++k) {
        if (k > 100 && k % 50 == 0) wanted = {any(random), any(random), any(random)};
        const SafetyInput input{.position_mm = {60.0, 100.0, 0.0},
                                .dt_s = kSafetyDt,
                                .driven_force_n = wanted / 3.0,
                                .late = k % 30 == 0 ? 1U : 0U,
                                .hand_is_there = k % 5000 > 10};
        const dvec3 applied = apply_safety_chain(wanted, input, limits, state);
        const dvec3 wrong = state.applied_driven_n - applied / 3.0;
        ASSERT_LT(glm::dot(wrong, wrong), 1e-18) << k;
        largest = std::max(largest, glm::dot(applied, applied));
    }
    EXPECT_GT(largest, 1.0);
    // The brake of a tool that is too fast takes the place of the force, the motor's part with it.
    SafetyState braked = engaged();
    braked.driven_force_n = kPush;
    speed(kPush, at_speed(900.0), limits, braked);
    EXPECT_NEAR(braked.driven_force_n.x, 0.5, 1e-12);
    speed(kPush, at_speed(1200.0), limits, braked);
    EXPECT_EQ(braked.driven_force_n, dvec3(0.0));
}

TEST(SafetyPassivity, DoesNotDampInTheAirAndForgetsItsBalance) {
    const SafetyLimits limits;
    SafetyState state = engaged();
    state.energy_mj = -5.0;
    double x = 60.0;
    for (int k = 0; k < 4000; ++k) {
        x += 0.1;
        const SafetyInput input{
            .position_mm = {x, 0.0, 0.0}, .dt_s = kSafetyDt, .velocity_mm_s = {400.0, 0.0, 0.0}};
        ASSERT_EQ(passivity(dvec3(0.0), input, limits, state), dvec3(0.0));
    }
    EXPECT_NEAR(state.energy_mj, 0.0, 1e-6);
}

TEST(SafetyHand, LetsGoWithinFiveMillisecondsOfAMissingHand) {
    SafetyState state = engaged();
    const SafetyInput gone{.dt_s = kSafetyDt, .hand_is_there = false};
    double before = 1.0;
    for (int k = 0; k < 20; ++k) {
        const double now = hand(kPush, gone, {}, state).x;
        ASSERT_LT(now, before);
        before = now;
    }
    EXPECT_EQ(hand(kPush, gone, {}, state), dvec3(0.0));
    EXPECT_EQ(state.ramp, 0.0);  // and it comes back through the ramp
}

TEST(SafetyHand, LetsGoOfAPositionThatIsNotRefreshedForTwoTicks) {
    SafetyState state = engaged();
    const SafetyInput old{.dt_s = kSafetyDt, .position_is_new = false};
    EXPECT_EQ(hand(kPush, old, {}, state), kPush);
    EXPECT_LT(hand(kPush, old, {}, state).x, 1.0);
    for (int k = 0; k < 20; ++k)
        hand(kPush, old, {}, state);
    EXPECT_EQ(hand(kPush, old, {}, state), dvec3(0.0));
}

TEST(SafetyHand, WaitsForTwoPeriodsOfADeviceThatIsSlowerThanTheLoop) {
    const SafetyLimits limits = limits_for({.name = "usb",
                                            .force_axes = 2,
                                            .peak_force_n = 3.0,
                                            .continuous_force_n = 1.0,
                                            .report_rate_hz = 250.0});
    SafetyState state = engaged();
    for (int k = 1; k <= 400; ++k) {
        const SafetyInput input{.dt_s = kSafetyDt, .position_is_new = k % 16 == 0};  // every 4 ms
        ASSERT_EQ(hand(kPush, input, limits, state), kPush);
    }
    int ticks = 0;
    while (hand(kPush, {.dt_s = kSafetyDt, .position_is_new = false}, limits, state).x > 0.0 && ticks < 1000)
        ++ticks;
    EXPECT_LE(ticks * kSafetyDt, 0.008 + 0.005 + 2 * kSafetyDt);
}

TEST(SafetyHand, ComesBackGentlyWhereItNeverWasGone) {
    SafetyState state = engaged();
    for (int k = 0; k < 10; ++k)
        hand(kPush, {.dt_s = kSafetyDt, .hand_is_there = false}, {}, state);
    const double low = hand(kPush, {.dt_s = kSafetyDt}, {}, state).x;
    EXPECT_GT(low, 0.4);
    EXPECT_LT(low, 0.6);
    for (int k = 0; k < 1000; ++k)
        hand(kPush, {.dt_s = kSafetyDt}, {}, state);
    EXPECT_EQ(hand(kPush, {.dt_s = kSafetyDt}, {}, state), kPush);
    EXPECT_EQ(state.ramp, 1.0);
}

TEST(SafetyBudget, GivesThePeakForAMomentAndTheContinuousForceForEver) {
    const SafetyLimits limits{.continuous_force_n = 0.88};
    SafetyState state = engaged();
    const SafetyInput input{.dt_s = 0.001};
    double peak_s = 0.0;
    double force = 0.0;
    for (int k = 0; k < 60'000; ++k) {
        force = budget({3.3, 0.0, 0.0}, input, limits, state).x;
        state.applied_force_n = {force, 0.0, 0.0};
        if (force == 3.3) peak_s += 0.001;
        ASSERT_LE(state.heat_n2, 0.88 * 0.88 * (1.0 + 1e-9));
    }
    EXPECT_GT(peak_s, 0.3);
    EXPECT_LT(peak_s, 1.0);
    EXPECT_NEAR(force, 0.88, 0.02);
    // A rest gives the peak back.
    state.applied_force_n = dvec3(0.0);
    for (int k = 0; k < 20'000; ++k)
        budget(dvec3(0.0), input, limits, state);
    EXPECT_EQ(budget({3.3, 0.0, 0.0}, input, limits, state).x, 3.3);
}

TEST(SafetyBudget, NeverTouchesADeviceWithoutMotors) {
    SafetyState state = engaged();
    state.applied_force_n = {3.3, 0.0, 0.0};
    for (int k = 0; k < 60'000; ++k)
        ASSERT_EQ(budget({3.3, 0.0, 0.0}, {.dt_s = 0.001}, {}, state).x, 3.3);
}

}  // namespace
}  // namespace onggi::haptics
