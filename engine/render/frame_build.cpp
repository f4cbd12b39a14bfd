#include "engine/render/frame_build.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/hash.h"
#include "engine/render/sky_light.h"

namespace onggi::render {
namespace {

mat4 key_projection(const DirectionalLight& light, const StillBounds& still) {
    const vec3 up = std::abs(light.towards_light.y) > 0.99F ? vec3(1.0F, 0.0F, 0.0F) : vec3(0.0F, 1.0F, 0.0F);
    const float r = still.radius_mm;
    const mat4 view = glm::lookAt(still.centre_mm + light.towards_light * (2.0F * r), still.centre_mm, up);
    return glm::ortho(-r, r, -r, r, 0.5F * r, 3.5F * r) * view;
}

// A wet body is darker and more saturated: light that the film throws back into it is filtered once more.
// J. Lekner, M. Dorf, "Why some things are darker when wet", 1988: A' = A (1 - p) / (1 - p A), where p is the
// share of diffuse light that water reflects back inside; 0.66 of a full film, in between by wetness.
vec3 wet_albedo(vec3 albedo, float wetness) {
    const float p = 0.66F * std::clamp(wetness, 0.0F, 1.0F);
    return albedo * (1.0F - p) / (vec3(1.0F) - p * albedo);
}

void build_lights(const Scene& scene, const StillBounds& still, shaders::FrameData& frame) {
    frame.key_view_projection = key_projection(scene.key, still);
    frame.key_direction = vec4(scene.key.towards_light, std::tan(scene.key.angular_radius_rad));
    frame.key_radiance = vec4(scene.key.radiance, 0.0F);
    frame.sky_zenith = vec4(scene.environment.zenith, 0.0F);
    frame.sky_horizon = vec4(scene.environment.horizon, 0.0F);
    frame.sky_nadir = vec4(scene.environment.nadir, 0.0F);
    for (std::size_t i = 0; i < scene.environment.panels.size(); ++i) {
        const Environment::Panel& panel = scene.environment.panels[i];
        frame.panel_direction[i] = vec4(panel.direction, panel.sharpness);
        frame.panel_radiance[i] = vec4(panel.radiance, 0.0F);
    }
    const std::array<vec3, 9> irradiance = sky_irradiance(scene.environment);
    for (std::size_t i = 0; i < irradiance.size(); ++i)
        frame.irradiance[i] = vec4(irradiance[i], 0.0F);

    const MaskPlacement mask = place_mask(scene.shadow_region, scene.key);
    frame.mask_u = mask.u;
    frame.mask_v = mask.v;
    frame.mask_origin = vec4(mask.origin.x, mask.origin.y, 0.0F, 0.0F);
    frame.mask_axes = vec4(mask.axis_u.x, mask.axis_u.y, mask.axis_v.x, mask.axis_v.y);
}

void build_backdrop(const Backdrop& backdrop, int width_px, int height_px, shaders::FrameData& frame) {
    const auto width = static_cast<float>(width_px);
    const auto height = static_cast<float>(height_px);
    const float shorter = std::min(width, height);
    frame.backdrop_low = vec4(backdrop.low, 0.0F);
    frame.backdrop_high = vec4(backdrop.high, 0.0F);
    frame.backdrop_glow = vec4(backdrop.glow, backdrop.glow_radius);
    frame.backdrop_shape =
        vec4(backdrop.glow_centre.x, backdrop.glow_centre.y, width / shorter, height / shorter);
    frame.picture = vec4(width, height, 1.0F / width, 1.0F / height);
}

// How far the slip's texture has turned, in its own widths: two of it go round.
float slip_turn(vec2 turn) {
    const float angle = std::atan2(turn.y, turn.x);
    return angle / std::numbers::pi_v<float>;
}

void build_lathe(const Lathe& lathe, const Camera& camera, const RendererDesc& desc, int height_px,
                 BuiltFrame& built) {
    const auto scale = static_cast<float>(pixels_per_mm(camera, height_px));
    const LatheOutline outline = outline_of(lathe);
    // Two of the rings are the edges of base and wall.
    const int max_chosen = std::clamp(desc.max_rings, 16, kMaxRings) - 2;
    constexpr std::size_t kLeastSpans = 24;
    built.choice =
        choose_rings(outline.wall, {.tolerance_mm = desc.ring_error_px / scale,
                                    .max_rings = max_chosen,
                                    .max_step = static_cast<int>(outline.wall.size() / kLeastSpans + 1)});
    built.ring_error_px = built.choice.tolerance_mm * scale;
    lathe_rings(outline, lathe.element_height_mm, built.choice, built.rings);
    constexpr float kFootprintPx =
        1.5F;  // a normal a pixel, so grooves of two pixels must have begun to fade
    lathe_normals(outline, lathe.element_height_mm, kFootprintPx / scale, built.normals);

    built.frame.lathe = vec4(outline.height_mm, 1.0F / lathe.element_height_mm,
                             static_cast<float>(lathe.radii_mm.size()), lathe.radii_mm.front());
    const float wetness = std::clamp(lathe.material.wetness, 0.0F, 1.0F);
    built.lathe.albedo = vec4(wet_albedo(lathe.material.albedo, wetness), lathe.material.streaks);
    built.lathe.water = vec4(wetness, 0.66F - 0.12F * wetness, 0.0F, 0.0F);
    built.lathe.turn = vec4(slip_turn(lathe.turn), 0.0F, outline.wall.back(), outline.wall_height_mm);
    built.lathe.edge = vec4(outline.rounding_mm, static_cast<float>(desc.sectors),
                            static_cast<float>(built.rings.size()), static_cast<float>(desc.sectors + 1));
    const std::size_t strips = built.rings.size() + shaders::kEdgeRows;
    built.lathe_indices = static_cast<std::uint32_t>(strips * static_cast<std::size_t>(desc.sectors) * 6);
}

void build_shade(const Scene& scene, const StillBounds& still, int width_px, int height_px,
                 BuiltFrame& built) {
    const std::vector<dvec2> corners =
        shade_outline(scene, still.lowest_mm, width_px, height_px, shaders::kShadeCorners);
    built.shade_vertices = corners.size() < 3 ? 0 : static_cast<std::uint32_t>(3 * (corners.size() - 2));
    for (std::size_t i = 0; i < shaders::kShadeCorners && !corners.empty(); ++i) {
        const dvec2& corner = corners[std::min(i, corners.size() - 1)];
        const vec2 clip(2.0 * corner.x / width_px - 1.0, 2.0 * corner.y / height_px - 1.0);
        vec4& two = built.shade.corners[i / 2];
        (i % 2 == 0 ? two.x : two.z) = clip.x;
        (i % 2 == 0 ? two.y : two.w) = clip.y;
    }
}

}  // namespace

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
    built.lathe_indices = 0;
    built.rings.clear();
    built.ring_error_px = 0.0F;
    frame.view_projection = view_projection(scene.camera, width_px, height_px);
    frame.eye = vec4(scene.camera.eye_mm, 0.0F);
    build_lights(scene, still, frame);
    build_backdrop(scene.backdrop, width_px, height_px, frame);
    const bool has_lathe = scene.lathe && !scene.lathe->radii_mm.empty();
    if (has_lathe) build_lathe(*scene.lathe, scene.camera, desc, height_px, built);
    const std::size_t sphere_count = std::min<std::size_t>(scene.spheres.size(), kMaxSpheres);
    for (std::size_t i = 0; i < sphere_count; ++i)
        frame.spheres[i] = vec4(scene.spheres[i].centre_mm, scene.spheres[i].radius_mm);
    build_shade(scene, still, width_px, height_px, built);
    const std::vector<Box> moving = moving_boxes(scene);
    built.moving = pixels_of(moving, scene.camera, width_px, height_px);
}

shaders::MeshDraw mesh_draw(const Material& material, vec3 position_mm, float scale) {
    return {
        .place = vec4(position_mm, scale),
        .albedo = vec4(material.albedo, material.roughness),
        .surface = vec4(material.metalness, material.groove_pitch_mm, material.groove_tilt, material.grain),
        .pattern = vec4(material.grain_stretch, 0.0F, 0.0F, 0.0F)};
}

std::vector<std::uint16_t> lathe_indices(int max_rings, int sectors) {
    std::vector<std::uint16_t> indices;
    const int strips = max_rings + shaders::kEdgeRows;  // the last row is the axis
    const int in_row = sectors + 1;
    for (int row = 0; row < strips; ++row) {
        for (int sector = 0; sector < sectors; ++sector) {
            const int here = row * in_row + sector;
            const int above = here + in_row;
            for (const int index : {here, above, here + 1, here + 1, above, above + 1})
                indices.push_back(static_cast<std::uint16_t>(index));
        }
    }
    return indices;
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
    add(scene.backdrop);
    add(scene.shadow_region);
    return hash.value();
}

std::uint64_t shadow_hash(const Scene& scene) {
    StateHash hash;
    const auto add = [&](float value) { hash.add(std::span<const float>(&value, 1)); };
    if (scene.lathe) {
        hash.add(scene.lathe->radii_mm);
        add(scene.lathe->element_height_mm);
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
