// Standard formulas for light and colour: sRGB's transfer function, luminance and contrast, and darkening by
// water. Any thread; pure.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/math/math.h"

namespace onggi {

// IEC 61966-2-1 (sRGB), from an encoded value to linear light and back, both 0 to 1. Exact, for files, still
// pictures and constant colours; shaders/transfer.h has the fast approximation for frames.
[[nodiscard]] inline float linear_from_srgb(float value) {
    return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}
[[nodiscard]] inline float srgb_from_linear(float light) {
    return light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1.0F / 2.4F) - 0.055F;
}

// WCAG 2.1, relative luminance of linear light with sRGB's primaries, 0 to 1.
[[nodiscard]] inline float luminance(const vec3& linear) {
    return glm::dot(linear, vec3(0.2126F, 0.7152F, 0.0722F));
}

// WCAG 2.1, contrast ratio of two luminances: 1 to 21.
[[nodiscard]] inline float contrast(float one, float other) {
    constexpr float kFlare = 0.05F;
    return (std::max(one, other) + kFlare) / (std::min(one, other) + kFlare);
}

// A wet body is darker and more saturated: light that the water reflects back into it is absorbed once more.
// J. Lekner, M. Dorf, "Why some things are darker when wet", 1988: A' = A (1 - p) / (1 - p A), where p is the
// fraction of diffuse light that water reflects back inside.
template <typename Vec>
[[nodiscard]] Vec wet_albedo(const Vec& dry) {
    using Real = typename Vec::value_type;
    constexpr auto kReflectedBack = static_cast<Real>(0.66);
    return dry * (Real{1} - kReflectedBack) / (Vec(Real{1}) - kReflectedBack * dry);
}

}  // namespace onggi
