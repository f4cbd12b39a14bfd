// Projects and lights the vertices of hands and tools for the CPU backend: the vertex lighting of
// shaders/prop.vert. Any thread; pure. mm, pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/byte_order.h"
#include "engine/render/pixels/prop_pixels.h"
#include "engine/render/shapes/lathe_mesh.h"

namespace onggi::render {

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
