// A colour as a designer writes it, and the contrast of two as WCAG 2.1 counts it. Any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

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

// What is seen of `top` laid over an opaque `below`.
[[nodiscard]] constexpr Colour over(const Colour& top, const Colour& below) {
    return mix(below, top.with_alpha(1.0F), top.a).with_alpha(1.0F);
}

// WCAG 2.1, relative luminance.
[[nodiscard]] inline float luminance(const Colour& colour) {
    const auto linear = [](float value) {
        return value <= 0.03928F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
    };
    return 0.2126F * linear(colour.r) + 0.7152F * linear(colour.g) + 0.0722F * linear(colour.b);
}

// WCAG 2.1, contrast ratio of two opaque colours: 1 to 21.
[[nodiscard]] inline float contrast(const Colour& one, const Colour& other) {
    const float a = luminance(one);
    const float b = luminance(other);
    return (std::max(a, b) + 0.05F) / (std::min(a, b) + 0.05F);
}

}  // namespace onggi::ui
