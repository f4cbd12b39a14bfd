// Each number of SafetyLimits at its boundary. The numbers are those of SAFETY.md, written out: a test that
// read them from the limits would follow any of them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/haptics/safety_chain.h"
#include "tests/support/engaged.h"

namespace onggi::haptics {
namespace {

constexpr double kMillisecond = 0.001;

double above(double value) {
    return std::nextafter(value, std::numeric_limits<double>::infinity());
}

double below(double value) {
    return std::nextafter(value, -std::numeric_limits<double>::infinity());
}

SafetyInput still(double dt_s = kMillisecond) {
    return {.position_mm = {60.0, 100.0, 0.0}, .dt_s = dt_s};
}

SafetyInput moving(double mm_s) {
    SafetyInput input = still();
    input.velocity_mm_s = {0.0, mm_s, 0.0};
    return input;
}

// The fault of the chain's one tick with this input.
Fault fault_of(const SafetyInput& input) {
    SafetyState state = engaged();
    apply_safety_chain(kPush, input, {}, state);
    return state.fault;
}

TEST(SafetyNumbers, ATickLastsATenthOfASecondAtMost) {
    EXPECT_EQ(fault_of(still(0.0)), Fault::kNone);
    EXPECT_EQ(fault_of(still(0.1)), Fault::kNone);
    EXPECT_EQ(fault_of(still(above(0.1))), Fault::kInputNotSound);
    EXPECT_EQ(fault_of(still(below(0.0))), Fault::kInputNotSound);
}

TEST(SafetyNumbers, ADeviceAppliesAFractionOfZeroToOne) {
    SafetyInput input = still();
    for (const double sound : {0.0, 0.5, 1.0}) {
        input.applied_fraction = sound;
        EXPECT_EQ(fault_of(input), Fault::kNone) << sound;
    }
    for (const double unsound : {below(0.0), above(1.0)}) {
        input.applied_fraction = unsound;
        EXPECT_EQ(fault_of(input), Fault::kInputNotSound) << unsound;
    }
}

TEST(SafetyNumbers, TheDrivenPartIsAMillionNewtonsAtMostOnEachAxis) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            SafetyInput input = still();
            input.driven_force_n[axis] = sign * 1e6;
            EXPECT_EQ(fault_of(input), Fault::kNone) << axis;
            input.driven_force_n[axis] = sign * above(1e6);
            EXPECT_EQ(fault_of(input), Fault::kInputNotSound) << axis;
        }
    }
}

TEST(SafetyNumbers, TheWorkspaceIsAMetreToEachSideOnEachAxis) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            SafetyInput input = still();
            input.position_mm[axis] = sign * 1000.0;
            EXPECT_EQ(fault_of(input), Fault::kNone) << axis;
            input.position_mm[axis] = sign * above(1000.0);
            EXPECT_EQ(fault_of(input), Fault::kOutsideWorkspace) << axis;
        }
    }
}

TEST(SafetyNumbers, TheBrakeBeginsAboveSixHundredMillimetresASecond) {
    SafetyState state = engaged();
    EXPECT_EQ(speed(kPush, moving(600.0), {}, state), kPush);
    EXPECT_LT(speed(kPush, moving(600.001), {}, state).x, 1.0);
}

TEST(SafetyNumbers, TheBrakeIsTwoThousandthsOfANewtonForAMillimetreASecond) {
    SafetyState state = engaged();
    const dvec3 braked = speed(kPush, moving(900.0), {}, state);
    EXPECT_NEAR(braked.x, 0.5, 1e-12);
    EXPECT_NEAR(braked.y, -0.9, 1e-12);
}

TEST(SafetyNumbers, AToolIsLetGoAtTwelveHundredMillimetresASecond) {
    SafetyState state = engaged();
    EXPECT_GT(speed(kPush, moving(1199.999), {}, state).x, 0.0);
    EXPECT_EQ(state.speed_stops, 0U);
    EXPECT_EQ(speed(kPush, moving(1200.0), {}, state), dvec3(0.0));
    EXPECT_EQ(state.speed_stops, 1U);
}

// A tick of a tenth of a second, in which the gain goes where it is wanted.
double gain_with(double late_fraction) {
    SafetyState state = engaged();
    state.late_fraction = late_fraction;
    return late(kPush, still(0.1), {}, state).x;
}

TEST(SafetyNumbers, APeriodInAHundredMayBeMissed) {
    // A tenth of the second that is remembered goes by: of a fraction nine tenths are left.
    EXPECT_EQ(gain_with(0.0111), 1.0);
    EXPECT_NEAR(gain_with(0.0112), 0.01 / 0.01008, 1e-12);
    EXPECT_NEAR(gain_with(0.02), 0.01 / 0.018, 1e-12);
}

TEST(SafetyNumbers, AQuarterOfTheForceIsLeftOfALateLoop) {
    EXPECT_EQ(gain_with(0.9), 0.25);
    EXPECT_GT(gain_with(0.044), 0.25);
}

TEST(SafetyNumbers, ATickStandsForThePeriodsThatWereMissedBeforeIt) {
    SafetyState state = engaged();
    SafetyInput input = still(0.0005);
    input.late = 9;
    late(kPush, input, {}, state);
    // Nine of ten periods, of which each lasts as long as the step: five thousandths of the second.
    EXPECT_NEAR(state.late_fraction, 0.9 * 0.005, 1e-12);
    EXPECT_EQ(state.late_count, 9U);
}

TEST(SafetyNumbers, ALateLoopSoftensInATwentiethOfASecondAndHardensInAWholeOne) {
    SafetyState state = engaged();
    state.late_fraction = 0.9;
    EXPECT_NEAR(late(kPush, still(), {}, state).x, 0.98, 1e-12);
    state.late_fraction = 0.0;
    EXPECT_NEAR(late(kPush, still(), {}, state).x, 0.981, 1e-12);
}

// A step of the tool under a force of 1 N along it, one tick after the one that found it.
void give_mj(SafetyState& state, double work_mj, double dt_s = kMillisecond, double velocity_mm_s = 0.0,
             const dvec3& wanted_n = kPush) {
    const SafetyLimits limits;
    state.applied_force_n = dvec3(0.0);
    passivity(dvec3(0.0), {.dt_s = 0.0}, limits, state);
    state.applied_force_n = kPush;
    passivity(wanted_n,
              {.position_mm = {work_mj, 0.0, 0.0}, .dt_s = dt_s, .velocity_mm_s = {velocity_mm_s, 0.0, 0.0}},
              limits, state);
}

TEST(SafetyNumbers, TheDampingIsTwoThousandthsOfANewtonForAMillimetreASecondAtMost) {
    SafetyState state = engaged();
    give_mj(state, 5.0, kMillisecond, 100.0);
    EXPECT_EQ(state.damping_n_s_per_mm, 0.002);
}

TEST(SafetyNumbers, TheBalanceIsKeptBetweenALittleCreditAndABoundedDebt) {
    SafetyState state = engaged();
    give_mj(state, -500.0);
    EXPECT_EQ(state.energy_mj, 0.02);
    give_mj(state, 200.0);
    EXPECT_EQ(state.energy_mj, -10.0);
}

TEST(SafetyNumbers, TheBalanceIsForgottenInATwentiethOfASecondOutOfContact) {
    SafetyState state = engaged();
    give_mj(state, 5.0, 0.01, 0.0, dvec3(0.0));
    EXPECT_NEAR(state.energy_mj, -4.0, 1e-12);
}

TEST(SafetyEnergy, LatchesAFaultAboveAQuarterOfAJouleInASecond) {
    SafetyState state = engaged();
    give_mj(state, 250.0);
    EXPECT_EQ(state.fault, Fault::kNone);
    EXPECT_EQ(state.generated_mj, 250.0);
    state = engaged();
    give_mj(state, above(250.0));
    EXPECT_EQ(state.fault, Fault::kEnergyGenerated);
    EXPECT_EQ(state.generated_mj, 0.0) << "rearming restarts the balance";
    EXPECT_EQ(apply_safety_chain(kPush, still(), {}, state), dvec3(0.0));
    rearm(state);
    apply_safety_chain(dvec3(0.0), still(), {}, state);
    EXPECT_EQ(state.fault, Fault::kNone);
}

TEST(SafetyEnergy, ForgetsATenthInATenthOfASecond) {
    SafetyState state = engaged();
    give_mj(state, 100.0);
    give_mj(state, 0.0, 0.1);
    EXPECT_NEAR(state.generated_mj, 90.0, 1e-12);
}

TEST(SafetyEnergy, CreditsTakenEnergyButNeverSavesItUp) {
    SafetyState state = engaged();
    give_mj(state, 100.0);
    give_mj(state, -60.0);
    EXPECT_NEAR(state.generated_mj, 100.0 * 0.999 - 60.0, 1e-12);
    give_mj(state, -60.0);
    EXPECT_EQ(state.generated_mj, 0.0);
}

TEST(SafetyEnergy, IgnoresTheWorkThatTheWheelDrives) {
    SafetyState state = engaged();
    passivity(dvec3(0.0), {.dt_s = kMillisecond}, {}, state);
    state.applied_force_n = state.applied_driven_n = kPush;
    passivity(kPush, {.position_mm = {900.0, 0.0, 0.0}, .dt_s = kMillisecond}, {}, state);
    EXPECT_EQ(state.fault, Fault::kNone);
    EXPECT_EQ(state.generated_mj, 0.0);
    EXPECT_EQ(state.given_mj, 900.0);
}

TEST(SafetyEnergy, IsOfNoConcernWithoutMotors) {
    const DeviceCapabilities finger{
        .name = "finger", .force_axes = 3, .peak_force_n = 3.3, .has_motors = false};
    const DeviceCapabilities table{.name = "a gesture's table", .force_axes = 0};
    const DeviceCapabilities stylus{.name = "stylus", .force_axes = 3, .peak_force_n = 3.3};
    EXPECT_GT(limits_for(finger).most_generated_mj, 1e6);
    EXPECT_GT(limits_for(table).most_generated_mj, 1e6);
    EXPECT_EQ(limits_for(stylus).most_generated_mj, 250.0);
    // And of another hand, which takes over through the ramp.
    SafetyState state = engaged();
    state.generated_mj = 1e5;
    restart_ramp(state);
    EXPECT_EQ(state.generated_mj, 0.0);
}

TEST(SafetyNumbers, APositionIsStaleAtTheSecondTickAndAfterTwoPeriodsOfTheDevice) {
    SafetyInput old = still();
    old.position_is_new = false;
    SafetyState state = engaged();
    EXPECT_EQ(hand(kPush, old, {}, state), kPush);
    EXPECT_LT(hand(kPush, old, {}, state).x, 1.0);
    // A device that reports every 4 ms is stale at its ninth ms.
    const SafetyLimits slow = limits_for({.name = "usb", .force_axes = 2, .report_rate_hz = 250.0});
    SafetyState usb = engaged();
    for (int ms = 1; ms <= 8; ++ms)
        EXPECT_EQ(hand(kPush, old, slow, usb), kPush) << ms;
    EXPECT_LT(hand(kPush, old, slow, usb).x, 1.0);
}

TEST(SafetyNumbers, AForceGoesInFiveMillisecondsAndComesBackInAQuarterOfASecond) {
    SafetyInput gone = still();
    gone.hand_is_there = false;
    SafetyState state = engaged();
    EXPECT_NEAR(hand(kPush, gone, {}, state).x, 0.8, 1e-12);
    EXPECT_NEAR(hand(kPush, still(), {}, state).x, 0.804, 1e-12);
}

TEST(SafetyNumbers, TheRampBeginsAfterFourTicksBelowAFifthOfANewtonAndLastsASecond) {
    SafetyState state;
    const dvec3 small(below(0.2), 0.0, 0.0);
    for (int tick = 0; tick < 100; ++tick)
        EXPECT_EQ(ramp({0.2, 0.0, 0.0}, still(), {}, state), dvec3(0.0));
    for (int tick = 0; tick < 3; ++tick)
        ramp(small, still(), {}, state);
    EXPECT_EQ(ramp(kPush, still(), {}, state), dvec3(0.0)) << "three ticks are too few";
    for (int tick = 0; tick < 4; ++tick)
        EXPECT_EQ(ramp(small, still(), {}, state), dvec3(0.0));
    EXPECT_NEAR(ramp(kPush, still(), {}, state).x, 0.001, 1e-15);
}

TEST(SafetyNumbers, TheKioskGivesItsProfileAndADeviceWithoutMotorsThePeakForEver) {
    EXPECT_EQ(kKioskPeakForceN, 3.3);
    EXPECT_EQ(kKioskContinuousForceN, 0.88);
    EXPECT_EQ(SafetyLimits{}.peak_force_n, 3.3);
    EXPECT_EQ(SafetyLimits{}.continuous_force_n, 3.3);
    const SafetyLimits any =
        limits_for({.name = "a picture", .force_axes = 3, .peak_force_n = 9.0, .has_motors = false});
    EXPECT_EQ(any.brake_speed_mm_s, any.stop_speed_mm_s);
    EXPECT_EQ(any.peak_force_n, 3.3);
    EXPECT_EQ(limits_for({.name = "moves a hand", .force_axes = 0}).continuous_force_n, 3.3);
    EXPECT_EQ(limits_for({.name = "moves a hand", .force_axes = 0}).stop_speed_mm_s, 1200.0);
    EXPECT_EQ(limits_for({.name = "every read", .force_axes = 1}).device_period_s, 0.0);
}

// The bound that the budget sets at this fraction of the full mean.
double left_of_the_peak(double fraction) {
    SafetyState state = engaged();
    state.heat_n2 = fraction * 0.88 * 0.88;
    return budget({3.3, 0.0, 0.0}, still(0.0), {.continuous_force_n = 0.88}, state).x;
}

TEST(SafetyNumbers, ThePeakIsGivenUpToHalfOfTheFullMeanAndTheContinuousForceAtItsFull) {
    EXPECT_EQ(left_of_the_peak(0.0), 3.3);
    EXPECT_EQ(left_of_the_peak(0.4999), 3.3);
    EXPECT_LT(left_of_the_peak(0.5001), 3.3);
    EXPECT_NEAR(left_of_the_peak(0.75), 2.09, 1e-12);
    EXPECT_NEAR(left_of_the_peak(1.0), 0.88, 1e-12);
    EXPECT_NEAR(left_of_the_peak(14.0), 0.88, 1e-12) << "as after a hand without motors";
}

TEST(SafetyNumbers, AMotorWarmsAndCoolsInTenSeconds) {
    SafetyState state = engaged();
    state.applied_force_n = {2.0, 0.0, 0.0};
    budget(kPush, still(0.1), {}, state);
    EXPECT_NEAR(state.heat_n2, 0.04, 1e-15);
    state.applied_force_n = dvec3(0.0);
    budget(kPush, still(0.1), {}, state);
    EXPECT_NEAR(state.heat_n2, 0.04 * (1.0 - 0.01 + 0.00005), 1e-15);
}

TEST(SafetyNumbers, AForceGrowsByTwoHundredAndGoesByTwoThousandNewtonsASecond) {
    SafetyState state = engaged();
    EXPECT_NEAR(slew({3.3, 0.0, 0.0}, still(), {}, state).x, 0.2, 1e-15);
    state.applied_force_n = {3.3, 0.0, 0.0};
    EXPECT_NEAR(slew(dvec3(0.0), still(), {}, state).x, 1.3, 1e-12);
    EXPECT_EQ(slew(dvec3(0.0), still(), {}, state), dvec3(0.0));
}

TEST(SafetyNumbers, ThePeakIsTheClampsBound) {
    SafetyState state = engaged();
    EXPECT_EQ(clamp({0.0, 3.3, 0.0}, still(), {}, state).y, 3.3);
    EXPECT_EQ(clamp({0.0, above(3.3), 0.0}, still(), {}, state).y, 3.3);
}

}  // namespace
}  // namespace onggi::haptics
