// Triangles of hands and tools by the processor, where that is the device: each would cost lavapipe as much
// as four pixels by four wherever it touches them, and this hardly more than its own pixels. Any thread; one
// user of a canvas at a time. Pixels, mm.
#pragma once

#include <cstdint>
#include <span>

#include "engine/render/pixels/picture_shapes.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// Its values are three channels in the picture's byte order, 0 to 255, spread evenly between the corners.
using PropCorner = PictureCorner<3>;

// Draws triangles, three indices of corners each, where nothing that is there is as near; those with a corner
// behind the eye are left out. A processor without wider vectors draws the same bits. A canvas of fewer than
// eight pixels stays as it is: nobody sees what is in it.
void draw_triangles(std::span<const PropCorner> corners, std::span<const std::uint32_t> indices,
                    const PictureCanvas& canvas);

// Wants the tiles in which they may be drawn.
void want_triangles(std::span<const PropCorner> corners, std::span<const std::uint32_t> indices,
                    const TileGrid& grid, std::span<std::uint8_t> wanted);

}  // namespace onggi::render
