#include "engine/haptics/safety_chain.h"

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

}  // namespace onggi::haptics
