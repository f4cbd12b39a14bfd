// The initial state for tests of the safety chain: at 4 kHz, after the ramp and a second of calm.
#pragma once

#include "engine/haptics/safety_chain.h"

namespace onggi::haptics {

constexpr double kSafetyRateHz = 4000.0;
constexpr double kSafetyDt = 1.0 / kSafetyRateHz;

inline SafetyState engaged() {
    SafetyState state;
    state.calm_ticks = 1000;
    state.ramp = 1.0;
    return state;
}

}  // namespace onggi::haptics
