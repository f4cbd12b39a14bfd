#include "engine/haptics/safety/state.h"

namespace onggi::haptics {

std::string_view words_for(Fault fault) {
    switch (fault) {
        case Fault::kNone:
            return "no fault";
        case Fault::kForceNotFinite:
            return "the force was not a finite number";
        case Fault::kPositionNotFinite:
            return "the tool's position was not a finite number";
        case Fault::kOutsideWorkspace:
            return "the tool was outside the workspace";
        case Fault::kStopped:
            return "the force was stopped";
    }
    return "unknown fault";
}

void restart_ramp(SafetyState& state) noexcept {
    state.ramp = 0.0;
    state.calm_ticks = 0;
}

void rearm(SafetyState& state) noexcept {
    state.fault = Fault::kNone;
    restart_ramp(state);
}

}  // namespace onggi::haptics
