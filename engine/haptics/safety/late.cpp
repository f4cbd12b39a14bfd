#include <algorithm>

#include "engine/haptics/safety/stages.h"
#include "engine/haptics/safety/vectors.h"

namespace onggi::haptics {

dvec3 late(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
           SafetyState& state) noexcept {
    state.late_count += input.late;
    if (input.late == 0 && state.late_fraction < limits.late_fraction && state.gain == 1.0) {
        state.late_fraction -= state.late_fraction * std::min(1.0, input.dt_s / limits.late_memory_s);
        return force_n;
    }
    // Of the periods that this tick stands for, its own among them, so many were missed.
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

}  // namespace onggi::haptics
