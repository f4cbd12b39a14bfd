#include "game/wheel/workshop.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "engine/asset/gltf_read.h"
#include "engine/core/quote.h"
#include "engine/files/read_file.h"
#include "engine/render/profile_mesh.h"

namespace onggi::wheel {
namespace {

constexpr int kSectors = 160;

// The wheel head: a thick disc of cast metal, turned flat, with a bright edge. Its top is y = 0.
render::Profile wheel_head() {
    render::Profile profile;
    profile.points = {{0.0F, -26.0F}, {96.0F, -26.0F}};
    render::add_rounded(profile, {96.0F, -26.0F}, {146.0F, -20.0F}, {150.0F, -12.0F}, 3.0F);
    profile.points.push_back({150.0F, -9.0F});
    render::add_rounded(profile, {150.0F, -9.0F}, {150.0F, 0.0F}, {100.0F, 0.0F}, 3.0F, 8);
    for (const float r : {140.0F, 120.0F, 95.0F, 70.0F, 40.0F, 0.0F})
        profile.points.push_back({r, 0.0F});
    return profile;
}

render::Profile shaft() {
    return {.points = {{26.0F, -84.0F}, {26.0F, -26.0F}}};
}

// The splash pan: up the outside, round the rolled rim, down the inside, in to the shaft.
render::Profile splash_pan() {
    render::Profile profile;
    profile.points = {{120.0F, -100.0F}, {176.0F, -100.0F}};
    render::add_rounded(profile, {176.0F, -100.0F}, {220.0F, -98.0F}, {229.0F, -36.0F}, 16.0F, 8);
    profile.points.push_back({230.0F, -38.0F});
    // The roll: most of a circle.
    constexpr int kSteps = 14;
    for (int step = 0; step <= kSteps; ++step) {
        const float angle = -0.9F + 4.6F * static_cast<float>(step) / kSteps;
        profile.points.push_back({229.0F + 6.0F * std::cos(angle), -30.0F + 6.0F * std::sin(angle)});
    }
    profile.points.push_back({221.0F, -40.0F});
    render::add_rounded(profile, {221.0F, -40.0F}, {212.0F, -78.0F}, {150.0F, -82.0F}, 20.0F, 8);
    profile.points.push_back({150.0F, -82.0F});
    profile.points.push_back({60.0F, -81.0F});
    profile.points.push_back({26.0F, -80.0F});
    return profile;
}

// The bench under the wheel: round, thick, of old wood.
render::Profile bench() {
    render::Profile profile;
    profile.points = {{640.0F, -106.0F}};
    render::add_rounded(profile, {640.0F, -112.0F}, {640.0F, -100.0F}, {600.0F, -100.0F}, 5.0F);
    for (const float r :
         {560.0F, 470.0F, 400.0F, 340.0F, 300.0F, 270.0F, 245.0F, 230.0F, 215.0F, 200.0F, 0.0F})
        profile.points.push_back({r, -100.0F});
    return profile;
}

void add_part(ecs::Registry& registry, render::Mesh mesh, const render::Material& material,
              bool casts_shadow) {
    const ecs::Entity entity = registry.create();
    registry.add(entity, Transform{});
    registry.add(entity, StillPart{.mesh = std::make_shared<const render::Mesh>(std::move(mesh)),
                                   .material = material,
                                   .casts_shadow = casts_shadow});
}

// A rectangle at one height, seen from above.
render::Mesh level_sheet(float left_mm, float right_mm, float back_mm, float front_mm, float y_mm) {
    render::Mesh mesh;
    for (const vec2 corner :
         {vec2(left_mm, back_mm), vec2(left_mm, front_mm), vec2(right_mm, front_mm), vec2(right_mm, back_mm)})
        mesh.vertices.push_back(
            {.position_mm = {corner.x, y_mm, corner.y}, .normal = {0.0F, 1.0F, 0.0F}, .open_sky = 1.0F});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

render::DirectionalLight window_sun() {
    return {.towards_light = glm::normalize(vec3(-0.74F, 0.60F, 0.40F)),
            .radiance = vec3(1.42F, 1.10F, 0.78F),
            .angular_radius_rad = 0.055F};
}

// A dim warm room: the warm glow of the key's own window, a tall cool window behind on the left, for
// reflections in the metal and on the clay's far edge, and a soft reflector in front.
Surroundings evening_studio() {
    Surroundings surroundings;
    render::Environment& environment = surroundings.environment;
    environment.zenith = vec3(0.070F, 0.064F, 0.060F);
    environment.horizon = vec3(0.040F, 0.033F, 0.026F);
    environment.nadir = vec3(0.030F, 0.022F, 0.016F);
    environment.panels[0] = {glm::normalize(vec3(-0.80F, 0.42F, 0.45F)), vec3(0.55F, 0.45F, 0.34F), 9.0F};
    environment.panels[1] = {glm::normalize(vec3(-0.40F, 0.30F, -0.86F)), vec3(0.84F, 0.92F, 1.00F), 24.0F};
    environment.panels[2] = {glm::normalize(vec3(0.75F, 0.30F, 0.60F)), vec3(0.16F, 0.13F, 0.10F), 4.0F};
    render::Backdrop& backdrop = surroundings.backdrop;
    backdrop.low = vec3(0.0130F, 0.0098F, 0.0074F);
    backdrop.high = vec3(0.0062F, 0.0052F, 0.0045F);
    backdrop.glow = vec3(0.062F, 0.043F, 0.027F);
    backdrop.glow_centre = vec2(-0.30F, 0.30F);
    backdrop.glow_radius = 0.95F;
    return surroundings;
}

// The wheel of assets/workshop/maker/wheel.py: head, and splash pan with slip.
std::array<render::Profile, 2> photographed_wheel() {
    const render::Profile head{.points = {{0.0F, -22.0F},
                                          {120.0F, -22.0F},
                                          {144.0F, -20.0F},
                                          {149.0F, -16.5F},
                                          {150.0F, -14.0F},
                                          {150.0F, -3.5F},
                                          {148.8F, -1.2F},
                                          {146.0F, 0.0F},
                                          {0.0F, 0.0F}}};
    const render::Profile pan{.points = {{30.0F, -63.0F},
                                         {185.0F, -63.0F},
                                         {209.0F, -54.0F},
                                         {211.5F, -18.0F},
                                         {218.0F, -15.0F},
                                         {220.5F, -10.0F},
                                         {219.5F, -5.0F},
                                         {215.0F, -4.0F},
                                         {209.0F, -6.0F},
                                         {206.0F, -12.0F},
                                         {202.0F, -44.0F},
                                         {195.0F, -54.0F},
                                         {192.5F, -55.8F},  // level of the slip
                                         {0.0F, -55.8F}}};
    return {head, pan};
}

void add_light(ecs::Registry& registry, const Workshop& workshop) {
    registry.add(registry.create(), KeyLight{workshop.key});
    registry.add(
        registry.create(),
        Surroundings{.environment = workshop.environment, .irradiance = workshop.irradiance, .backdrop = {}});
}

}  // namespace

void furnish(ecs::Registry& registry) {
    const std::array profiles{wheel_head(), shaft(), splash_pan(), bench()};
    std::array meshes{render::turned_mesh(profiles[0], kSectors), render::turned_mesh(profiles[1], kSectors),
                      render::turned_mesh(profiles[2], kSectors), render::turned_mesh(profiles[3], kSectors)};
    render::set_open_sky(profiles, meshes, kSectors);
    const render::Material aluminium{.albedo = vec3(0.56F, 0.55F, 0.53F),
                                     .roughness = 0.34F,
                                     .metalness = 0.86F,
                                     .groove_pitch_mm = 5.5F,
                                     .groove_tilt = 0.06F,
                                     .grain = 0.07F};
    const render::Material steel{.albedo = vec3(0.35F), .roughness = 0.4F, .metalness = 1.0F};
    const render::Material enamel{.albedo = vec3(0.105F, 0.125F, 0.122F), .roughness = 0.34F, .grain = 0.10F};
    const render::Material old_wood{
        .albedo = vec3(0.060F, 0.034F, 0.020F), .roughness = 0.50F, .grain = 0.45F, .grain_stretch = 14.0F};
    add_part(registry, std::move(meshes[0]), aluminium, true);
    add_part(registry, std::move(meshes[1]), steel, true);
    add_part(registry, std::move(meshes[2]), enamel, true);
    add_part(registry, std::move(meshes[3]), old_wood, false);

    const ecs::Entity sun = registry.create();
    registry.add(sun, KeyLight{window_sun()});
    const ecs::Entity room = registry.create();
    registry.add(room, evening_studio());
}

void stand_in(ecs::Registry& registry, const Workshop& workshop) {
    constexpr bool kShadowIsInTheBackground = false;
    for (const render::Profile& profile : photographed_wheel()) {
        const ecs::Entity part = registry.create();
        registry.add(part, Transform{});
        registry.add(
            part,
            StillPart{.mesh = std::make_shared<const render::Mesh>(render::turned_mesh(profile, kSectors)),
                      .casts_shadow = kShadowIsInTheBackground});
    }
    const ecs::Entity deck = registry.create();
    registry.add(deck, Transform{});
    registry.add(deck, StillPart{.mesh = std::make_shared<const render::Mesh>(
                                     level_sheet(-600.0F, 600.0F, -700.0F, 360.0F, -58.0F)),
                                 .casts_shadow = kShadowIsInTheBackground});

    add_light(registry, workshop);
}

void build_room(ecs::Registry& registry, const Workshop& workshop, RoomModel model) {
    for (StillPart& part : model.parts) {
        const ecs::Entity entity = registry.create();
        registry.add(entity, Transform{});
        registry.add(entity, std::move(part));
    }
    if (!model.has_wheel) {
        constexpr bool kCastsShadow = true;
        const std::array<render::Profile, 2> profiles = photographed_wheel();
        add_part(registry, render::turned_mesh(profiles[0], kSectors),
                 {.albedo = vec3(0.45F), .roughness = 0.4F, .metalness = 1.0F}, kCastsShadow);
        add_part(registry, render::turned_mesh(profiles[1], kSectors),
                 {.albedo = vec3(0.55F, 0.50F, 0.43F), .roughness = 0.6F}, kCastsShadow);
    }
    add_light(registry, workshop);
}

CameraRig throwing_camera() {
    return {.target_mm = dvec3(0.0, 66.0, 0.0),
            .distance_mm = 1150.0,
            .elevation_rad = 0.27,
            .azimuth_rad = 0.0,
            .height_mm = 358.0,
            .width_mm = 320.0};
}

namespace {

constexpr std::size_t kMostBytes = std::size_t{128} << 20;
// A larger part is a wall or a table: drawn from both sides, and too large for the single shadow map.
constexpr float kThingMm = 1500.0F;

// Matches "wheel", "Wheel.001", "WheelHead" and "wheel_head", but not "wheelchair": no letter of the same
// word may follow.
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
