// The rules that every writer checks a mesh against. Used inside engine/asset only.
#pragma once

#include "engine/asset/gltf.h"
#include "engine/core/result.h"

namespace onggi::asset {

// Far above any pot, and low enough that every size in a GLB and an STL header fits 32 bits.
constexpr std::size_t kMaxVertices = std::size_t{1} << 24;
constexpr std::size_t kMaxTriangles = std::size_t{1} << 24;

// Checks: at least one triangle, three indices per triangle, indices in range, a normal for each vertex,
// finite numbers, sizes within the limits above. Error: kBadInput, naming the first violation.
Result<void> check_mesh(const Mesh& mesh);

// The same for all that GLB and USDZ need: also colour and factors within 0 to 1, and texture coordinates
// where there are textures.
Result<void> check_content(const GltfContent& content);

// Converts a position to mm and +Z up by a quarter turn about X, which keeps a mesh right-handed and its
// faces outwards. Never returns -0.
[[nodiscard]] vec3 z_up_mm(const vec3& place_m);

}  // namespace onggi::asset
