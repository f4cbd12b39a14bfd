// Rasterises hands and tools for the CPU backend: lavapipe would pay for every 4 x 4 block that a triangle
// touches, this code for little more than its pixels. Any thread; one user of a canvas at a time. Pixels, mm.
#pragma once

#include <cstdint>
#include <span>

#include "engine/render/pixels/picture_shapes.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// Values: three channels in the picture's byte order, 0 to 255.
using PropCorner = PictureCorner<3>;

// Draws triangles, three indices of corners each, with a depth test (nearer passes). Triangles with a corner
// behind the eye are skipped. The result is bit-identical with and without wide vectors. A canvas of fewer
// than eight pixels is left unchanged.
void draw_triangles(std::span<const PropCorner> corners, std::span<const std::uint32_t> indices,
                    const PictureCanvas& canvas);

// Marks the tiles that the triangles may touch.
void want_triangles(std::span<const PropCorner> corners, std::span<const std::uint32_t> indices,
                    const TileGrid& grid, std::span<std::uint8_t> wanted);

}  // namespace onggi::render
