// The smallest closed mesh, for tests of the writers.
#pragma once

#include "engine/asset/mesh.h"

namespace onggi::asset {

// A corner of a cube, 0.1 m along each axis: four vertices, four triangles, outward. The normals point away
// from the middle, which is smooth shading at its crudest.
inline Mesh tetrahedron() {
    Mesh mesh;
    mesh.positions_m = {vec3(0.0F, 0.0F, 0.0F), vec3(0.1F, 0.0F, 0.0F), vec3(0.0F, 0.1F, 0.0F),
                        vec3(0.0F, 0.0F, 0.1F)};
    for (const vec3& position : mesh.positions_m) {
        mesh.normals.push_back(glm::normalize(position - vec3(0.025F, 0.025F, 0.025F)));
    }
    mesh.indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    return mesh;
}

}  // namespace onggi::asset
