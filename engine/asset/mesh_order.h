// The order in which a mesh's triangles and vertices lie in a file. Any thread; pure.
#pragma once

#include "engine/asset/mesh.h"

namespace onggi::asset {

// As a graphics device draws them quickest, and as they pack best: triangles near each other share
// vertices, and vertices come as they are first used. Nothing else changes. The same mesh gives the same
// order (meshoptimizer).
void order_for_drawing(Mesh& mesh);

}  // namespace onggi::asset
