#include <algorithm>
#include <cmath>

#include "engine/haptics/safety/stages.h"
#include "engine/haptics/safety/vectors.h"

namespace onggi::haptics {

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
    return state.applied_force_n = held + safety::at_most(force_n - held, limits.slew_n_per_s * input.dt_s);
}

}  // namespace onggi::haptics
