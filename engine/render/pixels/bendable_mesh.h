// The meshes that stand for parts of a photographed room, as the processor bends photographs over them: cut
// so small that what a face shows grows evenly over it. Any thread; pure. mm.
#pragma once

#include <vector>

#include "engine/render/pixels/bend_pixels.h"
#include "engine/render/scene.h"

namespace onggi::render {

struct BendableMesh {
    std::vector<vec3> positions_mm;
    std::vector<float> normals_up;  // y of each one's normal
    std::vector<Corners> triangles;
};

// All parts that the plate's relief does not show well enough. No edge is longer than longest_mm.
[[nodiscard]] BendableMesh bendable_mesh(const StillLife& still_life, float longest_mm = 40.0F);

}  // namespace onggi::render
