#include "game/wheel/tool_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>
#include <string>
#include <utility>

#include "engine/asset/gltf_read.h"
#include "engine/asset/mesh_order.h"
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

// Whether the colour changes across a triangle as at a nail or in a fold.
bool shows_detail(const render::PropMesh& mesh, std::span<const std::uint32_t> corners) {
    constexpr int kToneSteps = 24;
    constexpr int kSmearSteps = 120;
    const auto changes = [&](auto value, int steps) {
        const auto [least, most] =
            std::minmax({value(mesh.vertices[corners[0]]), value(mesh.vertices[corners[1]]),
                         value(mesh.vertices[corners[2]])});
        return most - least > steps;
    };
    using Vertex = render::PropMesh::Vertex;
    return changes([](const Vertex& vertex) { return int{vertex.tone}; }, kToneSteps) ||
           changes([](const Vertex& vertex) { return int{vertex.smear}; }, kSmearSteps);
}

// The mesh with little more than half of its triangles, and the vertices that these use. Nails and folds stay
// as they are.
render::PropMesh thinned(const render::PropMesh& mesh) {
    constexpr double kFraction = 0.5;  // of the rest
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> plain;
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        const std::span<const std::uint32_t> corners = std::span(mesh.indices).subspan(first, 3);
        std::vector<std::uint32_t>& into = shows_detail(mesh, corners) ? indices : plain;
        into.insert(into.end(), corners.begin(), corners.end());
    }
    std::vector<vec3> positions;
    positions.reserve(mesh.vertices.size());
    for (const render::PropMesh::Vertex& vertex : mesh.vertices)
        positions.push_back(vertex.position_mm);
    const std::vector<std::uint32_t> rest = asset::thinned(positions, plain, kFraction);
    indices.insert(indices.end(), rest.begin(), rest.end());
    render::PropMesh thin;
    thin.albedo = mesh.albedo;
    thin.roughness = mesh.roughness;
    thin.metalness = mesh.metalness;
    constexpr std::uint32_t kUnused = ~0U;
    std::vector<std::uint32_t> places(mesh.vertices.size(), kUnused);
    for (const std::uint32_t index : indices) {
        if (places[index] == kUnused) {
            places[index] = static_cast<std::uint32_t>(thin.vertices.size());
            thin.vertices.push_back(mesh.vertices[index]);
        }
        thin.indices.push_back(places[index]);
    }
    return thin;
}

render::PropModel thinned(const render::PropModel& model) {
    constexpr std::size_t kFew = 1000;  // triangles: a sleeve's, whose folds and edge need them all
    render::PropModel thin;
    for (const render::PropMesh& mesh : model.meshes)
        thin.meshes.push_back(mesh.indices.size() / 3 < kFew ? mesh : thinned(mesh));
    render::measure(thin);
    return thin;
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

render::PropMesh ball_mesh(float radius_mm, int rings, int sectors) {
    const render::Mesh sphere = render::sphere_mesh(rings, sectors);
    render::PropMesh mesh;
    mesh.indices = sphere.indices;
    for (const render::Mesh::Vertex& vertex : sphere.vertices)
        mesh.vertices.push_back({.position_mm = radius_mm * vertex.position_mm, .normal = vertex.normal});
    return mesh;
}

render::PropModel model_of(render::PropMesh mesh) {
    render::PropModel model;
    model.meshes.push_back(std::move(mesh));
    render::measure(model);
    return model;
}

render::PropModel wooden_ball() {
    render::PropMesh mesh = ball_mesh(kBallRadiusMm, 36, 60);
    mesh.albedo = vec3(0.56F, 0.37F, 0.19F);
    mesh.roughness = 0.28F;
    return model_of(std::move(mesh));
}

render::PropModel drop() {
    constexpr float kRadiusMm = 1.6F;
    render::PropMesh mesh = ball_mesh(kRadiusMm, 6, 8);
    for (render::PropMesh::Vertex& vertex : mesh.vertices)
        vertex.smear = 255;
    return model_of(std::move(mesh));
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
    return model_of(std::move(mesh));
}

// A streak of slip on the wheel head. Angles counter-clockwise from above, rad.
struct Streak {
    float from_rad = 0.0F;
    float turns_rad = 0.0F;
    float from_mm = 0.0F;  // distance of its middle from the axis
    float to_mm = 0.0F;
    float wide_mm = 0.0F;
    float high_mm = 0.0F;
};

// A bead with tapered ends and an uneven width: two edges on the metal and a crest between them.
void add_streak(render::PropMesh& mesh, const Streak& streak) {
    constexpr float kStepMm = 11.0F;
    constexpr float kEdgeMm = 0.15F;  // above the head, so that the edges win over it in the depth test
    constexpr int kThinEdge = 0;      // the head shows through
    const float length_mm = 0.5F * (streak.from_mm + streak.to_mm) * std::abs(streak.turns_rad);
    const auto steps = static_cast<std::uint32_t>(std::max(6.0F, length_mm / kStepMm));
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t step = 0; step <= steps; ++step) {
        const float along = static_cast<float>(step) / static_cast<float>(steps);
        const float angle = streak.from_rad + streak.turns_rad * along;
        // An ellipse's outline for a drop; a long streak is even but for its ends.
        const float from_end_mm = length_mm * std::min(along, 1.0F - along);
        const float to_end = std::min(from_end_mm / std::min(0.5F * length_mm, 30.0F), 1.0F);
        const float taper = std::sqrt(to_end * (2.0F - to_end));
        const float uneven = 1.0F + 0.35F * std::sin(9.0F * angle + streak.from_mm);
        const float half_mm = 0.5F * streak.wide_mm * taper * uneven;
        const vec3 out(std::cos(angle), 0.0F, -std::sin(angle));
        for (const float side : {-1.0F, 0.0F, 1.0F}) {
            const float radius_mm = glm::mix(streak.from_mm, streak.to_mm, along) + side * half_mm;
            const float y_mm = side == 0.0F ? kEdgeMm + streak.high_mm * taper : kEdgeMm;
            mesh.vertices.push_back({.position_mm = radius_mm * out + vec3(0.0F, y_mm, 0.0F),
                                     .normal = glm::normalize(vec3(0.0F, 1.0F, 0.0F) + 0.25F * side * out),
                                     .smear = static_cast<std::uint8_t>(side == 0.0F ? 255 : kThinEdge)});
        }
    }
    for (std::uint32_t row = first; row < first + 3 * steps; row += 3) {
        for (const std::uint32_t at : {row, row + 1}) {
            // Seen from above, the next row lies counter-clockwise of this one, or clockwise of it.
            const bool ahead = streak.turns_rad > 0.0F;
            const std::uint32_t a = ahead ? at + 1 : at + 3;
            const std::uint32_t b = ahead ? at + 3 : at + 1;
            mesh.indices.insert(mesh.indices.end(), {at, a, b, at + 4, b, a});
        }
    }
}

// Slip on the wheel head: the spiral that a finger leaves that moves outwards, and drops that the turning
// drew out.
render::PropModel slip() {
    constexpr int kDrops = 14;
    constexpr float kNearMm = 78.0F;
    constexpr float kFarMm = 142.0F;
    std::minstd_rand chance(11);
    const auto any = [&](float least, float most) {
        return std::uniform_real_distribution<float>(least, most)(chance);
    };
    render::PropMesh mesh;
    mesh.albedo = vec3(0.11F, 0.098F, 0.082F);  // of the photographed head
    add_streak(
        mesh,
        {.turns_rad = -1.3F * kTurnF, .from_mm = kNearMm, .to_mm = 132.0F, .wide_mm = 7.0F, .high_mm = 0.9F});
    for (int drop = 0; drop < kDrops; ++drop) {
        const float radius_mm = any(kNearMm, kFarMm);
        const float long_mm = any(2.0F, 6.0F) * any(2.0F, 5.0F);
        add_streak(mesh, {.from_rad = any(0.0F, kTurnF),
                          .turns_rad = -long_mm / radius_mm,
                          .from_mm = radius_mm,
                          .to_mm = std::min(radius_mm + 0.12F * long_mm, kFarMm),
                          .wide_mm = any(3.0F, 9.0F),
                          .high_mm = any(0.6F, 1.4F)});
    }
    return model_of(std::move(mesh));
}

}  // namespace

ToolModel model_at_scale(ToolModel model, double pixels_per_mm) {
    constexpr double kNearPxPerMm = 2.4;  // between the kiosk's pictures of 720 and of 1080 lines
    if (pixels_per_mm >= kNearPxPerMm) return model;
    if (model == ToolModel::kHandOuter) return ToolModel::kFarHandOuter;
    return model == ToolModel::kHandInner ? ToolModel::kFarHandInner : model;
}

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
    library->push_back(drop());
    library->push_back(slip());
    for (const ToolModel hand : {ToolModel::kHandOuter, ToolModel::kHandInner})
        library->push_back(thinned((*library)[library_place(hand, false)]));
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
