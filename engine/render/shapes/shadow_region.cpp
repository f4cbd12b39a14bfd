#include "engine/render/shapes/shadow_region.h"

#include <algorithm>
#include <cmath>

#include "engine/render/shapes/lathe_vertices.h"

namespace onggi::render {
namespace {

// Horizontal direction of the shadow; arbitrary when the light is vertical.
vec2 shadow_direction(vec3 towards_light) {
    const vec2 flat(-towards_light.x, -towards_light.z);
    const float length = glm::length(flat);
    return length > 1e-4F ? flat / length : vec2(1.0F, 0.0F);
}

// Length of the shadow of a thing one mm high.
float shadow_length(vec3 towards_light) {
    return glm::length(vec2(towards_light.x, towards_light.z)) / std::max(towards_light.y, 0.05F);
}

float widest_radius(const Lathe& lathe) {
    if (lathe.radii_mm.empty()) return 0.0F;
    return *std::max_element(lathe.radii_mm.begin(), lathe.radii_mm.end()) + largest_offset_mm(lathe);
}

// Bottom of a ring. The index after the last ring returns the top.
float bottom_of(const Lathe& lathe, std::size_t ring) {
    const bool stacked = lathe.top_mm.size() == lathe.radii_mm.size();
    if (ring == 0 || lathe.radii_mm.empty()) return 0.0F;
    return stacked ? lathe.top_mm[ring - 1] : static_cast<float>(ring) * lathe.element_height_mm;
}

float height_of(const Lathe& lathe) {
    return bottom_of(lathe, lathe.radii_mm.size());
}

}  // namespace

MaskPlacement place_mask(const ShadowRegion& region, const DirectionalLight& light) {
    const vec2 along = shadow_direction(light.towards_light);
    const vec2 across(-along.y, along.x);
    const float back = region.half_width_mm;
    const float length = back + region.half_width_mm + region.height_mm * shadow_length(light.towards_light);
    const float width = 2.0F * region.half_width_mm;

    MaskPlacement placement;
    placement.axis_u = along * length;
    placement.axis_v = across * width;
    placement.origin = -along * back - across * region.half_width_mm;
    // q = p - L p.y / L.y, so each coordinate of q is linear in p, and so is its fraction of the rectangle.
    const vec3 light_direction = light.towards_light;
    const auto row = [&](vec2 axis, float size) {
        const vec2 unit = axis / size;
        const float lean =
            -(unit.x * light_direction.x + unit.y * light_direction.z) / std::max(light_direction.y, 0.05F);
        return vec4(unit.x, lean, unit.y, -glm::dot(unit, placement.origin)) / size;
    };
    placement.u = row(placement.axis_u, length);
    placement.v = row(placement.axis_v, width);
    return placement;
}

PixelRect pixels_of(std::span<const Box> boxes, const Camera& camera, int width_px, int height_px) {
    dvec2 low(width_px, height_px);
    dvec2 high(0.0);
    for (const Box& box : boxes) {
        for (int corner = 0; corner < 8; ++corner) {
            const dvec3 point((corner & 1) != 0 ? box.high.x : box.low.x,
                              (corner & 2) != 0 ? box.high.y : box.low.y,
                              (corner & 4) != 0 ? box.high.z : box.low.z);
            const auto projected = project(camera, width_px, height_px, point);
            if (!projected) return {0, 0, width_px, height_px};  // reaches behind the eye: it may be anywhere
            low = glm::min(low, projected->pixel);
            high = glm::max(high, projected->pixel);
        }
    }
    const auto x0 = static_cast<int>(std::clamp(std::floor(low.x) - 1.0, 0.0, static_cast<double>(width_px)));
    const auto y0 =
        static_cast<int>(std::clamp(std::floor(low.y) - 1.0, 0.0, static_cast<double>(height_px)));
    const auto x1 = static_cast<int>(std::clamp(std::ceil(high.x) + 1.0, 0.0, static_cast<double>(width_px)));
    const auto y1 =
        static_cast<int>(std::clamp(std::ceil(high.y) + 1.0, 0.0, static_cast<double>(height_px)));
    if (x1 <= x0 || y1 <= y0) return {};
    return {x0, y0, x1 - x0, y1 - y0};
}

Box lathe_box(const Lathe& lathe) {
    const float r = widest_radius(lathe) * 1.01F;  // the polygon straddles the circle
    return {{-r, 0.0F, -r}, {r, height_of(lathe), r}};
}

Box sphere_box(const Sphere& sphere) {
    return {sphere.centre_mm - sphere.radius_mm, sphere.centre_mm + sphere.radius_mm};
}

std::vector<Box> boxes_beside_lathe(const Scene& scene) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.spheres.size(), kMaxSpheres); ++i)
        boxes.push_back(sphere_box(scene.spheres[i]));
    for (const Prop& prop : scene.props) {
        if (!scene.prop_library || prop.model >= scene.prop_library->size()) continue;
        for (const Box& box : (*scene.prop_library)[prop.model].boxes_mm)
            boxes.push_back(placed(box, prop.place));
    }
    return boxes;
}

}  // namespace onggi::render
