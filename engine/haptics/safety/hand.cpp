#include <algorithm>

#include "engine/haptics/safety/stages.h"
#include "engine/haptics/safety/vectors.h"

namespace onggi::haptics {

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
        // From none at all the ramp leads back, and it must see the whole force: a fraction of it would look
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

}  // namespace onggi::haptics
