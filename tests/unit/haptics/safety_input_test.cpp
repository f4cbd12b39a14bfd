// The chain and the motors' stages under any input: unsound input gives no force and leaves no trace in the
// state.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "engine/haptics/safety_chain.h"
#include "tests/support/engaged.h"

namespace onggi::haptics {
namespace {

constexpr double kHuge = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

bool is_finite(const dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_part(double value) {
    return value >= 0.0 && value <= 1.0;
}

// Names every member, so that a new one has to be judged here.
testing::AssertionResult is_sane(const SafetyState& state, const SafetyLimits& limits) {
    const auto& [applied_n, applied_driven_n, driven_n, ramp, calm_ticks, fault, fault_count, speed_stops,
                 late_fraction, late_count, gain, last_mm, has_last, energy_mj, damping, taken_mj, given_mj,
                 generated_mj, stale_s, stale_ticks, presence, heat_n2] = state;
    const double step_mm = 2.0 * limits.workspace_mm * std::sqrt(3.0);
    const double most_mj =
        limits.peak_force_n * step_mm * static_cast<double>(1U << 20U);  // of as many ticks as are tried
    const bool knows_where = !has_last || is_finite(last_mm);
    const struct {
        const char* what;
        bool is_well;
    } all[] = {
        {"applied_force_n", is_finite(applied_n) && length(applied_n) <= limits.peak_force_n * (1.0 + 1e-12)},
        {"applied_driven_n", is_finite(applied_driven_n) && length(applied_driven_n) <= 2e6},
        {"driven_force_n", is_finite(driven_n) && length(driven_n) <= 2e6},
        {"ramp", is_part(ramp)},
        {"calm_ticks", calm_ticks >= 0 && calm_ticks <= 1000},
        {"fault", fault <= Fault::kEnergyGenerated},
        {"fault_count", fault_count > 0 || fault == Fault::kNone},
        {"speed_stops", speed_stops <= (1U << 20U)},
        {"late_fraction", is_part(late_fraction)},
        {"late_count", late_count <= std::uint64_t{1} << 52U},
        {"gain", gain >= limits.least_gain && gain <= 1.0},
        {"last_position_mm", knows_where},
        {"energy_mj", energy_mj >= -limits.energy_debt_mj && energy_mj <= limits.energy_credit_mj},
        {"damping_n_s_per_mm", damping >= 0.0 && damping <= limits.damping_n_s_per_mm},
        {"taken_mj", taken_mj >= 0.0 && taken_mj <= most_mj},
        {"given_mj", given_mj >= 0.0 && given_mj <= most_mj},
        {"generated_mj", generated_mj >= 0.0 && generated_mj <= limits.most_generated_mj},
        {"stale_s", stale_s >= 0.0 && stale_s <= 1e6},
        {"stale_ticks", stale_ticks >= 0 && stale_ticks <= limits.stale_ticks},
        {"presence", is_part(presence)},
        {"heat_n2", heat_n2 >= 0.0 && heat_n2 <= limits.peak_force_n * limits.peak_force_n * (1.0 + 1e-9)},
    };
    for (const auto& one : all)
        if (!one.is_well) return testing::AssertionFailure() << one.what;
    return testing::AssertionSuccess();
}

// Any double there is: ordinary ones, the edges of the contract, and those that no arithmetic survives.
class AnyNumbers {
  public:
    explicit AnyNumbers(unsigned seed) : random_(seed) {}

    bool one_in(unsigned count) { return random_() % count == 0; }
    double next(double usual) {
        static constexpr double kEdges[] = {0.0,    -0.0,   kTiny,  -kTiny, 1e-300,    -1e-300,    1e-9,
                                            -1e-9,  0.1,    0.11,   1.0,    1.0000001, -1.0,       3.3,
                                            1000.0, 1001.0, -1001., 1e6,    1.1e6,     -1e150,     1e200,
                                            kHuge,  -kHuge, kNan,   -kNan,  kInfinity, -kInfinity, 0.5};
        if (one_in(3)) return kEdges[random_() % std::size(kEdges)];
        if (one_in(6)) return std::ldexp(signed_(random_), static_cast<int>(random_() % 2000) - 1000);
        return usual * signed_(random_);
    }
    dvec3 next_vector(double usual) { return {next(usual), next(usual), next(usual)}; }

    // Sound but for one field or all, in a part of the ticks.
    SafetyInput input() {
        SafetyInput input{.position_mm = {60.0 + signed_(random_), 100.0, 0.0},
                          .dt_s = 0.0005 * (1.0 + signed_(random_)),
                          .velocity_mm_s = {300.0 * signed_(random_), 0.0, 0.0},
                          .driven_force_n = {0.0, 0.0, signed_(random_)},
                          .applied_fraction = one_in(4) ? 0.5 : 1.0,
                          .late = one_in(50) ? static_cast<std::uint32_t>(random_()) : 0U,
                          .position_is_new = !one_in(20),
                          .hand_is_there = !one_in(400),
                          .stop = one_in(2000)};
        if (!one_in(30)) return input;
        const unsigned which = static_cast<unsigned>(random_() % 6);
        if (which == 0 || which == 5) input.position_mm = next_vector(2000.0);
        if (which == 1 || which == 5) input.dt_s = next(0.2);
        if (which == 2 || which == 5) input.velocity_mm_s = next_vector(2000.0);
        if (which == 3 || which == 5) input.driven_force_n = next_vector(2e6);
        if (which == 4 || which == 5) input.applied_fraction = next(2.0);
        return input;
    }

  private:
    std::mt19937 random_;
    std::uniform_real_distribution<double> signed_{-1.0, 1.0};
};

const SafetyLimits kMotors =
    limits_for({.name = "motors", .force_axes = 3, .peak_force_n = 3.3, .continuous_force_n = 0.88});

TEST(SafetyInputs, OfAnyKindLeaveTheForceBoundedAndTheStateSound) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        AnyNumbers any(seed);
        SafetyState state;
        dvec3 before(0.0);
        int pushes = 0;
        for (int tick = 0; tick < 60'000; ++tick) {
            const SafetyInput input = any.input();
            const dvec3 wanted = any.one_in(30)   ? any.next_vector(10.0)
                                 : any.one_in(12) ? dvec3(0.0)
                                                  : dvec3(2.0, 1.0, 0.0);
            // Rearming is rare, so that most faults last for several ticks.
            if (any.one_in(12)) rearm(state);
            if (any.one_in(5)) {
                state.ramp = 1.0;
                state.calm_ticks = 1000;
            }
            const dvec3 after = apply_safety_chain(wanted, input, kMotors, state);
            ASSERT_TRUE(is_sane(state, kMotors)) << "seed " << seed << ", tick " << tick;
            ASSERT_EQ(after, state.applied_force_n);
            if (state.fault != Fault::kNone) {
                ASSERT_EQ(after, dvec3(0.0)) << words_for(state.fault);
            } else {
                ASSERT_LE(length(after), length(before) + 200.0 * input.dt_s + 1e-9) << tick;
                ASSERT_GE(length(after), length(before) - 2200.0 * input.dt_s - 1e-9) << tick;
            }
            pushes += length(after) > 0.5 ? 1 : 0;
            before = after;
        }
        EXPECT_GT(pushes, 1000) << "the chain was at work";
    }
}

TEST(SafetyInputs, OfAnyKindLeaveAHandsMotorsBounded) {
    for (unsigned seed = 10; seed < 12; ++seed) {
        AnyNumbers any(seed);
        SafetyState state;
        int pushes = 0;
        for (int tick = 0; tick < 60'000; ++tick) {
            const dvec3 wanted = any.one_in(30) ? any.next_vector(10.0) : dvec3(2.0, 1.0, 0.0);
            if (any.one_in(5)) {
                state.ramp = 1.0;
                state.calm_ticks = 1000;
            }
            const dvec3 after = apply_stages(kMotorStages, wanted, any.input(), kMotors, state);
            ASSERT_TRUE(is_sane(state, kMotors)) << "seed " << seed << ", tick " << tick;
            ASSERT_EQ(after, state.applied_force_n);
            ASSERT_EQ(state.fault, Fault::kNone) << "a hand's motors have no rearm()";
            pushes += length(after) > 0.5 ? 1 : 0;
        }
        EXPECT_GT(pushes, 1000);
    }
}

// Inputs of which exactly one field is wrong.
std::vector<SafetyInput> unsound_inputs() {
    std::vector<SafetyInput> all;
    const auto with = [&](auto SafetyInput::*field, auto value) {
        SafetyInput input{.position_mm = {60.0, 100.0, 0.0}, .dt_s = kSafetyDt};
        input.*field = value;
        all.push_back(input);
    };
    for (const double wrong : {-kTiny, -1e-3, -kHuge, 0.11, kHuge, kNan, kInfinity, -kInfinity})
        with(&SafetyInput::dt_s, wrong);
    for (const double wrong : {-kTiny, -1.0, 1.001, kHuge, kNan, kInfinity, -kInfinity})
        with(&SafetyInput::applied_fraction, wrong);
    for (const double wrong : {-kHuge, 1.001e6, kHuge}) {
        for (int axis = 0; axis < 3; ++axis) {
            dvec3 driven(0.0);
            driven[axis] = wrong;
            with(&SafetyInput::driven_force_n, driven);
        }
    }
    return all;
}

TEST(SafetyInputs, ThatAreUnsoundLatchAFaultAndLeaveNoTrace) {
    const std::vector<SafetyInput> all = unsound_inputs();
    for (std::size_t k = 0; k < all.size(); ++k) {
        SafetyState state = engaged();
        state.applied_force_n = {2.0, 0.0, 0.0};
        state.heat_n2 = 0.1;
        state.generated_mj = 10.0;
        EXPECT_EQ(apply_safety_chain(kPush, all[k], {}, state), dvec3(0.0)) << k;
        EXPECT_EQ(state.fault, Fault::kInputNotSound) << k;
        EXPECT_EQ(state.ramp, 0.0) << k;
        EXPECT_EQ(state.applied_driven_n, dvec3(0.0)) << k;
        EXPECT_EQ(state.heat_n2, 0.1) << k;
        EXPECT_TRUE(is_sane(state, {})) << k;
        // An invalid position is reported before unsound input.
        state = engaged();
        SafetyInput nowhere = all[k];
        nowhere.position_mm.y = kNan;
        apply_safety_chain(kPush, nowhere, {}, state);
        EXPECT_EQ(state.fault, Fault::kPositionNotFinite) << k;
    }
}

TEST(SafetyInputs, ThatAreNotSoundRestartAHandsMotorsWithoutAFault) {
    for (const SafetyInput& input : unsound_inputs()) {
        SafetyState state = engaged();
        const SafetyInput sound{.dt_s = kSafetyDt};
        EXPECT_EQ(apply_stages(kMotorStages, kPush, sound, {}, state), kPush);
        EXPECT_EQ(apply_stages(kMotorStages, kPush, input, {}, state), dvec3(0.0));
        EXPECT_EQ(apply_stages(kMotorStages, kPush, sound, {}, state), dvec3(0.0)) << "it is not small";
        EXPECT_EQ(state.fault, Fault::kNone);
    }
    for (const double wrong : {kNan, kInfinity, -kInfinity}) {
        SafetyState state = engaged();
        for (int axis = 0; axis < 3; ++axis) {
            dvec3 force = kPush;
            force[axis] = wrong;
            EXPECT_EQ(apply_stages(kMotorStages, force, {.dt_s = kSafetyDt}, {}, state), dvec3(0.0));
        }
        EXPECT_EQ(state.ramp, 0.0);
        EXPECT_TRUE(is_sane(state, {}));
    }
}

// The gate as it stands in the chain, and alone.
TEST(SafetyInputs, ThatAreNotFiniteLatchAFaultWhicheverNumberItIs) {
    for (const double wrong : {kNan, kInfinity, -kInfinity}) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int field = 0; field < 4; ++field) {
                SafetyInput input{.position_mm = {60.0, 100.0, 0.0}, .dt_s = kSafetyDt};
                dvec3 force = kPush;
                if (field == 0) force[axis] = wrong;
                if (field == 1) input.velocity_mm_s[axis] = wrong;
                if (field == 2) input.driven_force_n[axis] = wrong;
                if (field == 3) input.position_mm[axis] = wrong;
                const Fault expected = field == 3 ? Fault::kPositionNotFinite : Fault::kForceNotFinite;
                SafetyState alone = engaged();
                EXPECT_EQ(gate(force, input, {}, alone), dvec3(0.0)) << field;
                EXPECT_EQ(alone.fault, expected) << field;
                SafetyState chain = engaged();
                EXPECT_EQ(apply_safety_chain(force, input, {}, chain), dvec3(0.0)) << field;
                EXPECT_EQ(chain.fault, expected) << field;
                EXPECT_TRUE(is_sane(chain, {})) << field;
            }
        }
    }
}

TEST(SafetyInputs, HaveAFaultInWords) {
    std::vector<std::string_view> all;
    for (int fault = 0; fault <= static_cast<int>(Fault::kEnergyGenerated); ++fault) {
        const std::string_view words = words_for(static_cast<Fault>(fault));
        EXPECT_NE(words, words_for(static_cast<Fault>(200))) << fault;
        for (const std::string_view other : all)
            EXPECT_NE(words, other);
        all.push_back(words);
    }
}

// The mean of the squared force over ten seconds, exactly, of ticks of any length.
class ExactMean {
  public:
    void add(const dvec3& force_n, double dt_s) {
        mean_n2_ += (glm::dot(force_n, force_n) - mean_n2_) * -std::expm1(-dt_s / 10.0);
        largest_n2_ = std::max(largest_n2_, mean_n2_);
    }
    [[nodiscard]] double mean_n2() const { return mean_n2_; }
    [[nodiscard]] double largest_n2() const { return largest_n2_; }

  private:
    double mean_n2_ = 0.0;
    double largest_n2_ = 0.0;
};

TEST(SafetyBudget, HoldsTheExactMeanHoweverLongEachTickIs) {
    // Devices whose motors bear a quarter, a tenth and a hundredth of their peak for ever.
    for (const double continuous_n : {0.88, 0.33, 0.033}) {
        for (const double longest_s : {0.0005, 0.02, 0.1}) {
            const SafetyLimits limits{.continuous_force_n = continuous_n};
            const double full_n2 = continuous_n * continuous_n;
            std::mt19937 random(7);
            std::uniform_real_distribution<double> part(0.0, 1.0);
            SafetyState chain = engaged();
            SafetyState motors = engaged();
            ExactMean of_chain;
            ExactMean of_motors;
            double wanted_n = 3.3;
            for (double time_s = 0.0; time_s < 30.0;) {
                if (random() % 500 == 0) wanted_n = random() % 3 == 0 ? 0.0 : 4.0 * part(random);
                // Most are short or as long as may be.
                const double dt_s = longest_s * (random() % 2 == 0 ? 1.0 : part(random) * part(random));
                const SafetyInput input{.position_mm = {60.0, 100.0, 0.0}, .dt_s = dt_s};
                of_chain.add(chain.applied_force_n, dt_s);
                of_motors.add(motors.applied_force_n, dt_s);
                const dvec3 wanted(wanted_n, 0.0, 0.0);
                apply_safety_chain(wanted, input, limits, chain);
                apply_stages(kMotorStages, wanted, input, limits, motors);
                ASSERT_LE(of_chain.mean_n2(), chain.heat_n2 * (1.0 + 1e-12));
                ASSERT_LE(of_motors.mean_n2(), motors.heat_n2 * (1.0 + 1e-12));
                time_s += dt_s;
            }
            EXPECT_LE(of_chain.largest_n2(), full_n2 * (1.0 + 1e-12)) << continuous_n << ' ' << longest_s;
            EXPECT_LE(of_motors.largest_n2(), full_n2 * (1.0 + 1e-12)) << continuous_n << ' ' << longest_s;
            EXPECT_GT(of_motors.largest_n2(), 0.8 * full_n2) << continuous_n << ' ' << longest_s;
        }
    }
}

}  // namespace
}  // namespace onggi::haptics
