#include "engine/render/shapes/frame_build.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/hash.h"
#include "engine/render/shapes/lathe_edges.h"
#include "engine/render/shapes/lathe_section.h"
#include "engine/render/shapes/lathe_sectors.h"
#include "engine/render/shapes/lathe_vertices.h"
#include "engine/render/shapes/sky_light.h"

namespace onggi::render {
namespace {

mat4 key_projection(const DirectionalLight& light, const StillBounds& still) {
    const vec3 up = std::abs(light.towards_light.y) > 0.99F ? vec3(1.0F, 0.0F, 0.0F) : vec3(0.0F, 1.0F, 0.0F);
    const float r = still.radius_mm;
    const mat4 view = glm::lookAt(still.centre_mm + light.towards_light * (2.0F * r), still.centre_mm, up);
    return glm::ortho(-r, r, -r, r, 0.5F * r, 3.5F * r) * view;
}

void build_lights(const Scene& scene, const StillBounds& still, shaders::FrameData& frame) {
    frame.key_view_projection = key_projection(scene.key, still);
    frame.key_direction = vec4(scene.key.towards_light, std::tan(scene.key.angular_radius_rad));
    const vec3 ambient = scene.levels.ambient;
    frame.levels = vec4(ambient, scene.levels.key);
    frame.key_radiance = vec4(scene.key.radiance * scene.levels.key, 0.0F);
    frame.sky_zenith = vec4(scene.environment.zenith * ambient, 0.0F);
    frame.sky_horizon = vec4(scene.environment.horizon * ambient, 0.0F);
    frame.sky_nadir = vec4(scene.environment.nadir * ambient, 0.0F);
    for (std::size_t i = 0; i < scene.environment.panels.size(); ++i) {
        const Environment::Panel& panel = scene.environment.panels[i];
        frame.panel_direction[i] = vec4(panel.direction, panel.sharpness);
        frame.panel_radiance[i] = vec4(panel.radiance * ambient, 0.0F);
    }
    const std::array<vec3, 9> irradiance =
        scene.irradiance ? *scene.irradiance : sky_irradiance(scene.environment);
    for (std::size_t i = 0; i < irradiance.size(); ++i)
        frame.irradiance[i] = vec4(irradiance[i] * ambient, 0.0F);

    const MaskPlacement mask = place_mask(scene.shadow_region, scene.key);
    frame.mask_u = mask.u;
    frame.mask_v = mask.v;
    frame.mask_origin = vec4(mask.origin.x, mask.origin.y, 0.0F, 0.0F);
    frame.mask_axes = vec4(mask.axis_u.x, mask.axis_u.y, mask.axis_v.x, mask.axis_v.y);
}

void build_backdrop(const Scene& scene, int width_px, int height_px, shaders::FrameData& frame) {
    const Backdrop& backdrop = scene.backdrop;
    const vec3 ambient = scene.levels.ambient;
    const auto width = static_cast<float>(width_px);
    const auto height = static_cast<float>(height_px);
    const float shorter = std::min(width, height);
    frame.backdrop_low = vec4(backdrop.low * ambient, 0.0F);
    frame.backdrop_high = vec4(backdrop.high * ambient, 0.0F);
    frame.backdrop_glow = vec4(backdrop.glow * ambient, backdrop.glow_radius);
    frame.backdrop_shape =
        vec4(backdrop.glow_centre.x, backdrop.glow_centre.y, width / shorter, height / shorter);
    frame.picture = vec4(width, height, 1.0F / width, 1.0F / height);
    frame.fade = vec4(1.0F - scene.fade_in.value_or(1.0F), 0.0F, 0.0F, 0.0F);
    if (!scene.background) return;
    frame.background_window =
        background_window(scene.background->camera, scene.background->width_px, scene.background->height_px,
                          scene.camera, width_px, height_px);
}

// All of it but what moves.
void build_scene(const Scene& scene, const StillBounds& still, int width_px, int height_px,
                 shaders::FrameData& frame) {
    frame.view_projection = view_projection(scene.camera, width_px, height_px);
    frame.eye = vec4(scene.camera.eye_mm, 0.0F);
    build_lights(scene, still, frame);
    build_backdrop(scene, width_px, height_px, frame);
}

// How far the streaks' texture has turned, in its own widths: two of it go round.
float streak_turn(vec2 turn) {
    const float angle = std::atan2(turn.y, turn.x);
    return angle / std::numbers::pi_v<float>;
}

std::vector<float> sectors_of(const Scene& scene, const RendererDesc& desc, float px_per_mm,
                              const LatheProfile& profile) {
    const Lathe& lathe = *scene.lathe;
    if (lathe.cut || desc.sector_error_px <= 0.0F) return even_sectors(lathe, desc.sectors);
    const auto at_edge = std::min(profile.edge, profile.points.size() - 1);
    float widest_mm = 0.0F;
    for (const ProfilePoint& point : profile.points)
        widest_mm = std::max(widest_mm, point.radius_mm);
    const vec3& eye = scene.camera.eye_mm;
    const vec3 down = eye - scene.camera.target_mm;
    return seen_sectors({.widest_px = widest_mm * px_per_mm,
                         .rim_px = profile.points[at_edge].radius_mm * px_per_mm,
                         .azimuth_rad = std::atan2(eye.z, eye.x),
                         .pitch_rad = std::atan2(down.y, std::hypot(down.x, down.z))},
                        {.error_px = desc.sector_error_px, .max_sectors = desc.sectors});
}

void build_lathe(const Scene& scene, const RendererDesc& desc, const EdgeView& view, BuiltFrame& built) {
    const Lathe& lathe = *scene.lathe;
    const auto px_per_mm = static_cast<float>(pixels_per_mm(scene.camera, view.height_px));
    build_profile(lathe, built.profile);
    if (built.profile.empty()) return;
    sample_profile(built.profile, built.samples);
    const std::size_t seen = lathe.cut
                                 ? built.profile.points.size()
                                 : points_seen(built.profile, scene.camera.eye_mm, largest_offset_mm(lathe));
    built.choice = choose_rows(built.profile, seen,
                               {.tolerance_mm = desc.ring_error_px / px_per_mm,
                                .max_rows = std::clamp(desc.max_rings, 32, kMaxRings),
                                .edge_stride = desc.samples > 1 ? 1 : 3,
                                .max_span_mm = desc.samples > 1 ? 4.0F : 9.0F});
    built.ring_error_px = built.choice.tolerance_mm * px_per_mm;
    fill_rows(lathe, built.profile, built.samples, built.choice, built.rows);
    const std::vector<float> angles = sectors_of(scene, desc, px_per_mm, built.profile);
    built.sectors = static_cast<int>(angles.size()) - 1;
    fill_vertices({.lathe = lathe,
                   .profile = built.profile,
                   .samples = built.samples,
                   .chosen = built.choice,
                   .rows = built.rows},
                  scene.key, angles, built.vertices);
    built.shows_load = lathe.shows_load;
    built.marks = lathe.shows_load ? nullptr : lathe.marks;
    built.section_first = static_cast<std::uint32_t>(built.vertices.size());
    if (lathe.cut) {
        const std::size_t added = add_section({.lathe = lathe,
                                               .profile = built.profile,
                                               .samples = built.samples,
                                               .chosen = built.choice,
                                               .rows = built.rows},
                                              built.sectors, built.vertices);
        built.section_count = static_cast<std::uint32_t>(added);
        built.section.dry = vec4(lathe.cut->section, 0.0F);
        built.section.wet = vec4(vec3(0.0F), lathe.shows_load ? 1.0F : 0.0F);
    }
    constexpr float kFootprintPx =
        1.2F;  // a normal a pixel, so grooves of two pixels must have begun to fade
    profile_normals(built.profile, kFootprintPx / px_per_mm, built.normals);
    if (desc.smooths_outlines)
        add_grid_edges(std::span(built.vertices).first(built.section_first), built.sectors,
                       lathe.cut.has_value(), view, built.edges);

    const vec4& foot = built.vertices.front().place;
    const vec4& across = built.vertices[static_cast<std::size_t>(built.sectors) / 2].place;
    built.frame.lathe =
        vec4(built.profile.height_mm, built.samples.per_mm, LatheSamples::kCount, built.profile.foot_mm());
    if (!lathe.cut)
        built.frame.lathe_foot = vec4(0.5F * (foot.x + across.x), 0.5F * (foot.z + across.z), 0.0F, 0.0F);
    const LatheMaterial& material = lathe.material;
    built.lathe.dry = vec4(material.albedo, material.streaks);
    built.lathe.wet = vec4(wet_albedo(material.albedo, 1.0F), material.soft_edge);
    // A wide light is mirrored as wide as it is: its half width adds to the lobe's.
    const float film = film_roughness(material);
    const float width = 0.5F * std::tan(scene.key.angular_radius_rad);
    const float film_lobe = std::sqrt(std::sqrt(film * film * film * film + width * width));
    built.lathe.gloss = vec4(material.roughness, wet_roughness(material), film_lobe, material.coat);
    built.lathe.turn = vec4(streak_turn(lathe.turn), static_cast<float>(built.sectors + 1),
                            0.02F + 0.02F * material.coat, 1.0F / std::max(material.soft_edge, 1e-4F));
    const std::size_t edge = std::min(built.profile.edge, built.profile.points.size() - 1);
    built.lathe.marks = vec4(kMarkRows / std::max(built.profile.height_mm, 1e-3F),
                             built.profile.points[edge].along_mm, kMarkColumns, kMarkLean);
}

// Rays from the ground towards the light, past the outline at evenly spaced heights.
void build_shadow_steps(const DirectionalLight& key, BuiltFrame& built) {
    shaders::FrameData& frame = built.frame;
    const float rise = std::max(key.towards_light.y, 0.05F);
    const float tangent = frame.key_direction.w;
    constexpr int kIntervals = 28;     // what is left of the steps repeats the last
    constexpr float kFinestMm = 2.0F;  // near the foot a penumbra is as narrow as a texel can show
    for (int i = 0; i < shaders::kShadowSteps; ++i) {
        const float fraction = static_cast<float>(std::min(i, kIntervals)) / kIntervals;
        const float y_mm = built.profile.height_mm * fraction;
        const float t = y_mm / rise;
        frame.shadow_steps[i] =
            vec4(key.towards_light.x * t - frame.lathe_foot.x, key.towards_light.z * t - frame.lathe_foot.y,
                 built.samples.outer_mm[built.samples.at(y_mm)], 1.0F / std::max(t * tangent, kFinestMm));
    }
}

}  // namespace

vec3 wet_albedo(vec3 albedo, float wetness) {
    const float p = 0.66F * std::clamp(wetness, 0.0F, 1.0F);
    return albedo * (1.0F - p) / (vec3(1.0F) - p * albedo);
}

float wet_roughness(const LatheMaterial& material) {
    constexpr float kWetSmoothing = 0.72F;
    return material.roughness * kWetSmoothing;
}

float film_roughness(const LatheMaterial& material) {
    constexpr float kFilmRoughness = 0.20F;
    return kFilmRoughness + material.coat * (material.coat_roughness - kFilmRoughness);
}

StillBounds bounds_of(const StillLife& still_life) {
    StillBounds bounds;
    Box casters{vec3(std::numeric_limits<float>::max()), vec3(std::numeric_limits<float>::lowest())};
    for (const StillLife::Part& part : still_life.parts) {
        for (const Mesh::Vertex& vertex : part.mesh->vertices) {
            const vec3 point = part.position_mm + vertex.position_mm;
            bounds.lowest_mm = std::min(bounds.lowest_mm, point.y);
            if (!part.casts_shadow) continue;
            casters.low = glm::min(casters.low, point);
            casters.high = glm::max(casters.high, point);
        }
    }
    if (casters.low.x > casters.high.x) return bounds;
    bounds.centre_mm = 0.5F * (casters.low + casters.high);
    bounds.radius_mm = std::max(0.5F * glm::length(casters.high - casters.low), 1.0F);
    return bounds;
}

void build_frame(const Scene& scene, const StillBounds& still, const RendererDesc& desc, int width_px,
                 int height_px, BuiltFrame& built) {
    shaders::FrameData& frame = built.frame;
    frame = {};
    built.faces.clear();
    built.section_first = built.section_count = 0;
    built.shows_load = false;
    built.marks = nullptr;
    built.rows.clear();
    built.vertices.clear();
    built.edges.clear();
    built.ring_error_px = 0.0F;
    build_scene(scene, still, width_px, height_px, frame);
    const EdgeView view{scene.camera, width_px, height_px};
    if (scene.lathe) build_lathe(scene, desc, view, built);
    const std::size_t sphere_count = std::min<std::size_t>(scene.spheres.size(), kMaxSpheres);
    for (std::size_t i = 0; i < sphere_count; ++i)
        frame.spheres[i] = vec4(scene.spheres[i].centre_mm, scene.spheres[i].radius_mm);
    for (std::size_t i = sphere_count; i < kMaxSpheres; ++i)
        frame.spheres[i] = vec4(0.0F, -1e6F, 0.0F, 1e-3F);
    if (!built.rows.empty()) {
        const auto grid = std::span<const shaders::VertexData>(built.vertices).first(built.section_first);
        if (desc.inside_out) {
            take_all_faces(built.rows.size(), built.sectors, built.faces);
        } else {
            choose_faces(grid, built.sectors, frame, view, built.faces);
        }
        build_shadow_steps(scene.key, built);
    }
    std::vector<Box> moving = boxes_beside_lathe(scene);
    if (scene.lathe) moving.push_back(lathe_box(*scene.lathe));
    built.moving = pixels_of(moving, scene.camera, width_px, height_px);
}

shaders::FrameData still_frame(const Scene& scene, const StillBounds& still, int width_px, int height_px) {
    Scene lit = scene;
    lit.levels = {};
    shaders::FrameData frame{};
    build_scene(lit, still, width_px, height_px, frame);
    return frame;
}

shaders::MeshDraw mesh_draw(const Material& material, vec3 position_mm) {
    return {
        .place = vec4(position_mm, 0.0F),
        .albedo = vec4(material.albedo, material.roughness),
        .surface = vec4(material.metalness, material.groove_pitch_mm, material.groove_tilt, material.grain),
        .pattern = vec4(material.grain_stretch, 0.0F, 0.0F, 0.0F)};
}

std::uint64_t still_hash(const Scene& scene, int width_px, int height_px) {
    StateHash hash;
    hash.add(width_px);
    hash.add(height_px);
    hash.add(scene.still_life ? scene.still_life->revision : 0);
    // Structs of floats without gaps between them.
    const auto add = [&](const auto& floats) {
        static_assert(sizeof(floats) % sizeof(float) == 0);
        hash.add_bytes(std::as_bytes(std::span(&floats, 1)));
    };
    add(scene.camera);
    add(scene.key);
    add(scene.environment);
    if (scene.irradiance) add(*scene.irradiance);
    add(scene.backdrop);
    add(scene.shadow_region);
    return hash.value();
}

std::uint64_t shadow_hash(const Scene& scene) {
    StateHash hash;
    const auto add = [&](float value) { hash.add(std::span<const float>(&value, 1)); };
    if (scene.lathe) {
        const Lathe& lathe = *scene.lathe;
        hash.add(lathe.radii_mm);
        hash.add(lathe.top_mm);
        add(lathe.element_height_mm);
        if (!lathe.centre_mm.empty()) {
            // A pot off its centre carries its shadow round with it.
            for (const float value : {lathe.centre_mm[0].x, lathe.centre_mm[0].y, lathe.turn.x, lathe.turn.y})
                add(value);
        }
    }
    for (const Sphere& sphere : scene.spheres) {
        for (int axis = 0; axis < 3; ++axis)
            add(sphere.centre_mm[axis]);
        add(sphere.radius_mm);
    }
    for (int axis = 0; axis < 3; ++axis)
        add(scene.key.towards_light[axis]);
    add(scene.key.angular_radius_rad);
    add(scene.shadow_region.half_width_mm);
    add(scene.shadow_region.height_mm);
    return hash.value();
}

}  // namespace onggi::render
