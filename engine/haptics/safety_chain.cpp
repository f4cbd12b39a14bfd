#include "engine/haptics/safety_chain.h"

#include <algorithm>
#include <cmath>

namespace onggi::haptics {
namespace {

bool finite(const dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Shortens the vector to at most the length; its direction stays.
dvec3 at_most(const dvec3& v, double length) {
    const double now = std::sqrt(glm::dot(v, v));
    return now > length ? v * (length / now) : v;
}

void latch(SafetyState& state, Fault fault) {
    state.fault = fault;
    ++state.fault_count;
    state.ramp = 0.0;
    state.calm_ticks = 0;
}

}  // namespace

SafetyLimits limits_for(const DeviceCapabilities& device) {
    SafetyLimits limits;
    if (device.force_axes > 0) limits.peak_force_n = std::min(limits.peak_force_n, device.peak_force_n);
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
    }
    return "unknown fault";
}

void rearm(SafetyState& state) noexcept {
    state.fault = Fault::kNone;
    state.ramp = 0.0;
    state.calm_ticks = 0;
}

dvec3 gate(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
           SafetyState& state) noexcept {
    if (state.fault != Fault::kNone) return dvec3(0.0);
    const dvec3& at = input.position_mm;
    if (!finite(at)) {
        latch(state, Fault::kPositionNotFinite);
    } else if (std::abs(at.x) > limits.workspace_mm || std::abs(at.y) > limits.workspace_mm ||
               std::abs(at.z) > limits.workspace_mm) {
        latch(state, Fault::kOutsideWorkspace);
    } else if (!finite(force_n)) {
        latch(state, Fault::kForceNotFinite);
    } else {
        return force_n;
    }
    return dvec3(0.0);
}

dvec3 ramp(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
           SafetyState& state) noexcept {
    if (state.fault != Fault::kNone) return dvec3(0.0);
    if (state.calm_ticks <= limits.small_force_ticks) {
        const bool small = glm::dot(force_n, force_n) < limits.small_force_n * limits.small_force_n;
        state.calm_ticks = small ? state.calm_ticks + 1 : 0;
        return dvec3(0.0);
    }
    if (state.ramp < 1.0) state.ramp = std::min(1.0, state.ramp + input.dt_s / limits.ramp_s);
    return force_n * state.ramp;
}

dvec3 clamp(const dvec3& force_n, const SafetyInput& /*input*/, const SafetyLimits& limits,
            SafetyState& /*state*/) noexcept {
    // Scaled down by the largest coordinate first: the square of a huge but finite force would be infinite.
    const double largest = std::max({std::abs(force_n.x), std::abs(force_n.y), std::abs(force_n.z)});
    if (largest > limits.peak_force_n)
        return at_most(force_n / largest * limits.peak_force_n, limits.peak_force_n);
    return at_most(force_n, limits.peak_force_n);
}

dvec3 slew(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
           SafetyState& state) noexcept {
    if (state.fault != Fault::kNone) return state.applied_force_n = dvec3(0.0);
    const dvec3 before = state.applied_force_n;
    const double before_n = std::sqrt(glm::dot(before, before));

    // Letting go: along its own line, down to the part of it that is still wanted.
    dvec3 held = before;
    if (before_n > 0.0) {
        const double wanted_n = std::clamp(glm::dot(force_n, before) / before_n, 0.0, before_n);
        const double held_n = std::max(wanted_n, before_n - limits.release_n_per_s * input.dt_s);
        held = before * (held_n / before_n);
        if (held_n > wanted_n) return state.applied_force_n = held;
    }
    // Growing and turning: from what is held straight towards what is wanted.
    return state.applied_force_n = held + at_most(force_n - held, limits.slew_n_per_s * input.dt_s);
}

dvec3 apply_safety_chain(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
                         SafetyState& state) noexcept {
    dvec3 force = force_n;
    for (const SafetyStage& stage : kSafetyChain)
        force = stage.apply(force, input, limits, state);
    return force;
}

}  // namespace onggi::haptics
