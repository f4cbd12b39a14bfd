// Several models of human hands on a simulated device, in a closed loop through the whole haptic tick: clay,
// velocity estimator, safety chain, at 1 kHz and at 4 kHz. Minutes of simulated time each; the force always
// stays within its limits, and the loop returns no more energy than it took plus the work of the wheel's
// motor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "game/haptic/device_force.h"
#include "game/haptic/tick.h"
#include "tests/haptics/device_models.h"

namespace onggi::haptic {
namespace {

#ifdef NDEBUG
constexpr double kSeconds = 120.0;
#else
constexpr double kSeconds = 5.0;  // unoptimised code is ten times slower
#endif
constexpr double kMmPerM = 1000.0;

// A hand: a mass, with one spring to the arm's target and another to the tool. grip 0: no hand.
struct HandModel {
    const char* name;
    double mass_kg = 0.0;
    double grip_n_per_mm = 0.0;
    double grip_n_s_per_mm = 0.0;
    double arm_n_per_mm = 0.0;
    double arm_n_s_per_mm = 0.0;
    double taps_hz = 0.0;  // in and out of the clay
};

constexpr HandModel kHands[] = {
    {.name = "free"},
    {"light hold", 0.05, 0.1, 0.002, 0.05, 0.003, 0.0},
    {"firm hold", 0.3, 1.0, 0.01, 0.5, 0.02, 0.0},
    {"tapping", 0.1, 0.5, 0.005, 0.3, 0.01, 3.0},
};

// The tool of a device from device_models.h, in three axes, with the hand on it.
class HeldDevice {
  public:
    HeldDevice(const haptics::DeviceCapabilities& device, const HandModel& hand)
        : device_(device),
          hand_(hand) {
        at_ = hand_at_ = {80.0, 100.0, 0.0};
    }

    [[nodiscard]] dvec3 reading_mm() const {
        const double step = device_.position_resolution_mm;
        return {std::round(at_.x / step) * step, std::round(at_.y / step) * step,
                std::round(at_.z / step) * step};
    }

    // Holds the force for dt_s while hand and tool move. Returns its work, mJ.
    double advance(const dvec3& force_n, const dvec3& aim_mm, double dt_s) {
        constexpr int kSteps = 20;
        const double h = dt_s / kSteps;
        const dvec3 before = at_;
        for (int step = 0; step < kSteps; ++step) {
            dvec3 push = force_n - v_ * device_.damping_n_s_per_mm;
            if (hand_.mass_kg > 0.0) {
                const dvec3 grip =
                    (hand_at_ - at_) * hand_.grip_n_per_mm + (hand_v_ - v_) * hand_.grip_n_s_per_mm;
                const dvec3 arm = (aim_mm - hand_at_) * hand_.arm_n_per_mm - hand_v_ * hand_.arm_n_s_per_mm;
                push += grip;
                hand_v_ += (arm - grip) * (kMmPerM / hand_.mass_kg * h);
                hand_at_ += hand_v_ * h;
            }
            v_ += push * (kMmPerM / device_.moving_mass_kg * h);
            const double speed = std::sqrt(glm::dot(v_, v_));
            const double loss = device_.coulomb_friction_n / device_.moving_mass_kg * kMmPerM * h;
            v_ = speed > loss ? v_ * (1.0 - loss / speed) : dvec3(0.0);
            at_ += v_ * h;
        }
        return glm::dot(force_n, at_ - before);
    }
    [[nodiscard]] const dvec3& place_mm() const { return at_; }
    void put_at(const dvec3& at_mm) {
        at_ = hand_at_ = at_mm;
        v_ = hand_v_ = dvec3(0.0);
    }

  private:
    const haptics::DeviceCapabilities device_;
    const HandModel hand_;
    dvec3 at_{0.0};
    dvec3 v_{0.0};
    dvec3 hand_at_{0.0};
    dvec3 hand_v_{0.0};
};

// The arm's target: changes from time to time to new positions near the wall, up and down, deeper and less
// deep.
class Wish {
  public:
    explicit Wish(unsigned seed) : random_(seed) {}
    dvec3 next(const HandModel& hand, double t_s, double dt_s, double wall_mm) {
        if (t_s >= until_s_) {
            until_s_ = t_s + 0.3 + 1.5 * fraction_(random_);
            goal_ = {wall_mm + 14.0 - 12.0 * fraction_(random_), 30.0 + 60.0 * fraction_(random_),
                     6.0 * fraction_(random_) - 3.0};
        }
        aim_ += (goal_ - aim_) * std::min(1.0, dt_s / 0.15);
        dvec3 aim = aim_;
        if (hand.taps_hz > 0.0) {
            const double beat = t_s * hand.taps_hz;
            aim.x += beat - std::floor(beat) < 0.5 ? 12.0 : -3.0;
        }
        return aim;
    }
    bool wheel(double dt_s) {
        constexpr double kTurnsAboutHz = 0.5;
        if (fraction_(random_) < kTurnsAboutHz * dt_s) turning_ = !turning_;
        return turning_;
    }

  private:
    std::mt19937 random_;
    std::uniform_real_distribution<double> fraction_{0.0, 1.0};
    double until_s_ = 0.0;
    dvec3 goal_{90.0, 60.0, 0.0};
    dvec3 aim_{90.0, 60.0, 0.0};
    bool turning_ = false;
};

struct Outcome {
    double largest_n = 0.0;
    double largest_heat_n2 = 0.0;
    double most_given_mj = 0.0;      // at its worst; minus the energy taken and the wheel's work
    double most_generated_mj = 0.0;  // of that in a second, as the chain's observer knows it
    double largest_change_n = 0.0;
    double touched_s = 0.0;
    double farthest_mm = 0.0;
    double late_swing_mm = 0.0;  // of a free tool in the last two seconds
    haptics::Fault fault = haptics::Fault::kNone;
};

// The wheel's drag in the applied force: the fraction of the clay's wanted force in its direction.
dvec3 drag_in(const dvec3& applied_n, const clay::ContactForces& forces, bool is_studio,
              const DeviceFeel& feel) {
    const DeviceForce clay = device_force(forces, dvec3(0.0), 0.0, is_studio, feel);
    const double square = glm::dot(clay.wanted_n, clay.wanted_n);
    if (square == 0.0) return dvec3(0.0);
    return clay.driven_n * std::clamp(glm::dot(applied_n, clay.wanted_n) / square, 0.0, 1.0);
}

Outcome work(HapticState state, double rate_hz, const HandModel& hand, unsigned seed, double seconds) {
    const haptics::DeviceCapabilities device = test::omni_like();
    HapticParameters parameters;
    parameters.set_rate_hz(rate_hz);
    const double dt_s = parameters.dt_s();
    const bool is_paper = state.paper() != nullptr;
    EXPECT_TRUE(fit_to_device(parameters, device, is_paper));
    state.velocity = haptics::VelocityEstimator(device.position_resolution_mm);
    const double wall_mm = is_paper ? 60.0 : 50.0;

    HeldDevice held(device, hand);
    Wish wish(seed);
    Outcome outcome;
    dvec3 applied_n(0.0);
    dvec3 applied_drag_n(0.0);
    double net_mj = 0.0;
    dvec3 low(1e9);
    dvec3 high(-1e9);
    const auto ticks = static_cast<int>(seconds * rate_hz);
    // A free tool is moved into the clay until it is pushed back, and then released: from then on only the
    // loop acts on it.
    constexpr double kPushesN = 0.6;
    constexpr double kLedMmS = 20.0;
    bool is_led = hand.mass_kg == 0.0;
    double led_x_mm = wall_mm + 30.0;
    for (int k = 0; k < ticks; ++k) {
        is_led = is_led && glm::dot(applied_n, applied_n) < kPushesN * kPushesN;
        if (is_led && k > rate_hz * 1.5) held.put_at({led_x_mm -= kLedMmS * dt_s, 20.0, 0.0});
        const dvec3 aim = wish.next(hand, k / rate_hz, dt_s, wall_mm);
        tool::ToolState tool{.position_mm = held.reading_mm(), .wheel_button = wish.wheel(dt_s)};
        if (hand.mass_kg == 0.0) tool.wheel_button = false;
        const dvec3 place_before = held.place_mm();
        const TickResult result = tick(state, tool, parameters);
        // One tick of delay: the force applied now was computed at the last tick.
        const double given_mj = held.advance(applied_n, aim, dt_s);
        // The wheel's motor is credited with the applied part of its drag, no more.
        const dvec3 way = held.place_mm() - place_before;
        net_mj = std::max(0.0, net_mj + given_mj - std::max(0.0, glm::dot(applied_drag_n, way)));
        outcome.most_given_mj = std::max(outcome.most_given_mj, net_mj);

        const dvec3 next_n = result.limited_force_n;
        const double change = std::sqrt(glm::dot(next_n - applied_n, next_n - applied_n));
        const double size = std::sqrt(glm::dot(next_n, next_n));
        outcome.largest_change_n = std::max(outcome.largest_change_n, change);
        outcome.largest_n = std::max(outcome.largest_n, size);
        outcome.largest_heat_n2 = std::max(outcome.largest_heat_n2, state.safety.heat_n2);
        outcome.most_generated_mj = std::max(outcome.most_generated_mj, state.safety.generated_mj);
        if (size > 0.0) outcome.touched_s += dt_s;
        applied_n = next_n;
        applied_drag_n = drag_in(next_n, result.forces, !is_paper, parameters.feel);
        const dvec3 place = held.place_mm();
        outcome.farthest_mm = std::max({outcome.farthest_mm, std::abs(place.x), std::abs(place.z)});
        if (k > ticks - 2.0 * rate_hz) {
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
    }
    outcome.late_swing_mm = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    outcome.fault = state.safety.fault;
    return outcome;
}

struct Case {
    const char* name;
    bool is_studio;
    double rate_hz;
    std::vector<unsigned> seeds;
};

class HandsOnClay : public testing::TestWithParam<Case> {
  protected:
    static HapticState start() {
        return GetParam().is_studio ? HapticState(clay::StudioClay{}) : HapticState(clay::PaperClay{});
    }
};

TEST_P(HandsOnClay, NeverFeelMoreThanTheyMayHoweverTheyHoldTheTool) {
    const haptics::SafetyLimits limits = haptics::limits_for(test::omni_like());
    for (const HandModel& hand : kHands) {
        for (const unsigned seed : GetParam().seeds) {
            const Outcome outcome = work(start(), GetParam().rate_hz, hand, seed, kSeconds);
            const std::string who = std::string(hand.name) + ", seed " + std::to_string(seed);
            EXPECT_LE(outcome.largest_n, limits.peak_force_n * (1.0 + 1e-12)) << who;
            EXPECT_LE(outcome.largest_heat_n2, 0.88 * 0.88 * (1.0 + 1e-9)) << who;
            EXPECT_LE(outcome.largest_change_n,
                      (limits.slew_n_per_s + limits.release_n_per_s) / GetParam().rate_hz)
                << who;
            EXPECT_EQ(outcome.fault, haptics::Fault::kNone) << who;
            EXPECT_LT(outcome.farthest_mm, 200.0) << who;
            // A few mJ are a tool of 45 g at some hundred mm/s; a vibration would add up without bound.
            EXPECT_LT(outcome.most_given_mj, 8.0) << who;
            EXPECT_LT(outcome.most_generated_mj, limits.most_generated_mj / 50.0) << who;
            // The test is only valid if hands that hold the tool press it into the clay.
            EXPECT_TRUE(hand.mass_kg == 0.0 || outcome.touched_s > kSeconds / 20.0) << who;
        }
    }
}

TEST_P(HandsOnClay, LeaveAFreeToolAtRest) {
    const Outcome outcome = work(start(), GetParam().rate_hz, kHands[0], 1, 10.0);
    EXPECT_GT(outcome.touched_s, 0.0);
    EXPECT_LT(outcome.late_swing_mm, 0.12);
}

INSTANTIATE_TEST_SUITE_P(BothClaysAtBothRates, HandsOnClay,
                         testing::Values(Case{"PaperAt1kHz", false, 1000.0, {1, 2}},
                                         Case{"StudioAt1kHz", true, 1000.0, {1, 2}},
                                         Case{"PaperAt4kHz", false, 4000.0, {2}},
                                         Case{"StudioAt4kHz", true, 4000.0, {2}}),
                         [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace onggi::haptic
