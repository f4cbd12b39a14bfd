#include <cmath>

#include "engine/haptics/safety/stages.h"
#include "engine/haptics/safety/vectors.h"

namespace onggi::haptics {
namespace {

void latch(SafetyState& state, Fault fault) {
    state.fault = fault;
    ++state.fault_count;
    restart_ramp(state);
}

}  // namespace

dvec3 gate(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
           SafetyState& state) noexcept {
    if (state.fault != Fault::kNone) return safety::no_force(state);
    const dvec3& at = input.position_mm;
    if (!safety::finite(at)) {
        latch(state, Fault::kPositionNotFinite);
    } else if (std::abs(at.x) > limits.workspace_mm || std::abs(at.y) > limits.workspace_mm ||
               std::abs(at.z) > limits.workspace_mm) {
        latch(state, Fault::kOutsideWorkspace);
    } else if (!safety::finite(force_n) || !safety::finite(input.velocity_mm_s) ||
               !safety::finite(input.driven_force_n)) {
        latch(state, Fault::kForceNotFinite);
    } else if (input.stop) {
        latch(state, Fault::kStopped);
    } else {
        return force_n;
    }
    return safety::no_force(state);
}

}  // namespace onggi::haptics
