#include <algorithm>

#include "engine/haptics/safety/stages.h"
#include "engine/haptics/safety/vectors.h"

namespace onggi::haptics {

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

}  // namespace onggi::haptics
