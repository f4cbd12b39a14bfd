#include "engine/render/pixels/photograph_layers.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/math/wide_vectors.h"
#include "engine/render/pixels/mix_pixels.h"
#include "engine/render/pixels/picture_shapes.h"
#include "shaders/background_edge.h"

namespace onggi::render {
namespace {

using shapes::fixed;
using shapes::kOne;
using shapes::Slope;

// Pixels of a row, from column `first` to before `end`; and scratch memory for a row of a photograph, plus
// one texel.
struct RowPart {
    const PhotographedRoom& room;
    int row = 0;
    std::size_t first = 0;
    std::size_t end = 0;
    std::span<std::uint32_t> mixed;
};

std::uint32_t part_of(int place) {
    return static_cast<std::uint32_t>(place) >> 8U & 255U;
}

// A position along a photograph's width or height in 16.16 fixed point, mirrored outside as in
// shaders/background_edge.h, and the distance outside.
struct Along {
    int at = 0;
    float out = 0.0F;
};
[[gnu::always_inline]] inline Along along(float texel, int texels) {
    const auto size = static_cast<float>(texels);
    if (texel >= 0.0F && texel <= size - 1.0F) return {fixed(texel), 0.0F};
    const float at = std::clamp((texel + 0.5F) / size, -1.0F, 2.0F);
    return {fixed(std::clamp(shaders::mirrored(at) * size - 0.5F, 0.0F, size - 1.0F)), shaders::beside(at)};
}

// Takes a row of a photograph at one texel per pixel, from this position on.
[[gnu::always_inline]] inline void take_as_it_is(const std::uint32_t* texels, int at, std::size_t count,
                                                 std::uint32_t* pixels) {
    const std::uint32_t* const first = texels + (at >> 16);
    const std::uint32_t part = part_of(at);
    if (part == 0) {
        std::copy_n(first, count, pixels);
        return;
    }
    for (std::size_t i = 0; i < count; ++i)
        pixels[i] = mix_words(first[i], first[i + 1], part);
}

[[gnu::always_inline]] inline void take_stretched(const std::uint32_t* texels, int at, int step,
                                                  std::size_t count, std::uint32_t* pixels) {
    for (std::size_t i = 0; i < count; ++i, at += step)
        pixels[i] = mix_words(texels[at >> 16], texels[(at >> 16) + 1], part_of(at));
}

// Takes pixels that are, or may be, outside the photograph. `out`: the row's own distance outside.
[[gnu::always_inline]] inline void take_beside(const std::uint32_t* texels, int across, const Slope& u,
                                               int begin, float out, std::size_t count,
                                               std::uint32_t* pixels) {
    for (std::size_t i = 0; i < count; ++i) {
        const Along place = along(u.at(begin + static_cast<int>(i)), across);
        const std::uint32_t texel =
            mix_words(texels[place.at >> 16], texels[(place.at >> 16) + 1], part_of(place.at));
        const float left = shaders::left_beside(place.out, out);
        pixels[i] = mix_words(0U, texel, static_cast<std::uint32_t>(left * 256.0F + 0.5F)) | 0xFF000000U;
    }
}

// Takes the part of a row: interpolated vertically in the photograph, then horizontally. A pixel's bits do
// not depend on the part.
[[gnu::always_inline]] inline void take_part(const HostPhotograph& photograph, const RowPart& part,
                                             std::uint32_t* pixels) {
    // Short enough for fixed-point steps to stay accurate. Pieces begin at multiples of it.
    constexpr std::size_t kPiece = 256;
    constexpr float kAlike = 1.0F / 65536.0F;
    const int across = photograph.width();
    const vec4& window = part.room.window;
    const auto width = static_cast<float>(across);
    const float down = (static_cast<float>(part.row) + 0.5F) * window.y + window.w;
    const Along v = along(down * static_cast<float>(photograph.height()) - 0.5F, photograph.height());
    const std::uint32_t* const row = photograph.first() + (v.at >> 16) * std::ptrdiff_t{across};
    const auto mix_texels = [&](std::size_t from, std::size_t to) __attribute__((always_inline)) {
        for (std::size_t i = from; i <= to; ++i)
            part.mixed[i] = mix_words(row[i], row[i + static_cast<std::size_t>(across)], part_of(v.at));
    };
    const Slope whole{(0.5F * window.x + window.z) * width - 0.5F, window.x * width};
    const auto picture_width = static_cast<std::size_t>(part.room.width_px);
    const bool is_a_row = part_of(v.at) == 0;
    const std::uint32_t* const texels = is_a_row ? row : part.mixed.data();
    bool has_all = is_a_row;
    for (std::size_t piece = part.first / kPiece * kPiece; piece < part.end; piece += kPiece) {
        const int last = static_cast<int>(std::min(kPiece, picture_width - piece)) - 1;
        const Slope u{whole.at(static_cast<int>(piece)), whole.step};
        const std::size_t begin = std::max(piece, part.first) - piece;
        const std::size_t count = std::min(piece + kPiece, part.end) - piece - begin;
        std::uint32_t* const into = pixels + (piece + begin - part.first);
        // The fringe allows for rounding at the border.
        constexpr float kFringe = 1.0F / 256.0F;
        const bool is_inside = v.out == 0.0F && u.first >= -kFringe && u.at(last) <= width - 1.0F + kFringe;
        if (!is_inside) {
            if (!has_all) mix_texels(0, static_cast<std::size_t>(across));
            has_all = true;
            take_beside(texels, across, u, static_cast<int>(begin), v.out, count, into);
            continue;
        }
        const int step = std::abs(u.step - 1.0F) <= kAlike ? kOne : fixed(u.step);
        const int at = fixed(std::max(u.first, 0.0F)) + static_cast<int>(begin) * step;
        const int end = at + static_cast<int>(count - 1) * step;
        if (!has_all) mix_texels(static_cast<std::size_t>(at >> 16), static_cast<std::size_t>(end >> 16) + 1);
        if (step == kOne) {
            take_as_it_is(texels, at, count, into);
        } else {
            take_stretched(texels, at, step, count, into);
        }
    }
}

ONGGI_WIDE_VECTORS void lay(const RowPart& part, std::uint32_t* with_key, std::uint32_t* without_key,
                            std::uint32_t* unlit) {
    take_part(part.room.photographs->key, part, with_key);
    take_part(part.room.photographs->ambient, part, unlit);
    for (std::size_t i = 0; i < part.end - part.first; ++i) {
        constexpr std::uint32_t kColours = 0x00FFFFFFU;
        without_key[i] = (without_key[i] & ~kColours) | (unlit[i] & kColours);
        // Compression may leave the lit photograph darker by one level.
        std::uint32_t lit = 0xFF000000U;
        for (std::uint32_t shift = 0; shift < 24U; shift += 8U) {
            const std::uint32_t channel = 0xFFU << shift;
            lit |= std::max(with_key[i] & channel, unlit[i] & channel);
        }
        with_key[i] = lit;
    }
}

}  // namespace

void lay_photographs(const PhotographedRoom& room, int row, int first, std::span<std::uint32_t> with_key,
                     std::span<std::uint32_t> without_key) {
    // Reused: shading asks for many short parts.
    thread_local std::vector<std::uint32_t> scratch;
    const auto texels = static_cast<std::size_t>(room.photographs->key.width()) + 1;
    scratch.resize(std::max(scratch.size(), texels + with_key.size()));
    const auto begin = static_cast<std::size_t>(first);
    lay({.room = room,
         .row = row,
         .first = begin,
         .end = begin + with_key.size(),
         .mixed = std::span(scratch).first(texels)},
        with_key.data(), without_key.data(), scratch.data() + texels);
}

}  // namespace onggi::render
