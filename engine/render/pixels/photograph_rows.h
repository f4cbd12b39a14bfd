// A few pixels of a row out of a photograph: the innermost loops of photograph_layers.cpp, in a file of their
// own and inline, so that they become a part of whatever instructions that is compiled for. Any thread; pure.
// Pixels, texels.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "engine/render/pixels/host_photograph.h"
#include "engine/render/pixels/picture_shapes.h"

namespace onggi::render::rows {

using shapes::fixed;
using shapes::kOne;
using shapes::Slope;

using Bytes [[gnu::vector_size(16)]] = std::uint8_t;
using Longs [[gnu::vector_size(16)]] = std::uint64_t;
using Bytes8 [[gnu::vector_size(8)]] = std::uint8_t;
using Halves [[gnu::vector_size(16)]] = std::uint16_t;

// Where a row of pixels lies in a photograph, in texels from the middle of its first.
struct Place {
    Slope u;
    Slope v;
};

[[gnu::always_inline]] inline bool lies_in(const HostPhotograph& photograph, const Place& place, int count) {
    // The fringe is there for what rounding makes of the border.
    constexpr float kFringe = 1.0F / 256.0F;
    const auto is_in = [&](const Slope& along, int texels) {
        const float last = along.at(count - 1);
        const float most = static_cast<float>(texels - 1) + kFringe;
        return along.first >= -kFringe && last >= -kFringe && along.first <= most && last <= most;
    };
    return is_in(place.u, photograph.width()) && is_in(place.v, photograph.height());
}

// Two neighbours in a row of texels, a half word a channel.
[[gnu::always_inline]] inline Halves two_texels(const std::uint32_t* at) {
    std::uint64_t both = 0;
    std::memcpy(&both, at, sizeof both);
    const auto bytes = std::bit_cast<Bytes>(Longs{both, 0});
    return std::bit_cast<Halves>(
        __builtin_shufflevector(bytes, Bytes{}, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23));
}

// From a to b by what lies behind the point. Halves overflow on the way, and what comes out does not.
template <typename Lanes>
[[gnu::always_inline]] inline void go_towards(Lanes& a, const Lanes& b, int place) {
    const auto part = static_cast<std::uint16_t>(place >> 8 & 255);
    a = ((a << 8) + (b - a) * part + 128) >> 8;
}

// The four texels about a place, mixed; what is to be used lies in the lower half.
[[gnu::always_inline]] inline Halves texel_at(const std::uint32_t* texels, std::ptrdiff_t across, int u,
                                              int v) {
    const std::uint32_t* const at = texels + (v >> 16) * across + (u >> 16);
    Halves column = two_texels(at);
    go_towards(column, two_texels(at + across), v);
    go_towards(column, __builtin_shufflevector(column, column, 4, 5, 6, 7, 4, 5, 6, 7), u);
    return column;
}

// Pixels that are made side by side.
constexpr int kBlock = 4;
using BlockHalves [[gnu::vector_size(32)]] = std::uint16_t;

[[gnu::always_inline]] inline void read_block(const std::uint32_t* at, BlockHalves& block) {
    Bytes bytes;
    std::memcpy(&bytes, at, sizeof bytes);
    block = __builtin_convertvector(bytes, BlockHalves);
}

[[gnu::always_inline]] inline std::uint32_t packed(Halves channels) {
    const auto bytes = __builtin_convertvector(channels, Bytes8);
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, &bytes, sizeof pixel);
    return pixel;
}

// share: of 256.
[[gnu::always_inline]] inline Halves mixed(Halves a, Halves b, int share) {
    const auto of_b = static_cast<std::uint16_t>(share);
    const auto of_a = static_cast<std::uint16_t>(256 - share);
    return (a * of_a + b * of_b + 128) >> 8;
}

[[gnu::always_inline]] inline int part_of_256(float share) {
    return static_cast<int>(std::clamp(share, 0.0F, 1.0F) * 256.0F + 0.5F);
}

// A pixel that may lie beside the photograph: mirrored() and left_beside() of shaders/plate_edge.glsl.
struct Beside {
    int u = 0;
    int v = 0;
    float left = 1.0F;
};
inline Beside beside(const HostPhotograph& photograph, float u, float v) {
    constexpr float kPerWidth = 1.0F / 0.06F;
    float square = 0.0F;
    const auto along = [&](float texel, int texels) {
        const auto size = static_cast<float>(texels);
        const float at = std::clamp((texel + 0.5F) / size, -1.0F, 2.0F);
        const float out = std::max(std::abs(at - 0.5F) - 0.5F, 0.0F) * kPerWidth;
        square += out * out;
        const float mirrored = 1.0F - std::abs(1.0F - std::abs(at));
        return fixed(std::clamp(mirrored * size - 0.5F, 0.0F, size - 1.0F));
    };
    Beside found;
    found.u = along(u, photograph.width());
    found.v = along(v, photograph.height());
    found.left = 1.0F / (1.0F + square);
    return found;
}

// Where a row begins in a photograph that it goes through a texel a pixel, sixteen bits behind the point.
struct FixedPlace {
    int u;
    int v;
};

[[gnu::always_inline]] inline void make_block(const std::uint32_t* texels, std::ptrdiff_t across,
                                              const FixedPlace& place, BlockHalves& block) {
    const std::uint32_t* const at = texels + (place.v >> 16) * across + (place.u >> 16);
    BlockHalves right;
    BlockHalves below;
    read_block(at, block);
    read_block(at + across, below);
    go_towards(block, below, place.v);
    read_block(at + 1, right);
    read_block(at + across + 1, below);
    go_towards(right, below, place.v);
    go_towards(block, right, place.u);
}

[[gnu::always_inline]] inline void put_block(const BlockHalves& block, std::uint32_t* pixels, int count) {
    const auto bytes = __builtin_convertvector(block, Bytes);
    if (count >= kBlock) {
        std::memcpy(pixels, &bytes, sizeof bytes);
        return;
    }
    // Sizes that are known are an instruction each.
    const auto words = std::bit_cast<Longs>(bytes);
    std::uint64_t rest = words[0];
    if (count >= 2) {
        std::memcpy(pixels, &rest, sizeof rest);
        rest = words[1];
        pixels += 2;
    }
    if (count % 2 == 1) std::memcpy(pixels, &rest, sizeof *pixels);
}

// A row of pixels that lies in the photograph, a texel a pixel.
[[gnu::always_inline]] inline void take_as_it_is(const HostPhotograph& photograph, const FixedPlace& first,
                                                 std::uint32_t* pixels, int count) {
    for (int i = 0; i < count; i += kBlock) {
        BlockHalves block;
        make_block(photograph.first(), photograph.width(), {first.u + i * kOne, first.v}, block);
        put_block(block, pixels + i, count - i);
    }
}

// A row of pixels, however long it is in the photograph and wherever it lies.
[[gnu::always_inline]] inline void take_stretched(const HostPhotograph& photograph, const Place& place,
                                                  std::uint32_t* pixels, int count) {
    const std::uint32_t* const texels = photograph.first();
    const std::ptrdiff_t across = photograph.width();
    if (!lies_in(photograph, place, count)) {
        for (int i = 0; i < count; ++i) {
            const Beside at = beside(photograph, place.u.at(i), place.v.at(i));
            const Halves texel = texel_at(texels, across, at.u, at.v);
            pixels[i] = packed(mixed(Halves{}, texel, part_of_256(at.left))) | 0xFF000000U;
        }
        return;
    }
    int u = fixed(place.u.first);
    int v = fixed(place.v.first);
    const int u_step = fixed(place.u.step);
    const int v_step = fixed(place.v.step);
    for (int i = 0; i < count; ++i, u += u_step, v += v_step)
        pixels[i] = packed(texel_at(texels, across, u, v));
}

}  // namespace onggi::render::rows
