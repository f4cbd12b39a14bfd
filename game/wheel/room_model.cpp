#include "game/wheel/room_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "engine/asset/gltf_read.h"
#include "engine/core/quote.h"
#include "engine/files/read_file.h"

namespace onggi::wheel {
namespace {

constexpr std::size_t kMostBytes = std::size_t{128} << 20;
// A larger part is a wall or a table: drawn from both sides, and too large for the single shadow map.
constexpr float kThingMm = 1500.0F;

// "wheel", "Wheel.001", "WheelHead" and "wheel_head", but no "wheelchair": the word and what does not go on
// with it.
bool is_wheel(std::string_view name) {
    constexpr std::string_view kWord = "wheel";
    const bool has_word = name.size() >= kWord.size() &&
                          std::equal(kWord.begin(), kWord.end(), name.begin(), [](char a, char b) {
                              return a == std::tolower(static_cast<unsigned char>(b));
                          });
    if (!has_word) return false;
    const std::string_view rest = name.substr(kWord.size());
    return rest.empty() || rest == "head" || std::islower(static_cast<unsigned char>(rest.front())) == 0;
}

struct Extent {
    vec3 low{std::numeric_limits<float>::max()};
    vec3 high{std::numeric_limits<float>::lowest()};

    void add(const vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    [[nodiscard]] float largest_side() const {
        const vec3 side = high - low;
        return std::max({side.x, side.y, side.z});
    }
};

void add_backs(render::Mesh& mesh) {
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        render::Mesh::Vertex back = mesh.vertices[i];
        back.normal = -back.normal;
        mesh.vertices.push_back(back);
    }
    const std::size_t indices = mesh.indices.size();
    for (std::size_t i = 0; i + 2 < indices; i += 3) {
        for (const std::size_t corner : {i, i + 2, i + 1})
            mesh.indices.push_back(mesh.indices[corner] + count);
    }
}

render::Material material_of(const asset::GltfModel& model, int index) {
    if (index < 0) return {.albedo = vec3(0.8F), .roughness = 1.0F};
    const asset::Material& from = model.materials[static_cast<std::size_t>(index)];
    return {.albedo = vec3(from.base_colour_linear),
            .roughness = std::clamp(static_cast<float>(from.roughness), 0.05F, 1.0F),
            .metalness = from.metallic > 0.5 ? 1.0F : 0.0F};
}

}  // namespace

Result<RoomModel> load_room_model(const std::filesystem::path& file) {
    const auto bytes = files::read_file(file, kMostBytes);
    if (!bytes) return bytes.error();
    const std::string name = shown_path(file.native());
    const auto model = asset::decode_glb(std::as_bytes(std::span(*bytes)), name);
    if (!model) return model.error();
    RoomModel room{.left_out = model->left_out};
    Extent whole;
    for (const asset::GltfPart& part : model->parts) {
        auto mesh = std::make_shared<render::Mesh>();
        Extent extent;
        for (std::size_t i = 0; i < part.mesh.positions_m.size(); ++i) {
            constexpr float kMmAMetre = 1000.0F;
            const vec3 position = part.mesh.positions_m[i] * kMmAMetre;
            extent.add(position);
            whole.add(position);
            mesh->vertices.push_back(
                {.position_mm = position, .normal = part.mesh.normals[i], .open_sky = 1.0F});
        }
        mesh->indices = part.mesh.indices;
        const bool is_thing = extent.largest_side() < kThingMm;
        if (!is_thing) add_backs(*mesh);
        room.has_wheel = room.has_wheel || is_wheel(part.node) || is_wheel(part.mesh_name);
        room.parts.push_back({.mesh = std::move(mesh),
                              .material = material_of(*model, part.material),
                              .casts_shadow = is_thing});
    }
    constexpr float kLeastMm = 1e3F;
    constexpr float kMostMm = 1e5F;
    const float size_mm = whole.largest_side();
    if (!(size_mm >= kLeastMm && size_mm <= kMostMm)) {
        return bad_input(
            fmt::format("{}: expected a room of 1 to 100 m (glTF counts in metres), found {:.3g} m", name,
                        size_mm / kLeastMm));
    }
    return room;
}

}  // namespace onggi::wheel
