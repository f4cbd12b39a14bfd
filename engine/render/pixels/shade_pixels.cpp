#include "engine/render/pixels/shade_pixels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

#include "engine/math/wide_vectors.h"
#include "shaders/curve.h"
#include "shaders/transfer.h"

namespace onggi::render {
namespace {

constexpr std::uint32_t kAcross = shaders::kMaskTexels;
constexpr std::size_t kBlock = kShadeBlockPx;

// Converts a 16-bit coordinate to a texel index and the fraction towards the next texel in 1/256. Coordinates
// in the outer half texels are clamped to the texels' centres.
[[gnu::always_inline]] inline std::uint32_t steps_of(std::uint32_t coordinate) {
    constexpr int kHalf = 128;
    constexpr int kMost = 256 * (static_cast<int>(kAcross) - 1) - 1;
    const int steps = static_cast<int>(coordinate * (256U * kAcross) / 65535U) - kHalf;
    return static_cast<std::uint32_t>(std::min(std::max(steps, 0), kMost));
}

[[gnu::always_inline]] inline std::uint32_t place_of(std::uint32_t packed_coords) {
    const std::uint32_t high_first =
        (packed_coords & 0x00FF00FFU) << 8U | (packed_coords >> 8U & 0x00FF00FFU);
    const std::uint32_t across = steps_of(high_first & 0xFFFFU);
    const std::uint32_t down = steps_of(high_first >> 16U);
    const std::uint32_t texel = (down >> 8U) * kAcross + (across >> 8U);
    return (texel << 16U) | ((down & 0xFFU) << 8U) | (across & 0xFFU);
}

// One part of each pixel of a block, as an array, so that the compiler vectorises every loop over a block.
template <typename T>
using Lanes = std::array<T, kBlock>;

// The four mask texels about each pixel: the left and right texel of a row in one word, each with key and sky
// in its two halves; and the fractions between them.
struct MaskAbout {
    Lanes<std::uint64_t> near;
    Lanes<std::uint64_t> far;
    Lanes<std::uint32_t> place;
};
static_assert(std::endian::native == std::endian::little);
[[gnu::always_inline]] inline std::uint32_t left_of(std::uint64_t texels) {
    return static_cast<std::uint32_t>(texels);
}
[[gnu::always_inline]] inline std::uint32_t right_of(std::uint64_t texels) {
    return static_cast<std::uint32_t>(texels >> 32U);
}

// Returns whether nothing in the block is in shade.
[[gnu::always_inline]] inline bool read_mask(const ShadowMask& mask, const std::uint32_t* places,
                                             MaskAbout& about) {
    constexpr std::uint64_t kBothUnshaded = std::uint64_t{kUnshaded} << 32U | kUnshaded;
    std::uint64_t all_of = kBothUnshaded;
    for (std::size_t i = 0; i < kBlock; ++i) {
        const std::uint32_t* const texel = mask.data() + (places[i] >> 16U);
        std::memcpy(&about.near[i], texel, sizeof about.near[i]);
        std::memcpy(&about.far[i], texel + kAcross, sizeof about.far[i]);
        all_of &= about.near[i] & about.far[i];
    }
    std::memcpy(about.place.data(), places, sizeof(about.place));
    return all_of == kBothUnshaded;
}

// Mixes both layers of one channel in linear light and encodes the result with the curve of shaders/curve.h:
// the light without the key times `ambient`, plus the key's own light (the difference of the layers) times
// `key`, all times `left`. The three fractions are merged into one: with a = A / (1 - .8 A), and b likewise,
// the light is (A (ambient - key)(1 - .8 B) + B key (1 - .8 A)) left over (1 - .8 A)(1 - .8 B).
[[gnu::always_inline]] inline std::uint32_t mix_lights(std::uint32_t without_key, std::uint32_t with_key,
                                                       float ambient, float key, float left) {
    constexpr float kOneOver255 = 1.0F / 255.0F;
    const float a = static_cast<float>(static_cast<int>(without_key & 0xFFU)) * kOneOver255;
    const float b = static_cast<float>(static_cast<int>(with_key & 0xFFU)) * kOneOver255;
    const float curve_a = shaders::untransferred(a);
    const float curve_b = shaders::untransferred(b);
    const float under_a = 1.0F - shaders::kCurveSlope * curve_a;
    const float under_b = 1.0F - shaders::kCurveSlope * curve_b;
    const float light = std::max(curve_a * under_b * (ambient - key) + curve_b * under_a * key, 0.0F) * left;
    const float shown = shaders::transferred(light / (light * shaders::kCurveSlope + under_a * under_b));
    return static_cast<std::uint32_t>(static_cast<int>(shown * 255.0F + 0.5F));
}

// Both layers from one pixel of a row on.
struct LayerRow {
    const std::uint32_t* with_key;
    const std::uint32_t* without_key;
};

[[gnu::always_inline]] inline void shade_block(const LayerRow& own, const std::uint32_t* places,
                                               const ShadowMask& mask, const ShadeLight& light, bool is_day,
                                               std::uint32_t* into) {
    constexpr float kOneOver255 = 1.0F / 255.0F;
    constexpr float kOneOverMixed = kOneOver255 / 65536.0F;
    MaskAbout about;
    const bool is_unshaded = read_mask(mask, places, about);
    if (is_unshaded && is_day) {
        std::memcpy(into, own.with_key, kBlock * sizeof(std::uint32_t));
        return;
    }
    Lanes<std::uint32_t> with_key;
    Lanes<std::uint32_t> without_key;
    std::memcpy(with_key.data(), own.with_key, sizeof(with_key));
    std::memcpy(without_key.data(), own.without_key, sizeof(without_key));
    Lanes<std::uint32_t> out;
    for (std::size_t i = 0; i < kBlock; ++i) {
        // The four texels interpolated, times 65536. This keeps full precision: where little is left of a
        // bright light, steps of 1/255 would be visible.
        const std::uint32_t across = about.place[i] & 0xFFU;
        const std::uint32_t down = (about.place[i] >> 8U) & 0xFFU;
        const std::uint32_t near_row =
            left_of(about.near[i]) * (256U - across) + right_of(about.near[i]) * across;
        const std::uint32_t far_row =
            left_of(about.far[i]) * (256U - across) + right_of(about.far[i]) * across;
        const std::uint32_t key = (near_row & 0xFFFFU) * (256U - down) + (far_row & 0xFFFFU) * down;
        const std::uint32_t sky = (near_row >> 16U) * (256U - down) + (far_row >> 16U) * down;
        const float fraction = static_cast<float>(static_cast<int>(key)) * kOneOverMixed * light.key;
        const float open = static_cast<float>(static_cast<int>(sky)) * kOneOverMixed;
        const float weight = static_cast<float>(static_cast<int>(without_key[i] >> 24U)) * kOneOver255;
        const float left = 1.0F + (open - 1.0F) * weight;
        std::uint32_t shaded = 0xFF000000U;
        for (std::uint32_t byte = 0; byte < 3U; ++byte) {
            const std::uint32_t shift = 8U * byte;
            shaded |=
                mix_lights(without_key[i] >> shift, with_key[i] >> shift, light.ambient[byte], fraction, left)
                << shift;
        }
        out[i] = shaded;
    }
    std::memcpy(into, out.data(), sizeof(out));
}

// Prefetches what a block reads and writes: rows of a picture are too far apart for the hardware prefetcher.
[[gnu::always_inline]] inline void fetch_block(const ShadeLayers& layers, std::size_t first,
                                               std::uint32_t* into) {
    __builtin_prefetch(layers.places.data() + first);
    if (layers.room.photographs == nullptr) {
        __builtin_prefetch(layers.with_key.data() + first);
        __builtin_prefetch(layers.without_key.data() + first);
    }
    __builtin_prefetch(into + first, 1);
}

// Scratch memory for part of a row of a photographed room's layers.
struct LaidRow {
    std::vector<std::uint32_t> with_key;
    std::vector<std::uint32_t> without_key;

    void resize(std::size_t pixels) {
        with_key.resize(pixels);
        without_key.resize(pixels);
    }
};

// The layers of a row from pixel `left` on, as many pixels as `laid` has room for.
LayerRow layer_row(const ShadeLayers& layers, int y, std::size_t left, LaidRow& laid) {
    const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(layers.width) + left;
    if (layers.room.photographs == nullptr)
        return {layers.with_key.data() + first, layers.without_key.data() + first};
    for (std::size_t i = 0; i < laid.without_key.size(); ++i)
        laid.without_key[i] = std::uint32_t{layers.weights[first + i]} << 24U;
    lay_photographs(layers.room, y, static_cast<int>(left), laid.with_key, laid.without_key);
    return {laid.with_key.data(), laid.without_key.data()};
}

// Shades whole blocks only: the last block of a line starts earlier, and a rectangle narrower than a block is
// shaded with its neighbours.
ONGGI_WIDE_VECTORS void shade_rect(const ShadeLayers& layers, const ShadowMask& mask, const ShadeLight& light,
                                   const PixelRect& rect, LaidRow& laid, std::uint32_t* into) {
    const bool is_day = light == ShadeLight{};
    const auto width = static_cast<std::size_t>(layers.width);
    const auto right = std::max(static_cast<std::size_t>(rect.x + rect.width), kBlock);
    const std::size_t left = std::min(static_cast<std::size_t>(rect.x), right - kBlock);
    const int bottom = rect.y + rect.height;
    laid.resize(right - left);
    for (int y = rect.y; y < bottom; ++y) {
        const LayerRow row = layer_row(layers, y, left, laid);
        const std::size_t begin = static_cast<std::size_t>(y) * width;
        for (std::size_t x = static_cast<std::size_t>(rect.x); x < right; x += kBlock) {
            const std::size_t at = std::min(x, right - kBlock);
            if (y + 1 < bottom) fetch_block(layers, begin + at + width, into);
            shade_block({row.with_key + (at - left), row.without_key + (at - left)},
                        layers.places.data() + begin + at, mask, light, is_day, into + begin + at);
        }
    }
}

}  // namespace

std::uint32_t mask_place(std::uint32_t packed_coords) {
    return place_of(packed_coords);
}

void turn_into_places(std::span<std::uint32_t> packed_coords) {
    for (std::uint32_t& coords : packed_coords)
        coords = place_of(coords);
}

void shade_pixels(const ShadeLayers& layers, const ShadowMask& mask, const ShadeLight& light,
                  std::span<const PixelRect> rects, std::span<std::uint32_t> into) {
    LaidRow laid;
    if (layers.width < kShadeBlockPx) {
        laid.resize(static_cast<std::size_t>(layers.width));
        for (int y = 0; y < layers.height; ++y)
            std::copy_n(layer_row(layers, y, 0, laid).with_key, layers.width,
                        into.begin() + y * layers.width);
        return;
    }
    for (const PixelRect& rect : rects)
        shade_rect(layers, mask, light, rect, laid, into.data());
}

}  // namespace onggi::render
