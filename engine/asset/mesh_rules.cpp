// See mesh_rules.h. Any thread.
#include "engine/asset/mesh_rules.h"

#include <fmt/format.h>

#include <cmath>

namespace onggi::asset {
namespace {

bool is_finite(const vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Result<void> check_material(const Material& material) {
    const auto within = [](double number) { return number >= 0.0 && number <= 1.0; };
    const dvec3& colour = material.base_colour_linear;
    if (within(colour.x) && within(colour.y) && within(colour.z) && within(material.roughness) &&
        within(material.metallic) && within(material.clearcoat.factor) &&
        within(material.clearcoat.roughness)) {
        return {};
    }
    return bad_input("material: expected colour, roughness, metallic and clearcoat within 0 to 1");
}

}  // namespace

Result<void> check_mesh(const Mesh& mesh) {
    const std::size_t vertices = mesh.positions_m.size();
    if (mesh.indices.empty()) return bad_input("mesh: expected at least one triangle, found none");
    if (mesh.indices.size() % 3 != 0) {
        return bad_input(
            fmt::format("mesh: expected three indices a triangle, found {} indices", mesh.indices.size()));
    }
    if (vertices > kMaxVertices || mesh.triangle_count() > kMaxTriangles) {
        return bad_input(fmt::format("mesh: expected at most {} vertices and {} triangles, found {} and {}",
                                     kMaxVertices, kMaxTriangles, vertices, mesh.triangle_count()));
    }
    if (mesh.normals.size() != vertices) {
        return bad_input(fmt::format("mesh: expected a normal for each of {} vertices, found {}", vertices,
                                     mesh.normals.size()));
    }
    if ((!mesh.uvs.empty() && mesh.uvs.size() != vertices) ||
        (!mesh.tangents.empty() && mesh.tangents.size() != vertices)) {
        return bad_input(fmt::format(
            "mesh: expected a place in the pictures and a tangent for each of {} vertices, found {} and {}",
            vertices, mesh.uvs.size(), mesh.tangents.size()));
    }
    for (std::size_t i = 0; i < vertices; ++i) {
        if (!is_finite(mesh.positions_m[i]) || !is_finite(mesh.normals[i])) {
            return bad_input(fmt::format("mesh: vertex {}: expected finite numbers", i));
        }
    }
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (mesh.indices[i] >= vertices) {
            return bad_input(fmt::format("mesh: triangle {}: expected an index below {}, found {}", i / 3,
                                         vertices, mesh.indices[i]));
        }
    }
    return {};
}

Result<void> check_content(const GltfContent& content) {
    if (auto good = check_mesh(content.mesh); !good) return good;
    if (content.material.textures.are_there() && content.mesh.uvs.empty())
        return bad_input("mesh: expected places in the material's pictures, found none");
    return check_material(content.material);
}

vec3 z_up_mm(const vec3& place_m) {
    constexpr float kMmPerMetre = 1000.0F;
    // Adding +0 turns -0 into +0 and changes nothing else.
    return kMmPerMetre * vec3(place_m.x, -place_m.z, place_m.y) + vec3(0.0F);
}

}  // namespace onggi::asset
