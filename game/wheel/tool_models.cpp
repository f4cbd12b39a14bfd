#include "game/wheel/tool_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "engine/asset/gltf_read.h"
#include "engine/files/asset_folder.h"
#include "engine/files/read_file.h"
#include "engine/math/eight_bits.h"
#include "engine/render/profile_mesh.h"

namespace onggi::wheel {
namespace {

// A tool with more triangles would use up a software renderer's whole frame.
constexpr asset::GltfLimits kLimits{.max_bytes = std::size_t{4} << 20,
                                    .max_vertices = 20'000,
                                    .max_triangles = 20'000,
                                    .max_nodes = 64,
                                    .max_depth = 16};

render::PropMesh mesh_of(const asset::GltfPart& part, const asset::Material& material) {
    constexpr float kMmAMetre = 1000.0F;
    render::PropMesh mesh;
    for (std::size_t i = 0; i < part.mesh.positions_m.size(); ++i) {
        // Defaults without vertex colours: own tone, clean, unoccluded.
        const vec4 wear = part.colours.empty() ? vec4(0.5F, 0.0F, 0.0F, 1.0F) : part.colours[i];
        mesh.vertices.push_back({.position_mm = part.mesh.positions_m[i] * kMmAMetre,
                                 .normal = part.mesh.normals[i],
                                 .tone = eight_bits(wear.x),
                                 .smear = eight_bits(wear.y),
                                 .spare = 0,
                                 .open_sky = eight_bits(wear.w)});
    }
    mesh.indices = part.mesh.indices;
    mesh.albedo = vec3(material.base_colour_linear);
    mesh.roughness = std::max(static_cast<float>(material.roughness), 0.05F);
    mesh.metalness = static_cast<float>(material.metallic);
    return mesh;
}

// Mirrors in the plane z = 0: a right hand's tool becomes a left hand's.
render::PropModel mirrored(render::PropModel model) {
    for (render::PropMesh& mesh : model.meshes) {
        for (render::PropMesh::Vertex& vertex : mesh.vertices) {
            vertex.position_mm.z = -vertex.position_mm.z;
            vertex.normal.z = -vertex.normal.z;
        }
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
    render::measure(model);
    return model;
}

Result<render::PropModel> read_model(const std::filesystem::path& path) {
    const auto bytes = files::read_file(path, kLimits.max_bytes);
    if (!bytes) return bytes.error();
    const auto read = asset::decode_glb(std::as_bytes(std::span(*bytes)), path.string(), kLimits);
    if (!read) return read.error();
    render::PropModel model;
    const asset::Material plain{.name = "plain"};
    for (const asset::GltfPart& part : read->parts) {
        const bool has_material = part.material >= 0;
        model.meshes.push_back(
            mesh_of(part, has_material ? read->materials[static_cast<std::size_t>(part.material)] : plain));
    }
    render::measure(model);
    return model;
}

render::PropModel wooden_ball() {
    const render::Mesh sphere = render::sphere_mesh(36, 60);
    render::PropMesh mesh;
    mesh.albedo = vec3(0.56F, 0.37F, 0.19F);
    mesh.roughness = 0.28F;
    mesh.indices = sphere.indices;
    for (const render::Mesh::Vertex& vertex : sphere.vertices)
        mesh.vertices.push_back({.position_mm = kBallRadiusMm * vertex.position_mm, .normal = vertex.normal});
    render::PropModel model;
    model.meshes.push_back(std::move(mesh));
    render::measure(model);
    return model;
}

// A ribbon of clay coiled twice, with both faces.
render::PropModel curl() {
    constexpr int kSteps = 26;
    constexpr float kTurns = 2.0F;
    constexpr float kWideMm = 5.0F;
    constexpr float kAdvanceMm = 11.0F;  // along the axis, over all turns
    constexpr float kFirstMm = 4.4F;     // radius, which decreases
    constexpr float kLastMm = 2.8F;
    render::PropMesh mesh;
    for (const float face : {1.0F, -1.0F}) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int step = 0; step <= kSteps; ++step) {
            const float along = static_cast<float>(step) / kSteps;
            const float angle = kTurnF * kTurns * along;
            const vec3 out(0.0F, std::cos(angle), std::sin(angle));
            for (const float edge : {-0.5F, 0.5F}) {
                const vec3 at = glm::mix(kFirstMm, kLastMm, along) * out +
                                vec3(kAdvanceMm * (along - 0.5F) + kWideMm * edge, 0.0F, 0.0F);
                mesh.vertices.push_back({.position_mm = at, .normal = face * out, .smear = 255});
            }
        }
        for (std::uint32_t quad = first; quad < first + 2 * kSteps; quad += 2) {
            const std::array<std::uint32_t, 6> outside{quad,     quad + 2, quad + 1,
                                                       quad + 1, quad + 2, quad + 3};
            for (std::size_t i = 0; i < outside.size(); i += 3) {
                mesh.indices.push_back(outside[i]);
                mesh.indices.push_back(outside[i + (face > 0.0F ? 1 : 2)]);
                mesh.indices.push_back(outside[i + (face > 0.0F ? 2 : 1)]);
            }
        }
    }
    render::PropModel model;
    model.meshes.push_back(std::move(mesh));
    render::measure(model);
    return model;
}

}  // namespace

std::shared_ptr<const render::PropLibrary> ball_alone() {
    return std::make_shared<const render::PropLibrary>(render::PropLibrary{wooden_ball()});
}

Result<std::shared_ptr<const render::PropLibrary>> load_tool_models(const std::filesystem::path& folder) {
    auto library = std::make_shared<render::PropLibrary>(*ball_alone());
    for (const char* file : kToolFiles) {
        auto model = read_model(folder / (std::string(file) + ".glb"));
        if (!model) return model.error();
        library->push_back(std::move(*model));
    }
    library->push_back(curl());
    for (std::size_t i = 0; i < kToolModels; ++i)
        library->push_back(mirrored((*library)[i]));
    return std::shared_ptr<const render::PropLibrary>(std::move(library));
}

Result<std::shared_ptr<const render::PropLibrary>> load_tool_models() {
    const auto folder = files::find_asset("tools");
    if (!folder) return folder.error();
    return load_tool_models(*folder);
}

}  // namespace onggi::wheel
