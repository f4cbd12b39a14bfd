// Where the corners of a bent photograph come to lie, in the picture and in the photographs: what
// shaders/glide.vert does. Any thread; pure. mm, pixels, texels.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/pixels/bend_pixels.h"
#include "engine/render/pixels/bendable_mesh.h"
#include "engine/render/scene.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// From where the room is seen, and from where it was photographed.
struct BendView {
    const shaders::FrameData& frame;
    const Plate& from;
    const Plate& to;
    const ShadowMask& mask;
    float scale = 1.0F;  // of the bent picture to the frame, and of its photographs to the plates
};

// Of a relief's points.
void bend_corners(std::span<const vec3> positions_mm, const BendView& view,
                  std::vector<ReliefCorner>& corners);
// Of a mesh.
void bend_corners(const BendableMesh& mesh, const BendView& view, std::vector<SurfaceCorner>& corners);

// A relief's cells in the order they are drawn in, the farthest first. Those before `behind` are not
// wholly in front of all meshes, the nearest of whose corners is `nearest_mm` away.
struct ReliefOrder {
    std::vector<Quad> quads;
    std::size_t behind = 0;
};
void order_relief(std::span<const Quad> cells, std::span<const ReliefCorner> corners, float nearest_mm,
                  ReliefOrder& order);

}  // namespace onggi::render
