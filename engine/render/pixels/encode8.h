// Encodes light as pixels, eight at a time: encode() of shaders/tone.glsl. Inline, so that the code is
// compiled for its caller's instruction set. Any thread; pure.
#pragma once

#include "engine/math/float8.h"
#include "engine/render/byte_order.h"
#include "shaders/curve.h"
#include "shaders/transfer.h"

namespace onggi::render {

constexpr int kOpaque = -16777216;  // alpha of 255 in the highest byte

// `light` must not be negative. The three fractions share one division.
[[gnu::always_inline]] inline Int8 encoded(const Float8x3& light, ByteOrder order) {
    const Float8x3 under{shaders::curve_under(light.x), shaders::curve_under(light.y),
                         shaders::curve_under(light.z)};
    const Float8 fraction = 1.0F / (under.x * under.y * under.z);
    const auto shown = [&](const Float8& own, const Float8& a, const Float8& b)
        __attribute__((always_inline)) {
        return float8::ints(shaders::transferred(float8::min(own * a * b * fraction, 1.0F)) * 255.0F + 0.5F);
    };
    const Int8 red = shown(light.x, under.y, under.z);
    const Int8 green = shown(light.y, under.z, under.x);
    const Int8 blue = shown(light.z, under.x, under.y);
    return order == ByteOrder::kRedFirst ? kOpaque | blue << 16 | green << 8 | red
                                         : kOpaque | red << 16 | green << 8 | blue;
}

}  // namespace onggi::render
