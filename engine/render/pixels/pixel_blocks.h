// Pixels that the processor draws side by side, eight at a time, where it is the device. Inline, so that it
// becomes a part of whatever instructions its user is compiled for: no vector is passed by value for good,
// about which compilers would be right to warn. Any thread; pure.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "engine/math/math.h"
#include "engine/render/byte_order.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace onggi::render::blocks {

constexpr int kBlock = 8;
using Block [[gnu::vector_size(32)]] = float;
using Ints [[gnu::vector_size(32)]] = int;
constexpr Ints kNumbers{0, 1, 2, 3, 4, 5, 6, 7};
constexpr int kOpaque = -16777216;  // alpha of all eight bits, highest
struct Block3 {
    Block x;
    Block y;
    Block z;
};

[[gnu::always_inline]] inline Block most(const Block& a, float b) {
    return a > b ? a : Block{} + b;
}
[[gnu::always_inline]] inline Block least(const Block& a, float b) {
    return a < b ? a : Block{} + b;
}
[[gnu::always_inline]] inline Block root(const Block& a) {
    Block found;
    for (int i = 0; i < kBlock; ++i)
        found[i] = std::sqrt(a[i]);
    return found;
}
[[gnu::always_inline]] inline Block floats(const Ints& a) {
    return __builtin_convertvector(a, Block);
}
[[gnu::always_inline]] inline Ints ints(const Block& a) {
    return __builtin_convertvector(a, Ints);
}
[[gnu::always_inline]] inline Ints looked_up(const std::uint32_t* words, const Ints& at) {
    const auto word = [&](int i) { return static_cast<int>(words[at[i]]); };
    return Ints{word(0), word(1), word(2), word(3), word(4), word(5), word(6), word(7)};
}
[[gnu::always_inline]] inline bool any(const Ints& mask) {
    using Longs [[gnu::vector_size(32)]] = long;
    Longs halves;
    std::memcpy(&halves, &mask, sizeof halves);
    return (halves[0] | halves[1] | halves[2] | halves[3]) != 0;
}
[[gnu::always_inline]] inline Block dot(const Block3& a, const vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// From 0 to 1 without a corner at either.
[[gnu::always_inline]] inline Block eased(const Block& share) {
    return share * share * (3.0F - 2.0F * share);
}
[[gnu::always_inline]] inline Block magnitude(const Block& number) {
    return number < 0.0F ? -number : number;
}

// encode() of shaders/tone.glsl with the square root, to pixels.
[[gnu::always_inline]] inline Ints encoded(const Block3& light, ByteOrder order) {
    const Block3 under{light.x * 0.8F + 0.35F, light.y * 0.8F + 0.35F, light.z * 0.8F + 0.35F};
    const Block share = 1.0F / (under.x * under.y * under.z);
    const auto shown = [&](const Block& own, const Block& a, const Block& b) __attribute__((always_inline)) {
        return ints(root(least(own * a * b * share, 1.0F)) * 255.0F + 0.5F);
    };
    const Ints red = shown(light.x, under.y, under.z);
    const Ints green = shown(light.y, under.z, under.x);
    const Ints blue = shown(light.z, under.x, under.y);
    return order == ByteOrder::kRedFirst ? kOpaque | blue << 16 | green << 8 | red
                                         : kOpaque | red << 16 | green << 8 | blue;
}

}  // namespace onggi::render::blocks

#pragma GCC diagnostic pop
