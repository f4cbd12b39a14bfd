// A few pixels of a row out of photographs: the innermost loops of bend_pixels.cpp, in a file of their own
// and inline, so that they become a part of whatever instructions that is compiled for. Any thread; pure.
// Pixels, texels.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "engine/render/pixels/bend_pixels.h"

namespace onggi::render::bend {

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

[[gnu::always_inline]] inline Halves unpacked(std::uint32_t pixel) {
    Bytes8 bytes{};
    std::memcpy(&bytes, &pixel, sizeof pixel);
    return __builtin_convertvector(bytes, Halves);
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

// The same as a Place, sixteen bits behind the point.
struct FixedRow {
    int u;
    int u_step;
    int v;
    int v_step;

    [[nodiscard]] FixedRow later(int pixels) const {
        return {u + pixels * u_step, u_step, v + pixels * v_step, v_step};
    }
};

// So far from a texel a pixel, and from level, a row may go and still be made in blocks.
constexpr int kMostChange = kOne / 4;

// A block of a row that goes about a texel a pixel and almost level: as if it did so exactly, which in its
// outer pixels is wrong by less than two fifths of a pixel.
[[gnu::always_inline]] inline void make_block(const std::uint32_t* texels, std::ptrdiff_t across,
                                              const FixedRow& row, BlockHalves& block) {
    const int u = row.u + 3 * (row.u_step - kOne) / 2;
    const int v = row.v + 3 * row.v_step / 2;
    const std::uint32_t* const at = texels + (v >> 16) * across + (u >> 16);
    BlockHalves right;
    BlockHalves below;
    read_block(at, block);
    read_block(at + across, below);
    go_towards(block, below, v);
    read_block(at + 1, right);
    read_block(at + across + 1, below);
    go_towards(right, below, v);
    go_towards(block, right, u);
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

// What one photograph has for a row of pixels that lies in it.
[[gnu::always_inline]] inline void take_inside(const HostPhotograph& photograph, const FixedRow& row,
                                               std::uint32_t* pixels, int count) {
    const std::uint32_t* const texels = photograph.first();
    const std::ptrdiff_t across = photograph.width();
    for (int i = 0; i < count; i += kBlock) {
        BlockHalves block;
        make_block(texels, across, row.later(i), block);
        put_block(block, pixels + i, count - i);
    }
}

// Two of them, the second with a share of 65536.
[[gnu::always_inline]] inline void take_inside(const HostPhotograph& from, const FixedRow& from_row,
                                               const HostPhotograph& to, const FixedRow& to_row, int share,
                                               int share_step, std::uint32_t* pixels, int count) {
    for (int i = 0; i < count; i += kBlock) {
        BlockHalves block;
        BlockHalves second;
        make_block(from.first(), from.width(), from_row.later(i), block);
        make_block(to.first(), to.width(), to_row.later(i), second);
        go_towards(block, second, std::clamp(share + (i + kBlock / 2) * share_step, 0, kOne - 1));
        put_block(block, pixels + i, count - i);
    }
}

// What one photograph has for a row of pixels, wherever that lies.
[[gnu::always_inline]] inline void take_one(const HostPhotograph& photograph, const Place& place,
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

// Two photographs, the second with a share.
[[gnu::always_inline]] inline void take_both(const HostPhotograph& from, const Place& from_place,
                                             const HostPhotograph& to, const Place& to_place,
                                             const Slope& share, std::uint32_t* pixels, int count) {
    // So short that the rows are still at hand when they are mixed.
    constexpr int kMost = 64;
    std::array<std::uint32_t, kMost> second;
    for (int done = 0; done < count; done += kMost) {
        const int now = std::min(count - done, kMost);
        const auto later = [&](const Slope& slope) { return Slope{slope.at(done), slope.step}; };
        take_one(from, {later(from_place.u), later(from_place.v)}, pixels + done, now);
        take_one(to, {later(to_place.u), later(to_place.v)}, second.data(), now);
        for (int i = 0; i < now; ++i) {
            pixels[done + i] =
                packed(mixed(unpacked(pixels[done + i]), unpacked(second[static_cast<std::size_t>(i)]),
                             part_of_256(share.at(done + i))));
        }
    }
}

[[gnu::always_inline]] inline void dim(const std::array<std::array<std::uint8_t, 256>, 3>& tables,
                                       std::uint32_t* pixels, int count) {
    for (int i = 0; i < count; ++i) {
        const std::uint32_t pixel = pixels[i];
        pixels[i] = (pixel & 0xFF000000U) | static_cast<std::uint32_t>(tables[0][pixel & 255U]) |
                    static_cast<std::uint32_t>(tables[1][pixel >> 8U & 255U]) << 8U |
                    static_cast<std::uint32_t>(tables[2][pixel >> 16U & 255U]) << 16U;
    }
}

// Out on the deck the room without the key light is about this much darker, see glide.frag.
[[gnu::always_inline]] inline void shade_softly(const Slope& seen, ByteOrder order, std::uint32_t* pixels,
                                                int count) {
    constexpr std::array<float, 3> kWithoutKey{0.50F, 0.53F, 0.58F};
    for (int i = 0; i < count; ++i) {
        const float shade = 1.0F - std::clamp(seen.at(i), 0.0F, 1.0F);
        Halves left{};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const std::size_t named = order == ByteOrder::kRedFirst ? channel : 2 - channel;
            left[channel] = static_cast<std::uint16_t>(256.5F - 256.0F * shade * (1.0F - kWithoutKey[named]));
        }
        left[3] = 256;
        pixels[i] = packed((unpacked(pixels[i]) * left + 128) >> 8);
    }
}

}  // namespace onggi::render::bend
