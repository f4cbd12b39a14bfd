// Reorders a mesh's triangles and vertices, and thins them. Any thread; pure.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/asset/mesh.h"

namespace onggi::asset {

// Optimises the order for a GPU's vertex cache and for compression: consecutive triangles share vertices, and
// vertices are in order of first use. Nothing else changes. Deterministic (meshoptimizer).
void order_for_drawing(Mesh& mesh);

// Returns about `fraction` (0 to 1) of the triangles, three indices each, over a subset of the vertices:
// those that change the surface least (quadric error, meshoptimizer). Borders stay. Vertices at one place
// with different normals or colours stay together. Deterministic on one platform.
[[nodiscard]] std::vector<std::uint32_t> thinned(std::span<const vec3> positions,
                                                 std::span<const std::uint32_t> indices, double fraction);

}  // namespace onggi::asset
