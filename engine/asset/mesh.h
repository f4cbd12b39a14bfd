// Triangles in memory, as the writers take them. Plain data, any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/math/math.h"

namespace onggi::asset {

// Metres, right-handed, +Y up. Three indices a triangle, counter-clockwise seen from outside. One unit normal
// a vertex; where a surface has an edge, the vertex stands there once for each side.
struct Mesh {
    std::vector<vec3> positions_m;
    std::vector<vec3> normals;
    std::vector<std::uint32_t> indices;

    [[nodiscard]] std::size_t triangle_count() const { return indices.size() / 3; }
};

}  // namespace onggi::asset
