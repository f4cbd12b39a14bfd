#include "engine/render/shade_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace onggi::render {
namespace {

constexpr std::uint32_t kAcross = shaders::kMaskTexels;
constexpr std::size_t kBlock = kShadeBlockPx;
constexpr std::size_t kLanes = 4 * kBlock;

// Where a coordinate of sixteen bits lies: the texel before it and, in 1/256, how far it is to the next.
// Outside of the first and the last half texel it is their middle.
std::uint32_t steps_of(std::uint32_t coordinate) {
    const double texel = coordinate / 65535.0 * kAcross - 0.5;
    const double most = 256.0 * (kAcross - 1) - 1.0;
    return static_cast<std::uint32_t>(std::clamp(std::floor(texel * 256.0), 0.0, most));
}

// The four texels about a place, mixed, times 65536: nothing is lost on the way, because where little of a
// bright light is left the eye sees less than 1/255 of it.
struct Mixed {
    std::uint32_t key = 0;
    std::uint32_t sky = 0;
    std::uint32_t all_of = 0;  // kUnshaded: nothing of the four is in shade
};
[[gnu::always_inline]] inline Mixed mask_at(const ShadowMask& mask, std::uint32_t place) {
    const std::uint32_t* const texel = mask.data() + (place >> 16U);
    const std::uint32_t across = place & 0xFFU;
    const std::uint32_t down = (place >> 8U) & 0xFFU;
    // Key and sky at once, as the two halves of a word.
    const std::uint32_t near_row = texel[0] * (256U - across) + texel[1] * across;
    const std::uint32_t far_row = texel[kAcross] * (256U - across) + texel[kAcross + 1] * across;
    return {.key = (near_row & 0xFFFFU) * (256U - down) + (far_row & 0xFFFFU) * down,
            .sky = (near_row >> 16U) * (256U - down) + (far_row >> 16U) * down,
            .all_of = texel[0] & texel[1] & texel[kAcross] & texel[kAcross + 1]};
}

// Of one block: every byte of its texels is a lane. `left` is what the sky's shade leaves of the light.
struct Lanes {
    std::array<std::uint8_t, kLanes> with_key;
    std::array<std::uint8_t, kLanes> without_key;
    std::array<float, kLanes> share;
    std::array<float, kLanes> left;
    std::array<std::uint8_t, kLanes> out;
};

// encode_mixed() of shaders/tone.glsl with the square-root transfer; its own words say why it is right.
[[gnu::always_inline]] inline void mix_lights(Lanes& lanes) {
    constexpr float kOneOver255 = 1.0F / 255.0F;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float a = static_cast<float>(lanes.without_key[i]) * kOneOver255;
        const float b = static_cast<float>(lanes.with_key[i]) * kOneOver255;
        const float curve_a = a * a;
        const float curve_b = b * b;
        const float under_a = 1.0F - 0.8F * curve_a;
        const float under_b = 1.0F - 0.8F * curve_b;
        const float share = lanes.share[i];
        const float light = (curve_a * under_b * (1.0F - share) + curve_b * under_a * share) * lanes.left[i];
        const float shown = std::sqrt(light / (light * 0.8F + under_a * under_b));
        lanes.out[i] = static_cast<std::uint8_t>(static_cast<int>(shown * 255.0F + 0.5F));
    }
}

[[gnu::always_inline]] inline void shade_block(const ShadeLayers& layers, const ShadowMask& mask,
                                               std::size_t first, std::uint32_t* into) {
    constexpr float kOneOver255 = 1.0F / 255.0F;
    constexpr float kOneOverMixed = kOneOver255 / 65536.0F;
    std::array<std::uint32_t, kBlock> key;
    std::array<std::uint32_t, kBlock> sky;
    std::uint32_t all = kUnshaded;
    for (std::size_t i = 0; i < kBlock; ++i) {
        const Mixed mixed = mask_at(mask, layers.places[first + i]);
        key[i] = mixed.key;
        sky[i] = mixed.sky;
        all &= mixed.all_of;
    }
    if (all == kUnshaded) {
        std::memcpy(into + first, layers.with_key.data() + first, kLanes);
        return;
    }
    Lanes lanes;
    std::memcpy(lanes.with_key.data(), layers.with_key.data() + first, kLanes);
    std::memcpy(lanes.without_key.data(), layers.without_key.data() + first, kLanes);
    for (std::size_t i = 0; i < kBlock; ++i) {
        const float share = static_cast<float>(static_cast<int>(key[i])) * kOneOverMixed;
        const float open = static_cast<float>(static_cast<int>(sky[i])) * kOneOverMixed;
        const float weight = static_cast<float>(lanes.without_key[4 * i + 3]) * kOneOver255;
        const float left = 1.0F + (open - 1.0F) * weight;
        for (std::size_t channel = 0; channel < 4; ++channel) {
            lanes.share[4 * i + channel] = share;
            lanes.left[4 * i + channel] = left;
        }
    }
    mix_lights(lanes);
    for (std::size_t i = 0; i < kBlock; ++i)
        lanes.out[4 * i + 3] = 255;
    std::memcpy(into + first, lanes.out.data(), kLanes);
}

// Whole blocks only: the last of a line begins earlier, and a rectangle that is narrower than one is shaded
// with its neighbours.
[[gnu::always_inline]] inline void shade_rect(const ShadeLayers& layers, const ShadowMask& mask,
                                              const PixelRect& rect, std::uint32_t* into) {
    const auto width = static_cast<std::size_t>(layers.width);
    const auto left = static_cast<std::size_t>(rect.x);
    const auto right = std::max(static_cast<std::size_t>(rect.x + rect.width), kBlock);
    const auto bottom = static_cast<std::size_t>(rect.y + rect.height);
    for (auto y = static_cast<std::size_t>(rect.y); y < bottom; ++y) {
        for (std::size_t x = left; x < right; x += kBlock)
            shade_block(layers, mask, y * width + std::min(x, right - kBlock), into);
    }
}

using ShadeRect = void (*)(const ShadeLayers&, const ShadowMask&, const PixelRect&, std::uint32_t*);

void shade_rect_plain(const ShadeLayers& layers, const ShadowMask& mask, const PixelRect& rect,
                      std::uint32_t* into) {
    shade_rect(layers, mask, rect, into);
}

#if defined(__x86_64__)
// The same lines, eight lanes at a time; without fused multiply-add, so the same bits.
[[gnu::target("avx2")]] void shade_rect_avx2(const ShadeLayers& layers, const ShadowMask& mask,
                                             const PixelRect& rect, std::uint32_t* into) {
    shade_rect(layers, mask, rect, into);
}

ShadeRect best_for_this_processor() {
    return __builtin_cpu_supports("avx2") != 0 ? shade_rect_avx2 : shade_rect_plain;
}
#else
ShadeRect best_for_this_processor() {
    return shade_rect_plain;
}
#endif

}  // namespace

std::uint32_t mask_place(std::uint32_t packed_coords) {
    const auto byte = [&](unsigned at) { return (packed_coords >> (8U * at)) & 0xFFU; };
    const std::uint32_t across = steps_of(byte(0) * 256U + byte(1));
    const std::uint32_t down = steps_of(byte(2) * 256U + byte(3));
    const std::uint32_t texel = (down >> 8U) * kAcross + (across >> 8U);
    return (texel << 16U) | ((down & 0xFFU) << 8U) | (across & 0xFFU);
}

void shade_pixels(const ShadeLayers& layers, const ShadowMask& mask, std::span<const PixelRect> rects,
                  std::span<std::uint32_t> into) {
    static const ShadeRect shade = best_for_this_processor();
    for (const PixelRect& rect : rects)
        shade(layers, mask, rect, into.data());
}

}  // namespace onggi::render
