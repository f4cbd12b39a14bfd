#include <algorithm>

#include "engine/haptics/safety/stages.h"
#include "engine/haptics/safety/vectors.h"

namespace onggi::haptics {

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
    if (safety::is_zero(force_n)) {
        state.energy_mj -= state.energy_mj * std::min(1.0, input.dt_s / limits.forget_s);
        return force_n;
    }

    // Controller: the damping d with d v^2 dt equal to the debt. It works on the windowed velocity: one step
    // of the encoder in one tick, times the damping, is a blow of half a newton.
    const dvec3& v = input.velocity_mm_s;
    const double square = glm::dot(v, v);
    if (state.energy_mj >= 0.0 || square == 0.0 || input.dt_s <= 0.0) return force_n;
    state.damping_n_s_per_mm = std::min(limits.damping_n_s_per_mm, -state.energy_mj / (square * input.dt_s));
    return force_n - v * state.damping_n_s_per_mm;
}

}  // namespace onggi::haptics
