// Outlines as the device draws them: a thin strip along each piece, wide enough for every pixel whose centre
// lies within half a pixel of the line, across it along the axis it is steeper to. Any thread; pure. Pixels.
#pragma once

#include <span>
#include <vector>

#include "engine/render/lathe_edges.h"

namespace onggi::render {

// A vertex of shaders/edges.vert.
struct StripCorner {
    vec3 at{0.0F};  // in the device's own coordinates
    vec4 line{0.0F};
};
constexpr std::size_t kStripCorners = 4;  // of a piece; two triangles, 0 1 2 and 2 1 3

// `corners` are used again.
void make_strips(std::span<const OutlinePiece> pieces, vec2 picture_px, std::vector<StripCorner>& corners);

}  // namespace onggi::render
