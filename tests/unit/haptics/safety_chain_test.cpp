#include "engine/haptics/safety_chain.h"
#include "tests/support/engaged.h"
#include "tests/support/places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace onggi::haptics {
namespace {

const SafetyInput kInside{.position_mm = {60.0, 100.0, 0.0}, .dt_s = kSafetyDt};

class RandomForces {
  public:
    explicit RandomForces(unsigned seed) : random_(seed) {}
    // Any direction, any size from a thousandth to a million newtons.
    dvec3 next() {
        const dvec3 direction(normal_(random_), normal_(random_), normal_(random_));
        return direction / length(direction) * std::pow(10.0, exponent_(random_));
    }

  private:
    std::mt19937 random_;
    std::normal_distribution<double> normal_;
    std::uniform_real_distribution<double> exponent_{-3.0, 6.0};
};

// The rows of SAFETY.md's tables for these stages.
std::string rows_of(std::span<const SafetyStage> stages) {
    std::string rows;
    for (const SafetyStage& stage : stages)
        rows += "| `" + std::string(stage.name) + "` | " + std::string(stage.does) + " |\n";
    return rows;
}

TEST(SafetyChain, IsWrittenDownInItsOrder) {
    std::ifstream file(test::in_checkout("engine/haptics/SAFETY.md"));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find(rows_of(kSafetyChain)), std::string::npos) << rows_of(kSafetyChain);
    EXPECT_NE(text.find(rows_of(kMotorStages)), std::string::npos) << rows_of(kMotorStages);
}

TEST(SafetyChain, IsItsStagesOneAfterTheOther) {
    RandomForces forces(1);
    SafetyState whole = engaged();
    SafetyState staged = engaged();
    const SafetyLimits limits;
    for (int i = 0; i < 1000; ++i) {
        const dvec3 force = forces.next();
        dvec3 by_hand = gate(force, kInside, limits, staged);
        by_hand = speed(by_hand, kInside, limits, staged);
        by_hand = late(by_hand, kInside, limits, staged);
        by_hand = passivity(by_hand, kInside, limits, staged);
        by_hand = hand(by_hand, kInside, limits, staged);
        by_hand = ramp(by_hand, kInside, limits, staged);
        by_hand = budget(by_hand, kInside, limits, staged);
        by_hand = clamp(by_hand, kInside, limits, staged);
        by_hand = slew(by_hand, kInside, limits, staged);
        ASSERT_EQ(apply_safety_chain(force, kInside, limits, whole), by_hand);
    }
}

TEST(SafetyChain, NeverExceedsThePeakOrTheSlewRateForAnyInput) {
    for (const double rate_hz : {100.0, 1000.0, 4000.0, 10000.0}) {
        RandomForces forces(2);
        std::mt19937 random(3);
        SafetyState state;
        const SafetyLimits limits;
        dvec3 before(0.0);
        for (int i = 0; i < 50'000; ++i) {
            SafetyInput input{.position_mm = {60.0, 100.0, 0.0}, .dt_s = 1.0 / rate_hz};
            dvec3 force = random() % 3 == 0 ? dvec3(0.0) : forces.next();
            switch (random() % 1000) {
                case 0:
                    force.y = kNan;
                    break;
                case 1:
                    force.x = -kInfinity;
                    break;
                case 2:
                    input.position_mm.z = kNan;
                    break;
                case 3:
                    input.position_mm.x = 1e9;
                    break;
                case 4:
                    force = dvec3(std::numeric_limits<double>::max());
                    break;
                case 5:
                    rearm(state);
                    break;
                case 6:
                    input.velocity_mm_s.y = kNan;
                    break;
                case 7:
                    input.late = static_cast<std::uint32_t>(random() % 100);
                    break;
                case 8:
                    input.position_is_new = false;
                    break;
                case 9:
                    input.hand_is_there = false;
                    break;
                case 10:
                    input.velocity_mm_s = forces.next() * 1000.0;
                    break;
                case 11:
                    input.stop = true;
                    break;
                case 12:
                    input.dt_s *= 2.0;
                    break;
                default:
                    break;
            }
            const dvec3 after = apply_safety_chain(force, input, limits, state);
            ASSERT_TRUE(std::isfinite(after.x) && std::isfinite(after.y) && std::isfinite(after.z));
            ASSERT_LE(length(after), limits.peak_force_n * (1.0 + 1e-12));
            ASSERT_LE(length(after), length(before) + limits.slew_n_per_s * input.dt_s + 1e-12);
            if (state.fault != Fault::kNone) {
                ASSERT_EQ(after, dvec3(0.0));
            }
            before = after;
        }
    }
}

TEST(SafetyGate, LetsAForceThroughUntouchedWhenAllIsWell) {
    SafetyState state = engaged();
    EXPECT_EQ(gate({1.0, -2.0, 3.0}, kInside, {}, state), dvec3(1.0, -2.0, 3.0));
    EXPECT_EQ(state.fault, Fault::kNone);
}

TEST(SafetyGate, LatchesAFaultOnAnInputThatIsNotFiniteOrOutside) {
    struct Case {
        dvec3 force_n, position_mm;
        Fault fault;
    };
    const dvec3 good_force(1.0, 0.0, 0.0);
    const dvec3 good_position(60.0, 100.0, 0.0);
    const std::vector<Case> cases{
        {{kNan, 0.0, 0.0}, good_position, Fault::kForceNotFinite},
        {{0.0, kInfinity, 0.0}, good_position, Fault::kForceNotFinite},
        {{0.0, 0.0, -kInfinity}, good_position, Fault::kForceNotFinite},
        {good_force, {0.0, kNan, 0.0}, Fault::kPositionNotFinite},
        {good_force, {-kInfinity, 0.0, 0.0}, Fault::kPositionNotFinite},
        {good_force, {0.0, 1000.001, 0.0}, Fault::kOutsideWorkspace},
        {good_force, {0.0, 0.0, -1e300}, Fault::kOutsideWorkspace},
    };
    for (const Case& one : cases) {
        SafetyState state = engaged();
        EXPECT_EQ(apply_safety_chain(one.force_n, {one.position_mm, kSafetyDt}, {}, state), dvec3(0.0));
        EXPECT_EQ(state.fault, one.fault) << words_for(one.fault);
        EXPECT_EQ(state.fault_count, 1U);
        EXPECT_NE(words_for(one.fault), words_for(Fault::kNone));
        // Latched: the input is valid again, and still no force.
        for (int i = 0; i < 10'000; ++i) {
            ASSERT_EQ(apply_safety_chain(good_force, kInside, {}, state), dvec3(0.0));
        }
        EXPECT_EQ(state.fault_count, 1U);
    }
}

TEST(SafetyGate, LatchesAFaultOnAMotorsPartThatIsNotFinite) {
    SafetyState state = engaged();
    SafetyInput input = kInside;
    input.driven_force_n = {0.0, kNan, 0.0};
    EXPECT_EQ(apply_safety_chain({1.0, 0.0, 0.0}, input, {}, state), dvec3(0.0));
    EXPECT_EQ(state.fault, Fault::kForceNotFinite);
    EXPECT_EQ(state.energy_mj, 0.0) << "it must not reach the observer";
}

TEST(SafetyGate, DropsAStandingForceAtOnceOnAFault) {
    SafetyState state = engaged();
    state.applied_force_n = {3.0, 0.0, 0.0};
    EXPECT_EQ(apply_safety_chain({kNan, 0.0, 0.0}, kInside, {}, state), dvec3(0.0));
}

TEST(SafetyGate, ComesBackThroughTheRampAfterRearm) {
    SafetyState state = engaged();
    apply_safety_chain({kNan, 0.0, 0.0}, kInside, {}, state);
    rearm(state);
    const dvec3 force(2.0, 0.0, 0.0);
    // Still deep in the wall: no force until the tool has been out.
    for (int i = 0; i < 4000; ++i)
        ASSERT_EQ(apply_safety_chain(force, kInside, {}, state), dvec3(0.0));
    for (int i = 0; i < 4; ++i)
        apply_safety_chain(dvec3(0.0), kInside, {}, state);
    double before = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const double now = apply_safety_chain(force, kInside, {}, state).x;
        ASSERT_GE(now, before);
        before = now;
    }
    EXPECT_NEAR(before, 2.0, 1e-9);
    EXPECT_EQ(state.fault, Fault::kNone);
}

TEST(SafetyGate, StopsOnRequestUntilItIsRearmedWithoutOne) {
    SafetyState state = engaged();
    state.applied_force_n = kPush;
    SafetyInput stop = kInside;
    stop.stop = true;
    EXPECT_EQ(apply_safety_chain(kPush, stop, {}, state), dvec3(0.0));
    EXPECT_EQ(state.fault, Fault::kStopped);
    EXPECT_EQ(apply_safety_chain(kPush, kInside, {}, state), dvec3(0.0));
    EXPECT_EQ(state.fault, Fault::kStopped);
    rearm(state);
    EXPECT_EQ(state.fault, Fault::kNone);
}

TEST(SafetyGate, LatchesAgainWhenTheCausePersists) {
    SafetyState state = engaged();
    for (int i = 0; i < 3; ++i) {
        apply_safety_chain({kNan, 0.0, 0.0}, kInside, {}, state);
        rearm(state);
    }
    EXPECT_EQ(state.fault_count, 3U);
}

TEST(SafetyRamp, WaitsForASmallForceForMoreThanThreeTicks) {
    SafetyState state;
    const dvec3 small(0.19, 0.0, 0.0);
    const dvec3 large(0.21, 0.0, 0.0);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(ramp(small, kInside, {}, state), dvec3(0.0));
    EXPECT_EQ(ramp(large, kInside, {}, state), dvec3(0.0));  // the wait restarts
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(ramp(small, kInside, {}, state), dvec3(0.0));
    EXPECT_GT(ramp(large, kInside, {}, state).x, 0.0);
}

TEST(SafetyRamp, ReachesTheFullForceAfterOneSecondAtEveryRate) {
    for (const double rate_hz : {100.0, 1000.0, 10000.0}) {
        SafetyState state;
        const SafetyInput input{.position_mm = {}, .dt_s = 1.0 / rate_hz};
        for (int i = 0; i < 4; ++i)
            ramp(dvec3(0.0), input, {}, state);
        const int half = static_cast<int>(rate_hz / 2);
        dvec3 force(0.0);
        for (int i = 0; i < half; ++i)
            force = ramp({1.0, 0.0, 0.0}, input, {}, state);
        EXPECT_NEAR(force.x, 0.5, 1e-9) << rate_hz;
        for (int i = 0; i <= half; ++i)
            force = ramp({1.0, 0.0, 0.0}, input, {}, state);
        EXPECT_EQ(force.x, 1.0) << rate_hz;
    }
}

TEST(SafetyClamp, KeepsTheDirectionOfEveryForce) {
    RandomForces forces(5);
    SafetyState state = engaged();
    for (int i = 0; i < 10'000; ++i) {
        const dvec3 force = forces.next();
        const dvec3 out = clamp(force, kInside, {}, state);
        EXPECT_LE(length(out), kKioskPeakForceN * (1.0 + 1e-12));
        EXPECT_NEAR(length(glm::cross(force / length(force), out / length(out))), 0.0, 1e-12);
        EXPECT_GT(glm::dot(force, out), 0.0);
        if (length(force) <= kKioskPeakForceN) {
            EXPECT_EQ(out, force);
        }
    }
}

TEST(SafetyClamp, HoldsForForcesWhoseSquareIsInfinite) {
    SafetyState state = engaged();
    const double huge = std::numeric_limits<double>::max();
    const dvec3 out = clamp({huge, -huge, 0.0}, kInside, {}, state);
    EXPECT_NEAR(length(out), kKioskPeakForceN, 1e-12);
    EXPECT_NEAR(out.x, -out.y, 1e-12);
}

TEST(SafetySlew, RisesAtTwoHundredNewtonsASecond) {
    SafetyState state = engaged();
    int ticks = 0;
    while (slew({3.3, 0.0, 0.0}, kInside, {}, state) != dvec3(3.3, 0.0, 0.0) && ticks < 10'000)
        ++ticks;
    EXPECT_NEAR((ticks + 1) * kSafetyDt, 3.3 / 200.0, 2 * kSafetyDt);
}

TEST(SafetySlew, LetsGoTenTimesFasterThanItPushes) {
    SafetyState state = engaged();
    state.applied_force_n = {0.0, 3.3, 0.0};
    int ticks = 1;
    while (slew(dvec3(0.0), kInside, {}, state) != dvec3(0.0) && ticks < 10'000)
        ++ticks;
    EXPECT_LE(ticks * kSafetyDt, 0.002);
}

TEST(SafetySlew, GoesThroughZeroWhenTheForceTurnsAround) {
    SafetyState state = engaged();
    state.applied_force_n = {1.0, 0.0, 0.0};
    double before = 1.0;
    for (int i = 0; i < 1000; ++i) {
        const double now = slew({-1.0, 0.0, 0.0}, kInside, {}, state).x;
        ASSERT_LE(now, before);
        // Below zero it grows, and growing is slow, in the tick in which it changes sign too.
        if (now < 0.0) {
            ASSERT_GE(now, std::min(before, 0.0) - 200.0 * kSafetyDt - 1e-12);
        }
        before = now;
    }
    EXPECT_EQ(before, -1.0);
}

TEST(SafetySlew, ReachesAnySteadyForceExactlyAndStaysThere) {
    RandomForces forces(9);
    SafetyState state = engaged();
    for (int i = 0; i < 200; ++i) {
        const dvec3 wanted = clamp(forces.next(), kInside, {}, state);
        for (int tick = 0; tick < 200; ++tick)
            slew(wanted, kInside, {}, state);
        EXPECT_NEAR(length(state.applied_force_n - wanted), 0.0, 1e-12);
    }
}

TEST(SafetyLimits, GiveAMotorTheContinuousForceItCanBear) {
    const DeviceCapabilities strong{
        .name = "strong", .force_axes = 3, .peak_force_n = 12.0, .continuous_force_n = 5.0};
    EXPECT_EQ(limits_for(strong).continuous_force_n, kKioskContinuousForceN);
    const DeviceCapabilities weak{
        .name = "weak", .force_axes = 3, .peak_force_n = 1.0, .continuous_force_n = 0.3};
    EXPECT_EQ(limits_for(weak).continuous_force_n, 0.3);
    const DeviceCapabilities picture{.name = "picture",
                                     .force_axes = 3,
                                     .peak_force_n = 3.3,
                                     .continuous_force_n = 3.3,
                                     .has_motors = false};
    EXPECT_EQ(limits_for(picture).continuous_force_n, 3.3);
    EXPECT_GT(limits_for(picture).brake_speed_mm_s, 1e6);
    EXPECT_EQ(limits_for(strong).brake_speed_mm_s, 600.0);
}

TEST(SafetyLimits, AreLoweredByAWeakDeviceAndNeverRaisedByAStrongOne) {
    EXPECT_EQ(limits_for({.name = "weak", .force_axes = 3, .peak_force_n = 1.0}).peak_force_n, 1.0);
    EXPECT_EQ(limits_for({.name = "strong", .force_axes = 3, .peak_force_n = 12.0}).peak_force_n,
              kKioskPeakForceN);
    EXPECT_EQ(limits_for({.name = "feels nothing"}).peak_force_n, kKioskPeakForceN);
}

}  // namespace
}  // namespace onggi::haptics
