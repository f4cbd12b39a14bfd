#include <algorithm>
#include <cmath>

#include "engine/haptics/safety/stages.h"
#include "engine/haptics/safety/vectors.h"

namespace onggi::haptics {

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

    // Letting go: along its own line, down to the part of it that is still wanted.
    dvec3 held = before;
    dvec3 held_driven = state.applied_driven_n;
    if (before_n > 0.0) {
        const double wanted_n = std::clamp(glm::dot(force_n, before) / before_n, 0.0, before_n);
        const double held_n = std::max(wanted_n, before_n - limits.release_n_per_s * input.dt_s);
        held = before * (held_n / before_n);
        held_driven *= held_n / before_n;
        if (held_n > wanted_n) return apply(state, held, held_driven);
    }
    // Growing and turning: from what is held straight towards what is wanted, the motor's part alike.
    const dvec3 way = force_n - held;
    const double fraction = safety::fraction_at_most(way, limits.slew_n_per_s * input.dt_s);
    return apply(state, held + way * fraction, held_driven + (state.driven_force_n - held_driven) * fraction);
}

}  // namespace onggi::haptics
