// The shade over the kept still life, and the light of the hour, by the processor: a shader would pay fifty
// nanoseconds a pixel for its four textures where the device is the processor itself. Any thread; pure.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/render/pixels/shadow_mask.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// The layers of a still life by full light, texels of four bytes, rows of `width` without gaps: what it is
// with the key light, without it (alpha: how much of the sky's shade falls on it), and where each pixel lies
// in the mask.
struct ShadeLayers {
    int width = 0;
    int height = 0;
    std::span<const std::uint32_t> with_key;
    std::span<const std::uint32_t> without_key;
    std::span<const std::uint32_t> places;  // see mask_place()
};

// What there is of the light, 1: all of it. Of everything but the key by the bytes of a texel.
struct ShadeLight {
    std::array<float, 3> ambient{1.0F, 1.0F, 1.0F};
    float key = 1.0F;

    friend bool operator==(const ShadeLight&, const ShadeLight&) = default;
};

// From the two numbers of sixteen bits in a texel of the coordinates (shaders/packed.glsl) to what the shade
// reads a million times a second: the texel, and in its low bytes how far towards the next, across and down.
[[nodiscard]] std::uint32_t mask_place(std::uint32_t packed_coords);
// The same of a whole picture, in its place.
void turn_into_places(std::span<std::uint32_t> packed_coords);

constexpr int kShadeBlockPx = 16;  // pixels that are shaded side by side

// Writes the shaded picture inside the rectangles, which lie inside the picture, and
// here and there a few pixels beside one, to `into`, laid out as the layers are. The
// same bits on every processor. Layers that are narrower than a block are copied as they are: nobody sees
// what is in them.
void shade_pixels(const ShadeLayers& layers, const ShadowMask& mask, const ShadeLight& light,
                  std::span<const PixelRect> rects, std::span<std::uint32_t> into);

}  // namespace onggi::render
