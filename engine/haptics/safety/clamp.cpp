#include <algorithm>
#include <cmath>

#include "engine/haptics/safety/stages.h"
#include "engine/haptics/safety/vectors.h"

namespace onggi::haptics {

dvec3 clamp(const dvec3& force_n, const SafetyInput& /*input*/, const SafetyLimits& limits,
            SafetyState& state) noexcept {
    // Scaled down by the largest coordinate first: the square of a huge but finite force would be infinite.
    const double largest = std::max({std::abs(force_n.x), std::abs(force_n.y), std::abs(force_n.z)});
    if (largest > limits.peak_force_n) {
        state.driven_force_n = state.driven_force_n / largest * limits.peak_force_n;
        return safety::at_most(force_n / largest * limits.peak_force_n, limits.peak_force_n, state);
    }
    return safety::at_most(force_n, limits.peak_force_n, state);
}

}  // namespace onggi::haptics
