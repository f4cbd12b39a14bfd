#include <cmath>

#include "engine/haptics/safety/stages.h"
#include "engine/haptics/safety/vectors.h"

namespace onggi::haptics {

dvec3 speed(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
            SafetyState& state) noexcept {
    const dvec3& v = input.velocity_mm_s;
    const double square = glm::dot(v, v);
    // Both comparisons are false for a speed that is no number, which the gate has latched already.
    if (safety::is_zero(force_n) || !(square > limits.brake_speed_mm_s * limits.brake_speed_mm_s))
        return force_n;
    const double speed_mm_s = std::sqrt(square);
    if (speed_mm_s >= limits.stop_speed_mm_s) {
        ++state.speed_stops;
        restart_ramp(state);
        return safety::no_force(state);
    }
    const double fraction =
        (limits.stop_speed_mm_s - speed_mm_s) / (limits.stop_speed_mm_s - limits.brake_speed_mm_s);
    return safety::fraction_of(force_n, fraction, state) - v * (limits.brake_n_s_per_mm * (1.0 - fraction));
}

}  // namespace onggi::haptics
