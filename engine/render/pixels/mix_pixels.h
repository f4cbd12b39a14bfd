// Blends two pictures. Any thread; pure. Pixels of four bytes.
#pragma once

#include <cstdint>
#include <span>

#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// Blends `to` over `from` with weight `fraction`, 0 to 1, in steps of 1/256, byte by byte in encoded values;
// inside a rectangle of pictures that are width_px wide. Bit-identical on every processor.
void mix_pixels(std::span<const std::uint32_t> from, std::span<const std::uint32_t> to, float fraction,
                const PixelRect& inside, int width_px, std::span<std::uint32_t> into);

}  // namespace onggi::render
