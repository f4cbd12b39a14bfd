// Hands and tools for the CPU backend: their vertices projected and lit (the vertex lighting of
// shaders/prop.vert), and their triangles rasterised: lavapipe would pay for every 4 x 4 block that a
// triangle touches, this code for little more than its pixels. Any thread; one user of a canvas at a time.
// Pixels, mm.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/byte_order.h"
#include "engine/render/pixels/picture_shapes.h"
#include "engine/render/shapes/lathe_mesh.h"
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

// Parameters of a frame. `samples`: the lathe's; its outside blocks the key light.
struct PropView {
    const shaders::FrameData& frame;
    const LatheSamples& samples;
    ByteOrder order = ByteOrder::kRedFirst;
};

// Appends one corner per vertex of a prop's mesh; only those that the triangles use are valid. Colours are
// encoded as by encode(). The result is bit-identical with and without wide vectors.
void light_corners(const PropMesh& mesh, std::span<const std::uint32_t> indices, const Prop& prop,
                   const PropView& view, std::vector<PropCorner>& corners);

}  // namespace onggi::render
