// Triangles in memory, the input of the writers. Plain data, any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/math/math.h"

namespace onggi::asset {

// Metres, right-handed, +Y up. Three indices per triangle, counter-clockwise seen from outside. One unit
// normal per vertex; at a sharp edge vertices are duplicated for each side.
struct Mesh {
    std::vector<vec3> positions_m;
    std::vector<vec3> normals;
    std::vector<std::uint32_t> indices;
    // Texture coordinates, u to the right, v down, 0 to 1; empty for a mesh without textures.
    std::vector<vec2> uvs{};
    // The direction in which u grows, unit length, perpendicular to the normal; w: 1 if normal x tangent
    // points up in the texture, otherwise -1.
    std::vector<vec4> tangents{};

    [[nodiscard]] std::size_t triangle_count() const { return indices.size() / 3; }
};

}  // namespace onggi::asset
