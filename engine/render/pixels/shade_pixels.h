// Applies shade and light levels to the kept still life on the processor: on a software device, a shader
// would pay fifty nanoseconds per pixel for its four textures. Any thread; pure.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/render/pixels/photograph_layers.h"
#include "engine/render/pixels/shadow_mask.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// The layers of a still life in full light; texels of four bytes, rows of `width` without gaps: with the key
// light; without it (alpha: the weight of the sky's shade); and each pixel's place in the shadow mask. Of a
// photographed room the first two are not kept: they are taken from the photographs where they are needed,
// and the weight of the sky's shade has a layer of its own.
struct ShadeLayers {
    int width = 0;
    int height = 0;
    std::span<const std::uint32_t> with_key;
    std::span<const std::uint32_t> without_key;
    std::span<const std::uint32_t> places;  // see mask_place()
    PhotographedRoom room{};                // without photographs: the layers are kept
    std::span<const std::uint8_t> weights{};
};

// Light levels, 1: full light. `ambient` is everything except the key light, in the byte order of a texel.
struct ShadeLight {
    std::array<float, 3> ambient{1.0F, 1.0F, 1.0F};
    float key = 1.0F;

    friend bool operator==(const ShadeLight&, const ShadeLight&) = default;
};

// Converts the two 16-bit numbers of a coordinate texel (shaders/packed.glsl) to the form that the shading
// reads a million times a second: the mask texel's index, and in the low bytes the fractions to the next
// texel, across and down.
[[nodiscard]] std::uint32_t mask_place(std::uint32_t packed_coords);
// Converts a whole picture in place.
void turn_into_places(std::span<std::uint32_t> packed_coords);

constexpr int kShadeBlockPx = 16;  // pixels that are shaded side by side

// Writes the shaded picture to `into`, laid out like the layers, for the rectangles and possibly a few pixels
// beside them. The rectangles must be inside the picture. Bit-identical on every processor. Layers narrower
// than a block are copied unshaded.
void shade_pixels(const ShadeLayers& layers, const ShadowMask& mask, const ShadeLight& light,
                  std::span<const PixelRect> rects, std::span<std::uint32_t> into);

}  // namespace onggi::render
