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
    // Of a mesh that wears pictures; else empty. Where a vertex lies in them: u to the right, v down, 0 to 1.
    std::vector<vec2> uvs{};
    // And the way u grows there, unit length, square to the normal; w: 1 if normal x tangent is the way up in
    // the pictures, else -1.
    std::vector<vec4> tangents{};

    [[nodiscard]] std::size_t triangle_count() const { return indices.size() / 3; }
};

}  // namespace onggi::asset
