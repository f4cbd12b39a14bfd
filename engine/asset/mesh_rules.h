// What every mesh must keep before a writer takes it. Used inside engine/asset only.
#pragma once

#include "engine/asset/mesh.h"
#include "engine/core/result.h"

namespace onggi::asset {

// Far above any pot, and low enough that every length in a GLB and an STL header fits its 32 bits.
constexpr std::size_t kMaxVertices = std::size_t{1} << 24;
constexpr std::size_t kMaxTriangles = std::size_t{1} << 24;

// kBadInput naming the first rule that is broken: some triangles, whole ones, indices within the vertices, a
// normal for each vertex, finite numbers, sizes within the limits above.
Result<void> check_mesh(const Mesh& mesh);

// A place as printers want it: a quarter turn about X, so that a right-handed mesh stays right-handed and
// outside stays outside. No zero is negative.
[[nodiscard]] vec3 z_up_mm(const vec3& place_m);

}  // namespace onggi::asset
