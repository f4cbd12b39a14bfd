// One picture mixed into another. Any thread; pure. Pixels of four bytes.
#pragma once

#include <cstdint>
#include <span>

#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// Of `to` as much as the fraction says, 0 to 1, in steps of 1/256, and of `from` the rest, byte by byte as
// they are shown; inside a rectangle of pictures whose rows are this wide. The same bits on every processor.
void mix_pixels(std::span<const std::uint32_t> from, std::span<const std::uint32_t> to, float fraction,
                const PixelRect& inside, int width_px, std::span<std::uint32_t> into);

}  // namespace onggi::render
