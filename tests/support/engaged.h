// The initial state for tests of the safety chain: at 4 kHz, after the ramp and a second of calm. And the
// force and the numbers that they feed it.
#pragma once

#include <cmath>
#include <limits>

#include "engine/haptics/safety_chain.h"

namespace onggi::haptics {

constexpr double kSafetyRateHz = 4000.0;
constexpr double kSafetyDt = 1.0 / kSafetyRateHz;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const dvec3 kPush(1.0, 0.0, 0.0);

inline double length(const dvec3& v) {
    return std::sqrt(glm::dot(v, v));
}

inline SafetyState engaged() {
    SafetyState state;
    state.calm_ticks = 1000;
    state.ramp = 1.0;
    return state;
}

}  // namespace onggi::haptics
