#include <algorithm>

#include "engine/haptics/safety/stages.h"
#include "engine/haptics/safety/vectors.h"

namespace onggi::haptics {

dvec3 budget(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
             SafetyState& state) noexcept {
    const double heating = glm::dot(state.applied_force_n, state.applied_force_n);
    state.heat_n2 += (heating - state.heat_n2) * std::min(1.0, input.dt_s / limits.budget_s);
    const double full_n2 = limits.continuous_force_n * limits.continuous_force_n;
    if (limits.continuous_force_n >= limits.peak_force_n || state.heat_n2 <= 0.5 * full_n2) return force_n;
    const double spent = std::min(1.0, 2.0 * state.heat_n2 / full_n2 - 1.0);
    return safety::at_most(
        force_n, limits.peak_force_n + (limits.continuous_force_n - limits.peak_force_n) * spent, state);
}

}  // namespace onggi::haptics
