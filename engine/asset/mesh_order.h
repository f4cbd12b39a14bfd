// Reorders a mesh's triangles and vertices. Any thread; pure.
#pragma once

#include "engine/asset/mesh.h"

namespace onggi::asset {

// Optimises the order for a GPU's vertex cache and for compression: consecutive triangles share vertices, and
// vertices are in order of first use. Nothing else changes. Deterministic (meshoptimizer).
void order_for_drawing(Mesh& mesh);

}  // namespace onggi::asset
