// A vector of eight floats for the CPU renderer's loops. Inline, so that it uses the instruction set of its
// caller. Every function for Float8 also exists for float, so that one formula compiles for both. Pure; any
// thread.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

namespace onggi {

constexpr int kFloat8 = 8;
using Float8 [[gnu::vector_size(32)]] = float;
using Int8 [[gnu::vector_size(32)]] = int;  // of a comparison: all bits set, or zero
constexpr Int8 kFirst8{0, 1, 2, 3, 4, 5, 6, 7};

// Eight points or directions.
struct Float8x3 {
    Float8 x;
    Float8 y;
    Float8 z;
};

}  // namespace onggi

namespace onggi::float8 {

[[gnu::always_inline]] inline float wide_as(const float& /*like*/, float a) {
    return a;
}
[[gnu::always_inline]] inline Float8 wide_as(const Float8& /*like*/, float a) {
    return Float8{} + a;
}
[[gnu::always_inline]] inline Float8 wide_as(const Float8& /*like*/, const Float8& a) {
    return a;
}

// Returns a where is_so, otherwise b.
[[gnu::always_inline]] inline float select(bool is_so, float a, float b) {
    return is_so ? a : b;
}
template <typename A, typename B>
[[gnu::always_inline]] inline Float8 select(const Int8& is_so, const A& a, const B& b) {
    return is_so ? wide_as(Float8{}, a) : wide_as(Float8{}, b);
}
[[gnu::always_inline]] inline auto max(const auto& a, const auto& b) {
    return select(a > b, a, b);
}
[[gnu::always_inline]] inline auto min(const auto& a, const auto& b) {
    return select(a < b, a, b);
}
[[gnu::always_inline]] inline auto clamp(const auto& a, float low, float high) {
    return min(max(a, low), high);
}
[[gnu::always_inline]] inline auto mix(const auto& a, const auto& b, const auto& fraction) {
    return a + (b - a) * fraction;
}
[[gnu::always_inline]] inline auto abs(const auto& a) {
    return select(a < 0.0F, -a, a);
}
[[gnu::always_inline]] inline float sqrt(float a) {
    return std::sqrt(a);
}
[[gnu::always_inline]] inline Float8 sqrt(const Float8& a) {
    Float8 found;
    for (int i = 0; i < kFloat8; ++i)
        found[i] = std::sqrt(a[i]);
    return found;
}
[[gnu::always_inline]] inline auto inversesqrt(const auto& a) {
    return 1.0F / sqrt(a);
}
// Smoothstep from 0 to 1.
[[gnu::always_inline]] inline auto eased(const auto& fraction) {
    return fraction * fraction * (3.0F - 2.0F * fraction);
}
[[gnu::always_inline]] inline auto smoothstep(const auto& from, const auto& to, const auto& at) {
    return eased(clamp((at - from) / (to - from), 0.0F, 1.0F));
}

[[gnu::always_inline]] inline Float8 floats(const Int8& a) {
    return __builtin_convertvector(a, Float8);
}
[[gnu::always_inline]] inline Int8 ints(const Float8& a) {
    return __builtin_convertvector(a, Int8);
}
// Precondition: not below 0.
[[gnu::always_inline]] inline auto fract(const Float8& a) {
    return a - floats(ints(a));
}
[[gnu::always_inline]] inline Float8 two_to(const Int8& a) {
    const Int8 bits = (a + 127) << 23;
    Float8 found;
    std::memcpy(&found, &bits, sizeof found);
    return found;
}
[[gnu::always_inline]] inline float floats(int a) {
    return static_cast<float>(a);
}
[[gnu::always_inline]] inline int ints(float a) {
    return static_cast<int>(a);
}
[[gnu::always_inline]] inline float two_to(int a) {
    return std::bit_cast<float>((a + 127) << 23);
}
// exp() of a number not above 0: the power of two is built from its bits, the rest is a series of seven
// terms; error below 2e-5.
[[gnu::always_inline]] inline auto exp_below_0(const auto& number) {
    const auto clamped = max(number, -87.0F);
    const auto twos = ints(clamped * std::numbers::log2e_v<float>);
    const auto t = clamped - floats(twos) * std::numbers::ln2_v<float>;
    const auto series =
        1.0F +
        t * (1.0F + t / 2.0F * (1.0F + t / 3.0F * (1.0F + t / 4.0F * (1.0F + t / 5.0F * (1.0F + t / 6.0F)))));
    return series * two_to(twos);
}

[[gnu::always_inline]] inline bool any(const Int8& mask) {
    using Longs [[gnu::vector_size(32)]] = long;
    Longs halves;
    std::memcpy(&halves, &mask, sizeof halves);
    return (halves[0] | halves[1] | halves[2] | halves[3]) != 0;
}
[[gnu::always_inline]] inline Int8 looked_up(const std::uint32_t* words, const Int8& at) {
    const auto word = [&](int i) { return static_cast<int>(words[at[i]]); };
    return Int8{word(0), word(1), word(2), word(3), word(4), word(5), word(6), word(7)};
}
[[gnu::always_inline]] inline Float8 looked_up(const float* numbers, const Int8& at) {
    Float8 found;
    for (int i = 0; i < kFloat8; ++i)
        found[i] = numbers[at[i]];
    return found;
}

}  // namespace onggi::float8
