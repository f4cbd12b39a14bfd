// Small vector helpers of the safety chain. Any thread.
#pragma once

#include <cmath>

#include "engine/math/math.h"

namespace onggi::haptics::safety {

inline bool finite(const dvec3& v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool is_zero(const dvec3& v) noexcept {
    return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

// Shortens the vector to at most the length; its direction stays.
inline dvec3 at_most(const dvec3& v, double length) noexcept {
    const double square = glm::dot(v, v);
    return square > length * length ? v * (length / std::sqrt(square)) : v;
}

}  // namespace onggi::haptics::safety
