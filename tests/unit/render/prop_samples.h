// Props for the tests of how they are drawn.
#pragma once

#include "engine/render/profile_mesh.h"
#include "engine/render/prop.h"

namespace onggi::render {

inline PropMesh ball(float radius_mm, int rings, int sectors) {
    const Mesh sphere = sphere_mesh(rings, sectors);
    PropMesh mesh;
    for (const Mesh::Vertex& vertex : sphere.vertices)
        mesh.vertices.push_back({.position_mm = radius_mm * vertex.position_mm, .normal = vertex.normal});
    mesh.indices = sphere.indices;
    return mesh;
}

}  // namespace onggi::render
