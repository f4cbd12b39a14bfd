// How light a colour is, and how two tell apart, as WCAG 2.1 counts it. Any thread.
#pragma once

#include <algorithm>

#include "engine/math/math.h"

namespace onggi {

// WCAG 2.1, relative luminance; of linear light with sRGB's primaries, 0 to 1.
[[nodiscard]] inline float luminance(const vec3& linear) {
    return glm::dot(linear, vec3(0.2126F, 0.7152F, 0.0722F));
}

// WCAG 2.1, contrast ratio of two luminances: 1 to 21.
[[nodiscard]] inline float contrast(float one, float other) {
    constexpr float kFlare = 0.05F;
    return (std::max(one, other) + kFlare) / (std::min(one, other) + kFlare);
}

}  // namespace onggi
