#include "engine/haptics/stability.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "engine/haptics/velocity_estimator.h"

namespace onggi::haptics {
namespace {

constexpr double kMmPerM = 1000.0;  // N on a kg is m/s^2
constexpr std::size_t kMostDelay = 16;
constexpr double kStepUp = 1.05;
constexpr double kStepUpAtLoad = 1.15;
constexpr double kLeastStiffness = 0.01;

// The tool, and optionally a hand on it, between two ticks: the force is held while time advances in small
// steps. x grows outwards; the wall is below 0.
struct Body {
    const DeviceCapabilities& device;
    const LoopSetting& setting;
    double x_mm = 0.0;
    double v_mm_s = 0.0;
    double hand_x_mm = 0.0;
    double hand_v_mm_s = 0.0;

    // Returns the work of the held force, mJ.
    double advance(double force_n, double dt_s) {
        constexpr double kFinestS = 50e-6;
        const int steps = std::max(4, static_cast<int>(std::ceil(dt_s / kFinestS)));
        const double h = dt_s / steps;
        const double before_mm = x_mm;
        const bool held = setting.hand_mass_kg > 0.0;
        for (int step = 0; step < steps; ++step) {
            double push_n = force_n - device.damping_n_s_per_mm * v_mm_s;
            if (held) {
                const double grip_n = setting.hand_stiffness_n_per_mm * (hand_x_mm - x_mm) +
                                      setting.hand_damping_n_s_per_mm * (hand_v_mm_s - v_mm_s);
                push_n += grip_n;
                hand_v_mm_s += (-setting.press_n - grip_n) / setting.hand_mass_kg * kMmPerM * h;
                hand_x_mm += hand_v_mm_s * h;
            } else {
                push_n -= setting.press_n;
            }
            v_mm_s += push_n / device.moving_mass_kg * kMmPerM * h;
            // Dry friction reduces speed and never reverses it.
            const double loss = device.coulomb_friction_n / device.moving_mass_kg * kMmPerM * h;
            v_mm_s = v_mm_s > 0.0 ? std::max(0.0, v_mm_s - loss) : std::min(0.0, v_mm_s + loss);
            x_mm += v_mm_s * h;
        }
        return force_n * (x_mm - before_mm);
    }

    [[nodiscard]] double reading_mm() const {
        const double step = device.position_resolution_mm;
        return step > 0.0 ? std::round(x_mm / step) * step : x_mm;
    }
};

// Motion within two encoder steps counts as rest; a shrinking one will come to rest.
bool dies_away(const LoopMotion& motion, const DeviceCapabilities& device) {
    constexpr double kLeastMm = 0.02;
    constexpr double kShrinks = 0.95;
    return motion.swing_mm <= std::max(kLeastMm, 2.0 * device.position_resolution_mm) ||
           motion.swing_mm <= kShrinks * motion.earlier_swing_mm;
}

// The loop runs at most at the rate of the device's reports and of the forces sent to it.
double loop_rate_hz(const DeviceCapabilities& device, double rate_hz) {
    const double own_hz = device.wire_rate_hz > 0.0 ? device.wire_rate_hz : device.report_rate_hz;
    return own_hz > 0.0 ? std::min(rate_hz, own_hz) : rate_hz;
}

// The device as simulated: if its mass is unknown, light and without friction, because both make it less
// stable.
DeviceCapabilities judged(const DeviceCapabilities& device) {
    DeviceCapabilities whole = device;
    if (whole.moving_mass_kg > 0.0) return whole;
    constexpr double kAssumedMassKg = 0.045;
    constexpr double kAssumedDampingNSPerMm = 0.0001;
    whole.moving_mass_kg = kAssumedMassKg;
    whole.damping_n_s_per_mm = kAssumedDampingNSPerMm;
    whole.coulomb_friction_n = 0.0;
    return whole;
}

// Tries some smaller values too, most of them close by, because a stable value may be an island above
// unstable ones. A full search would delay the start too much.
template <typename Try>
bool is_stable_up_to(double most, Try&& is_good) {
    constexpr double kFractions[] = {0.125, 0.25, 0.5, 0.75, 0.9, 0.95, 1.0};
    return std::all_of(std::begin(kFractions), std::end(kFractions),
                       [&](double fraction) { return is_good(fraction * most); });
}

template <typename Try>
double largest_that(Try&& is_good, double least, double most, double step_up = kStepUp) {
    double good = 0.0;
    for (double tried = least; tried < most; tried *= step_up) {
        if (!is_good(tried)) return good;
        good = tried;
    }
    return is_good(most) ? most : good;
}

}  // namespace

LoopMotion run_loop(const DeviceCapabilities& device, const LoopSetting& setting, double stiffness_n_per_mm,
                    double speed_mm_s, double seconds) {
    assert(device.moving_mass_kg > 0.0 && setting.delay_ticks >= 0 &&
           static_cast<std::size_t>(setting.delay_ticks) < kMostDelay);
    const double dt_s = 1.0 / setting.rate_hz;
    Body body{.device = device, .setting = setting, .v_mm_s = -speed_mm_s, .hand_v_mm_s = -speed_mm_s};
    VelocityEstimator estimator(device.position_resolution_mm);
    const SafetyLimits limits = limits_for(device);
    SafetyState safety;
    safety.calm_ticks = limits.small_force_ticks + 1;
    safety.ramp = 1.0;
    std::array<double, kMostDelay> late_n{};

    LoopMotion motion;
    const auto ticks = static_cast<std::size_t>(seconds * setting.rate_hz);
    double low_mm = 0.0;
    double high_mm = 0.0;
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        const double at_mm = body.reading_mm();
        const dvec3 velocity_mm_s = estimator.update({at_mm, 0.0, 0.0}, dt_s);
        double force_n = 0.0;
        if (at_mm < 0.0)
            force_n = -stiffness_n_per_mm * at_mm - setting.viscosity_n_s_per_mm * velocity_mm_s.x;
        if (!setting.stages.empty()) {
            force_n =
                apply_stages(setting.stages, {force_n, 0.0, 0.0},
                             {.position_mm = {at_mm, 0.0, 0.0}, .dt_s = dt_s, .velocity_mm_s = velocity_mm_s},
                             limits, safety)
                    .x;
        }
        // This force acts `delay` ticks later.
        const std::size_t delay = static_cast<std::size_t>(setting.delay_ticks);
        late_n[tick % kMostDelay] = force_n;
        const double held_n = tick >= delay ? late_n[(tick - delay) % kMostDelay] : 0.0;
        const double given_mj = body.advance(held_n, dt_s);

        motion.deepest_mm = std::max(motion.deepest_mm, -body.x_mm);
        motion.largest_force_n = std::max(motion.largest_force_n, std::abs(held_n));
        if (tick == ticks * 3 / 4) motion.earlier_swing_mm = high_mm - low_mm;
        if (tick <= ticks / 2 || tick == ticks * 3 / 4) low_mm = high_mm = body.x_mm;
        low_mm = std::min(low_mm, body.x_mm);
        high_mm = std::max(high_mm, body.x_mm);
        if (tick >= ticks * 3 / 4) motion.energy_mj += given_mj;
        constexpr double kGoneMm = 1e4;  // it has clearly diverged, even if the chain then dropped the force
        if (!(std::abs(body.x_mm) < kGoneMm) || safety.fault != Fault::kNone) {
            motion.swing_mm = kGoneMm;
            motion.earlier_swing_mm = 0.0;
            return motion;
        }
    }
    motion.swing_mm = high_mm - low_mm;
    return motion;
}

bool is_stable(const DeviceCapabilities& device, const LoopSetting& setting, double stiffness_n_per_mm) {
    constexpr double kTouchMmS = 5.0;
    constexpr double kKnockMmS = 100.0;
    return dies_away(run_loop(device, setting, stiffness_n_per_mm, kTouchMmS), device) &&
           dies_away(run_loop(device, setting, stiffness_n_per_mm, kKnockMmS), device);
}

double largest_stable_stiffness_n_per_mm(const DeviceCapabilities& device, const LoopSetting& setting,
                                         double most) {
    return largest_that([&](double tried) { return is_stable(device, setting, tried); }, kLeastStiffness,
                        most);
}

double largest_stable_viscosity_n_s_per_mm(const DeviceCapabilities& device, const LoopSetting& setting,
                                           double stiffness_n_per_mm, double most) {
    constexpr double kLeast = 0.0002;
    LoopSetting tried_setting = setting;
    return largest_that(
        [&](double tried) {
            tried_setting.viscosity_n_s_per_mm = tried;
            return is_stable(device, tried_setting, stiffness_n_per_mm);
        },
        kLeast, most);
}

LoopSetting loop_of(const DeviceCapabilities& device, double rate_hz) {
    LoopSetting setting{.rate_hz = loop_rate_hz(device, rate_hz)};
    if (!device.has_own_walls) setting.stages = kSafetyChain;
    // A hand that leans harder than the device pushes goes through any wall; that is not an instability.
    if (device.peak_force_n > 0.0) setting.press_n = std::min(setting.press_n, 0.5 * device.peak_force_n);
    constexpr double kRounding = 1e-6;
    const double late_ticks = std::ceil(device.wire_delay_s * setting.rate_hz - kRounding);
    setting.delay_ticks = std::min(1 + static_cast<int>(late_ticks), static_cast<int>(kMostDelay) - 1);
    return setting;
}

double stiffest_for(const DeviceCapabilities& device, double rate_hz, double most,
                    double viscosity_n_s_per_mm) {
    const DeviceCapabilities known = judged(device);
    const LoopSetting bare = loop_of(device, rate_hz);
    LoopSetting viscous = bare;
    viscous.viscosity_n_s_per_mm = viscosity_n_s_per_mm;
    const auto bears = [&](double tried) {
        return is_stable(known, bare, tried) &&
               (viscosity_n_s_per_mm == 0.0 || is_stable(known, viscous, tried));
    };
    if (is_stable_up_to(most, bears)) return most;
    return largest_that(bears, kLeastStiffness, most, kStepUpAtLoad);
}

Result<void> check_work_on_device(const DeviceCapabilities& device, double rate_hz, double stiffness_n_per_mm,
                                  double viscosity_n_s_per_mm) {
    if (device.force_axes == 0 || !device.has_motors || device.has_own_walls) return {};
    if (device.max_stiffness_n_per_mm > 0.0 && stiffness_n_per_mm > device.max_stiffness_n_per_mm) {
        return bad_input(
            fmt::format("{}: expected a stiffness of at most {:.3g} N/mm, its maker's limit, found {:.3g}",
                        device.name, device.max_stiffness_n_per_mm, stiffness_n_per_mm));
    }
    const DeviceCapabilities known = judged(device);
    const LoopSetting setting = loop_of(device, rate_hz);
    const auto bears_stiffness = [&](double tried) { return is_stable(known, setting, tried); };
    if (!is_stable_up_to(stiffness_n_per_mm, bears_stiffness)) {
        const double stiffest = largest_stable_stiffness_n_per_mm(known, setting, stiffness_n_per_mm);
        return bad_input(fmt::format(
            "{}: expected a stiffness of at most {:.3g} N/mm, the largest that is stable on it at "
            "{:.0f} Hz, found {:.3g}",
            device.name, stiffest, setting.rate_hz, stiffness_n_per_mm));
    }
    LoopSetting viscous = setting;
    const auto bears = [&](double tried) {
        viscous.viscosity_n_s_per_mm = tried;
        return is_stable(known, viscous, stiffness_n_per_mm);
    };
    if (!is_stable_up_to(viscosity_n_s_per_mm, bears)) {
        const double most_viscous =
            largest_stable_viscosity_n_s_per_mm(known, setting, stiffness_n_per_mm, viscosity_n_s_per_mm);
        return bad_input(fmt::format(
            "{}: expected a viscosity of at most {:.3g} N s/mm, the largest that is stable on it at "
            "{:.0f} Hz, found {:.3g}",
            device.name, most_viscous, setting.rate_hz, viscosity_n_s_per_mm));
    }
    return {};
}

}  // namespace onggi::haptics
