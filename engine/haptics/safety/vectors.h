// Small helpers of the safety chain's stages. Any thread.
#pragma once

#include <cmath>

#include "engine/haptics/safety/state.h"
#include "engine/math/math.h"

namespace onggi::haptics::safety {

inline bool finite(const dvec3& v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool is_zero(const dvec3& v) noexcept {
    return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

// What is left of a vector that is shortened to at most the length; its direction stays.
inline double fraction_at_most(const dvec3& v, double length) noexcept {
    const double square = glm::dot(v, v);
    return square > length * length ? length / std::sqrt(square) : 1.0;
}

// A fraction of the force, and as much of what a motor is behind in it.
inline dvec3 fraction_of(const dvec3& force_n, double fraction, SafetyState& state) noexcept {
    state.driven_force_n *= fraction;
    return force_n * fraction;
}

inline dvec3 no_force(SafetyState& state) noexcept {
    return state.driven_force_n = dvec3(0.0);
}

// The force, shortened to at most so many N.
inline dvec3 at_most(const dvec3& force_n, double most_n, SafetyState& state) noexcept {
    return fraction_of(force_n, fraction_at_most(force_n, most_n), state);
}

}  // namespace onggi::haptics::safety
