#include "engine/haptics/safety_chain.h"

#include <fmt/format.h>

namespace onggi::haptics {

namespace {

dvec3 through(std::span<const SafetyStage> stages, const dvec3& force_n, const SafetyInput& input,
              const SafetyLimits& limits, SafetyState& state) noexcept {
    state.driven_force_n = input.driven_force_n;
    dvec3 force = force_n;
    for (const SafetyStage& stage : stages)
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
    state.applied_driven_n = state.driven_force_n;
    return state.applied_force_n = force;
}

std::string describe(const SafetyState& state, const SafetyLimits& limits) {
    return fmt::format(
        "{}; ramp {:.2f}, gain {:.2f}, presence {:.2f}, energy {:+.3f} mJ (taken {:.1f}, given {:.1f}), "
        "damping "
        "{:.4f} N s/mm, mean force {:.2f} of {:.2f} N, {} late periods, {} faults",
        words_for(state.fault), state.ramp, state.gain, state.presence, state.energy_mj, state.taken_mj,
        state.given_mj, state.damping_n_s_per_mm, glm::sqrt(state.heat_n2), limits.continuous_force_n,
        state.late_count, state.fault_count);
}

}  // namespace onggi::haptics
