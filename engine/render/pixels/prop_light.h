// The corners of hands and tools, placed in the picture and lit: what shaders/prop.vert does where it lights
// vertices, for a device that is the processor. Any thread; pure. mm, pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/byte_order.h"
#include "engine/render/pixels/prop_pixels.h"
#include "engine/render/shapes/lathe_profile.h"

namespace onggi::render {

// What is the same for all of a frame. `samples` are of its lathe; their outside keeps the key light off.
struct PropView {
    const shaders::FrameData& frame;
    const LatheSamples& samples;
    ByteOrder order = ByteOrder::kRedFirst;
};

// Appends a corner for each vertex of one of the prop's meshes, of which those are good that these triangles
// need, with colours as encode() gives them. A processor without wider vectors finds the same
// bits.
void light_corners(const PropMesh& mesh, std::span<const std::uint32_t> indices, const Prop& prop,
                   const PropView& view, std::vector<PropCorner>& corners);

}  // namespace onggi::render
