// Colours as designers write them, and the contrast of two colours by WCAG 2.1. Any thread.
#pragma once

#include <cmath>
#include <cstdint>

#include "engine/math/light.h"

namespace onggi::ui {

// sRGB-encoded, straight alpha, each 0 to 1.
struct Colour {
    float r = 0.0F;
    float g = 0.0F;
    float b = 0.0F;
    float a = 1.0F;

    [[nodiscard]] constexpr Colour with_alpha(float alpha) const { return {r, g, b, alpha}; }
    friend bool operator==(const Colour&, const Colour&) = default;
};

// 0xRRGGBB.
[[nodiscard]] constexpr Colour hex(std::uint32_t rgb, float alpha = 1.0F) {
    return {static_cast<float>((rgb >> 16U) & 255U) / 255.0F, static_cast<float>((rgb >> 8U) & 255U) / 255.0F,
            static_cast<float>(rgb & 255U) / 255.0F, alpha};
}

[[nodiscard]] constexpr Colour mix(const Colour& from, const Colour& to, float fraction) {
    return {from.r + (to.r - from.r) * fraction, from.g + (to.g - from.g) * fraction,
            from.b + (to.b - from.b) * fraction, from.a + (to.a - from.a) * fraction};
}

// `top` composed over an opaque `below`.
[[nodiscard]] constexpr Colour over(const Colour& top, const Colour& below) {
    return mix(below, top.with_alpha(1.0F), top.a).with_alpha(1.0F);
}

[[nodiscard]] inline float luminance(const Colour& colour) {
    return onggi::luminance(
        {linear_from_srgb(colour.r), linear_from_srgb(colour.g), linear_from_srgb(colour.b)});
}

// Contrast ratio of two opaque colours.
[[nodiscard]] inline float contrast(const Colour& one, const Colour& other) {
    return onggi::contrast(luminance(one), luminance(other));
}

}  // namespace onggi::ui
