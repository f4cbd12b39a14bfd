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

// Parameters and scratch memory of both layers.
struct Layers {
    vec4 window;
    std::size_t width = 0;
    RowSpan rows;
    std::uint32_t* with_key = nullptr;
    std::uint32_t* without_key = nullptr;
    std::uint32_t* unlit = nullptr;  // scratch: a row of the picture
    std::uint32_t* mixed = nullptr;  // scratch: a row of a photograph, plus one texel
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
                                               float out, std::size_t count, std::uint32_t* pixels) {
    for (std::size_t i = 0; i < count; ++i) {
        const Along place = along(u.at(static_cast<int>(i)), across);
        const std::uint32_t texel =
            mix_words(texels[place.at >> 16], texels[(place.at >> 16) + 1], part_of(place.at));
        const float left = shaders::left_beside(place.out, out);
        pixels[i] = mix_words(0U, texel, static_cast<std::uint32_t>(left * 256.0F + 0.5F)) | 0xFF000000U;
    }
}

// Takes a row of the picture: interpolated vertically in the photograph, then horizontally.
[[gnu::always_inline]] inline void take_row(const HostPhotograph& photograph, const Layers& layers, int y,
                                            std::uint32_t* pixels) {
    // Short enough for fixed-point steps to stay accurate.
    constexpr std::size_t kPiece = 256;
    constexpr float kAlike = 1.0F / 65536.0F;
    const int across = photograph.width();
    const auto texels_across = static_cast<std::size_t>(across);
    const vec4& window = layers.window;
    const auto width = static_cast<float>(across);
    const float down = (static_cast<float>(y) + 0.5F) * window.y + window.w;
    const Along v = along(down * static_cast<float>(photograph.height()) - 0.5F, photograph.height());
    const std::uint32_t* const row = photograph.first() + (v.at >> 16) * std::ptrdiff_t{across};
    const std::uint32_t part = part_of(v.at);
    for (std::size_t i = 0; i <= texels_across; ++i)
        layers.mixed[i] = mix_words(row[i], row[i + texels_across], part);

    const Slope whole{(0.5F * window.x + window.z) * width - 0.5F, window.x * width};
    for (std::size_t x = 0; x < layers.width; x += kPiece) {
        const std::size_t count = std::min(kPiece, layers.width - x);
        const Slope u{whole.at(static_cast<int>(x)), whole.step};
        // The fringe allows for rounding at the border.
        constexpr float kFringe = 1.0F / 256.0F;
        const bool is_inside = v.out == 0.0F && u.first >= -kFringe &&
                               u.at(static_cast<int>(count) - 1) <= width - 1.0F + kFringe;
        if (!is_inside) {
            take_beside(layers.mixed, across, u, v.out, count, pixels + x);
            continue;
        }
        const int at = fixed(std::max(u.first, 0.0F));
        if (std::abs(u.step - 1.0F) <= kAlike) {
            take_as_it_is(layers.mixed, at, count, pixels + x);
        } else {
            take_stretched(layers.mixed, at, fixed(u.step), count, pixels + x);
        }
    }
}

ONGGI_WIDE_VECTORS void lay(const HostBackground& background, const Layers& layers) {
    for (int y = layers.rows.first; y < layers.rows.end; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * layers.width;
        std::uint32_t* const with_key = layers.with_key + first;
        std::uint32_t* const without_key = layers.without_key + first;
        take_row(background.key, layers, y, with_key);
        take_row(background.ambient, layers, y, layers.unlit);
        for (std::size_t i = 0; i < layers.width; ++i) {
            constexpr std::uint32_t kColours = 0x00FFFFFFU;
            without_key[i] = (without_key[i] & ~kColours) | (layers.unlit[i] & kColours);
            // Compression may leave the lit photograph darker by one level.
            std::uint32_t lit = 0xFF000000U;
            for (std::uint32_t shift = 0; shift < 24U; shift += 8U) {
                const std::uint32_t channel = 0xFFU << shift;
                lit |= std::max(with_key[i] & channel, layers.unlit[i] & channel);
            }
            with_key[i] = lit;
        }
    }
}

}  // namespace

void lay_photographs(const HostBackground& background, vec4 window, int width, RowSpan rows,
                     std::span<std::uint32_t> with_key, std::span<std::uint32_t> without_key) {
    std::vector<std::uint32_t> unlit(static_cast<std::size_t>(width));
    std::vector<std::uint32_t> mixed(static_cast<std::size_t>(background.key.width()) + 1);
    lay(background, {.window = window,
                     .width = static_cast<std::size_t>(width),
                     .rows = rows,
                     .with_key = with_key.data(),
                     .without_key = without_key.data(),
                     .unlit = unlit.data(),
                     .mixed = mixed.data()});
}

}  // namespace onggi::render
