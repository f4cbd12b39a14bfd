#include "engine/haptics/safety_chain.h"

#include <algorithm>
#include <cmath>

namespace onggi::haptics {

SafetyLimits limits_for(const DeviceCapabilities& device) {
    SafetyLimits limits;
    if (device.force_axes > 0) limits.peak_force_n = std::min(limits.peak_force_n, device.peak_force_n);
    limits.continuous_force_n = limits.peak_force_n;
    if (device.force_axes > 0 && device.has_motors) {
        limits.continuous_force_n =
            std::min({limits.peak_force_n, kKioskContinuousForceN, device.continuous_force_n});
    }
    if (!device.has_motors) {
        // A mouse may move at any speed: without motors it cannot throw a hand.
        constexpr double kAnySpeedMmS = 1e9;
        limits.brake_speed_mm_s = limits.stop_speed_mm_s = kAnySpeedMmS;
    }
    // It cannot feed energy to a hand either: a finger on a screen may come down anywhere, even deep in the
    // work.
    constexpr double kAnyEnergyMj = 1e9;
    if (!device.has_motors || device.force_axes == 0) limits.most_generated_mj = kAnyEnergyMj;
    if (device.report_rate_hz > 0.0) limits.device_period_s = 1.0 / device.report_rate_hz;
    return limits;
}

std::string_view words_for(Fault fault) {
    switch (fault) {
        case Fault::kNone:
            return "no fault";
        case Fault::kForceNotFinite:
            return "the force was not a finite number";
        case Fault::kPositionNotFinite:
            return "the tool's position was not a finite number";
        case Fault::kOutsideWorkspace:
            return "the tool was outside the workspace";
        case Fault::kStopped:
            return "the force was stopped";
        case Fault::kInputNotSound:
            return "the time, the applied fraction or the driven part of the force was out of bounds";
        case Fault::kEnergyGenerated:
            return "the device gave more energy than it took";
    }
    return "unknown fault";
}

void restart_ramp(SafetyState& state) noexcept {
    state.ramp = 0.0;
    state.calm_ticks = 0;
    state.generated_mj = 0.0;
}

void rearm(SafetyState& state) noexcept {
    state.fault = Fault::kNone;
    restart_ramp(state);
}

namespace safety {
namespace {

bool finite(const dvec3& v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Comparisons with NaN are false.
bool is_within(const dvec3& v, double most) noexcept {
    return std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;
}

// Whether the stages can compute with this input.
bool is_sound(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits) noexcept {
    return input.dt_s >= 0.0 && input.dt_s <= limits.longest_tick_s && input.applied_fraction >= 0.0 &&
           input.applied_fraction <= 1.0 && is_within(input.driven_force_n, limits.most_driven_n) &&
           finite(force_n);
}

bool is_zero(const dvec3& v) noexcept {
    return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

// Returns the factor that shortens a vector to at most `length`.
double fraction_at_most(const dvec3& v, double length) noexcept {
    const double square = glm::dot(v, v);
    return square > length * length ? length / std::sqrt(square) : 1.0;
}

// Scales the force and its driven part.
dvec3 fraction_of(const dvec3& force_n, double fraction, SafetyState& state) noexcept {
    state.driven_force_n *= fraction;
    return force_n * fraction;
}

dvec3 no_force(SafetyState& state) noexcept {
    return state.driven_force_n = dvec3(0.0);
}

// Returns the force, shortened to at most most_n.
dvec3 at_most(const dvec3& force_n, double most_n, SafetyState& state) noexcept {
    return fraction_of(force_n, fraction_at_most(force_n, most_n), state);
}

}  // namespace
}  // namespace safety

namespace {

void latch(SafetyState& state, Fault fault) {
    state.fault = fault;
    ++state.fault_count;
    restart_ramp(state);
}

}  // namespace

dvec3 gate(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
           SafetyState& state) noexcept {
    if (state.fault != Fault::kNone) return safety::no_force(state);
    const dvec3& at = input.position_mm;
    if (!safety::finite(at)) {
        latch(state, Fault::kPositionNotFinite);
    } else if (!safety::is_within(at, limits.workspace_mm)) {
        latch(state, Fault::kOutsideWorkspace);
    } else if (!safety::is_sound(force_n, input, limits) || !safety::finite(input.velocity_mm_s)) {
        const bool is_finite = safety::finite(force_n) && safety::finite(input.driven_force_n) &&
                               safety::finite(input.velocity_mm_s);
        latch(state, is_finite ? Fault::kInputNotSound : Fault::kForceNotFinite);
    } else if (input.stop) {
        latch(state, Fault::kStopped);
    } else {
        return force_n;
    }
    return safety::no_force(state);
}

dvec3 speed(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
            SafetyState& state) noexcept {
    const dvec3& v = input.velocity_mm_s;
    const double square = glm::dot(v, v);
    // Both comparisons are false for NaN, which the gate has latched already.
    if (safety::is_zero(force_n) || !(square > limits.brake_speed_mm_s * limits.brake_speed_mm_s))
        return force_n;
    const double speed_mm_s = std::sqrt(square);
    if (speed_mm_s >= limits.stop_speed_mm_s) {
        ++state.speed_stops;
        restart_ramp(state);
        return safety::no_force(state);
    }
    const double fraction =
        (limits.stop_speed_mm_s - speed_mm_s) / (limits.stop_speed_mm_s - limits.brake_speed_mm_s);
    return safety::fraction_of(force_n, fraction, state) - v * (limits.brake_n_s_per_mm * (1.0 - fraction));
}

dvec3 late(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
           SafetyState& state) noexcept {
    state.late_count += input.late;
    if (input.late == 0 && state.late_fraction < limits.late_fraction && state.gain == 1.0) {
        state.late_fraction -= state.late_fraction * std::min(1.0, input.dt_s / limits.late_memory_s);
        return force_n;
    }
    // This tick stands for late + 1 periods, of which `late` were missed.
    const double missed = static_cast<double>(input.late);
    const double now = missed / (1.0 + missed);
    const double weight = std::min(1.0, input.dt_s / limits.late_memory_s * (1.0 + missed));
    state.late_fraction += (now - state.late_fraction) * weight;
    const double wanted = state.late_fraction > limits.late_fraction
                              ? std::max(limits.least_gain, limits.late_fraction / state.late_fraction)
                              : 1.0;
    state.gain +=
        std::clamp(wanted - state.gain, -input.dt_s / limits.soften_s, input.dt_s / limits.harden_s);
    return safety::fraction_of(force_n, state.gain, state);
}

dvec3 passivity(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
                SafetyState& state) noexcept {
    state.damping_n_s_per_mm = 0.0;
    if (state.fault != Fault::kNone) {
        state.has_last_position = false;
        state.energy_mj = 0.0;
        return safety::no_force(state);
    }
    const dvec3 step_mm = state.has_last_position ? input.position_mm - state.last_position_mm : dvec3(0.0);
    state.last_position_mm = input.position_mm;
    state.has_last_position = true;

    // Observer: positive when the hand moved against the force.
    const double taken_mj = -input.applied_fraction * glm::dot(state.applied_force_n, step_mm);
    (taken_mj > 0.0 ? state.taken_mj : state.given_mj) += taken_mj > 0.0 ? taken_mj : -taken_mj;
    const double driven_mj =
        std::max(0.0, input.applied_fraction * glm::dot(state.applied_driven_n, step_mm));
    state.energy_mj =
        std::clamp(state.energy_mj + taken_mj + driven_mj, -limits.energy_debt_mj, limits.energy_credit_mj);
    const double forgotten = std::min(1.0, input.dt_s / limits.generated_memory_s);
    state.generated_mj = std::max(0.0, state.generated_mj * (1.0 - forgotten) - taken_mj - driven_mj);
    if (state.generated_mj > limits.most_generated_mj) {
        latch(state, Fault::kEnergyGenerated);
        return safety::no_force(state);
    }
    if (safety::is_zero(force_n)) {
        state.energy_mj -= state.energy_mj * std::min(1.0, input.dt_s / limits.forget_s);
        return force_n;
    }

    // Controller: the damping d with d v^2 dt equal to the debt. It uses the windowed velocity: the velocity
    // of a single encoder step, times the damping, would be a blow of half a newton.
    const dvec3& v = input.velocity_mm_s;
    const double square = glm::dot(v, v);
    if (state.energy_mj >= 0.0 || square == 0.0 || input.dt_s <= 0.0) return force_n;
    state.damping_n_s_per_mm = std::min(limits.damping_n_s_per_mm, -state.energy_mj / (square * input.dt_s));
    return force_n - v * state.damping_n_s_per_mm;
}

dvec3 hand(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
           SafetyState& state) noexcept {
    if (input.position_is_new) {
        state.stale_s = 0.0;
        state.stale_ticks = 0;
    } else {
        state.stale_s += input.dt_s;
        state.stale_ticks = std::min(state.stale_ticks + 1, limits.stale_ticks);
    }
    const bool is_stale =
        state.stale_ticks >= limits.stale_ticks && state.stale_s > 2.0 * limits.device_period_s;
    if (input.hand_is_there && !is_stale) {
        if (state.presence == 1.0) return force_n;
        // From zero the force returns through the ramp, which must see the whole force: a fraction could look
        // small deep in the work.
        state.presence =
            state.presence == 0.0 ? 1.0 : std::min(1.0, state.presence + input.dt_s / limits.return_s);
    } else {
        state.presence = std::max(0.0, state.presence - input.dt_s / limits.decay_s);
        if (state.presence == 0.0) {
            restart_ramp(state);
            return safety::no_force(state);
        }
    }
    return safety::fraction_of(force_n, state.presence, state);
}

dvec3 ramp(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
           SafetyState& state) noexcept {
    if (state.fault != Fault::kNone) return safety::no_force(state);
    if (state.calm_ticks <= limits.small_force_ticks) {
        const bool small = glm::dot(force_n, force_n) < limits.small_force_n * limits.small_force_n;
        state.calm_ticks = small ? state.calm_ticks + 1 : 0;
        return safety::no_force(state);
    }
    if (state.ramp == 1.0) return force_n;
    state.ramp = std::min(1.0, state.ramp + input.dt_s / limits.ramp_s);
    return safety::fraction_of(force_n, state.ramp, state);
}

dvec3 budget(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
             SafetyState& state) noexcept {
    // Heats at least as much, and cools at most as much, as the exact mean: 1 - exp(-part) lies between part
    // - part^2/2 and part.
    const double part = std::min(1.0, input.dt_s / limits.budget_s);
    const double warmer_n2 = glm::dot(state.applied_force_n, state.applied_force_n) - state.heat_n2;
    state.heat_n2 += warmer_n2 * (warmer_n2 > 0.0 ? part : part - 0.5 * part * part);

    const double full_n2 = limits.continuous_force_n * limits.continuous_force_n;
    if (limits.continuous_force_n >= limits.peak_force_n) return force_n;
    double most_n = limits.peak_force_n;
    if (state.heat_n2 > limits.budget_knee * full_n2) {
        const double spent =
            std::min(1.0, (state.heat_n2 / full_n2 - limits.budget_knee) / (1.0 - limits.budget_knee));
        most_n += (limits.continuous_force_n - limits.peak_force_n) * spent;
    }
    // One tick, however long, must not lift the mean beyond its full value.
    const double room_n2 = full_n2 - state.heat_n2;
    if ((most_n * most_n - state.heat_n2) * limits.longest_tick_s > room_n2 * limits.budget_s) {
        most_n =
            std::sqrt(std::max(full_n2, state.heat_n2 + room_n2 * (limits.budget_s / limits.longest_tick_s)));
    }
    return most_n < limits.peak_force_n ? safety::at_most(force_n, most_n, state) : force_n;
}

dvec3 clamp(const dvec3& force_n, const SafetyInput& /*input*/, const SafetyLimits& limits,
            SafetyState& state) noexcept {
    // Divides by the largest coordinate first: the square of a huge but finite force would overflow.
    const double largest = std::max({std::abs(force_n.x), std::abs(force_n.y), std::abs(force_n.z)});
    if (largest > limits.peak_force_n) {
        state.driven_force_n = state.driven_force_n / largest * limits.peak_force_n;
        return safety::at_most(force_n / largest * limits.peak_force_n, limits.peak_force_n, state);
    }
    return safety::at_most(force_n, limits.peak_force_n, state);
}

namespace {

dvec3 apply(SafetyState& state, const dvec3& force_n, const dvec3& driven_n) noexcept {
    state.driven_force_n = state.applied_driven_n = driven_n;
    return state.applied_force_n = force_n;
}

}  // namespace

dvec3 slew(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
           SafetyState& state) noexcept {
    if (state.fault != Fault::kNone) return apply(state, dvec3(0.0), dvec3(0.0));
    const dvec3 before = state.applied_force_n;
    const double before_n = std::sqrt(glm::dot(before, before));

    // Release: shorten the held force, without turning it, to the part that is still wanted.
    dvec3 held = before;
    dvec3 held_driven = state.applied_driven_n;
    if (before_n > 0.0) {
        const double wanted_n = std::clamp(glm::dot(force_n, before) / before_n, 0.0, before_n);
        const double held_n = std::max(wanted_n, before_n - limits.release_n_per_s * input.dt_s);
        held = before * (held_n / before_n);
        held_driven *= held_n / before_n;
        if (held_n > wanted_n) return apply(state, held, held_driven);
    }
    // Growing and turning: move in a straight line from the held to the wanted force, and the driven part
    // alike.
    const dvec3 way = force_n - held;
    const double fraction = safety::fraction_at_most(way, limits.slew_n_per_s * input.dt_s);
    return apply(state, held + way * fraction, held_driven + (state.driven_force_n - held_driven) * fraction);
}

namespace {

// Inline, so that the compiler knows the stages of the chain, whose last one keeps the applied force.
inline dvec3 through(std::span<const SafetyStage> stages, const dvec3& force_n, const SafetyInput& input,
                     const SafetyLimits& limits, SafetyState& state) noexcept {
    state.driven_force_n = input.driven_force_n;
    const bool is_gated = !stages.empty() && stages.front().apply == &gate;
    dvec3 force = is_gated ? gate(force_n, input, limits, state) : force_n;
    // A gate passes only sound values.
    const bool is_open = is_gated && state.fault == Fault::kNone;
    if (!is_open && !safety::is_sound(force_n, input, limits)) {
        restart_ramp(state);
        return apply(state, dvec3(0.0), dvec3(0.0));
    }
    for (const SafetyStage& stage : stages.subspan(is_gated ? 1 : 0))
        force = stage.apply(force, input, limits, state);
    return force;
}

}  // namespace

dvec3 apply_safety_chain(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
                         SafetyState& state) noexcept {
    return through(kSafetyChain, force_n, input, limits, state);
}

dvec3 apply_stages(std::span<const SafetyStage> stages, const dvec3& force_n, const SafetyInput& input,
                   const SafetyLimits& limits, SafetyState& state) noexcept {
    const dvec3 force = through(stages, force_n, input, limits, state);
    return apply(state, force, state.driven_force_n);
}

}  // namespace onggi::haptics
