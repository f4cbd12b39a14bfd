// The faces of a wall that has been cut open: what lies between outside and inside where the cut goes through
// it, on both sides of the axis. Any thread; a pure function. mm.
#pragma once

#include <vector>

#include "engine/render/shapes/lathe_vertices.h"

namespace onggi::render {

constexpr std::size_t kMaxSectionVertices = 4096;

// Appends triangles, three vertices each, to a cut lathe's `vertices`: place.xyz in the world; lean.x how far
// from the axis, left negative; lean.y load; lean.z 0 on the outer face to 1 on the inner one. Says how many.
std::size_t add_section(const LatheMeshInput& input, int sectors, std::vector<shaders::VertexData>& vertices);

}  // namespace onggi::render
