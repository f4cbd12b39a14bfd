#include "engine/render/shadow_region.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

constexpr float kShadeOfFootMm = 110.0F;  // beyond it, the shade about the foot is less than 2 %

// Down the light, along the ground; any direction will do when the light stands straight above.
vec2 shadow_direction(vec3 towards_light) {
    const vec2 flat(-towards_light.x, -towards_light.z);
    const float length = glm::length(flat);
    return length > 1e-4F ? flat / length : vec2(1.0F, 0.0F);
}

// How far a thing one mm high casts its shadow.
float shadow_length(vec3 towards_light) {
    return glm::length(vec2(towards_light.x, towards_light.z)) / std::max(towards_light.y, 0.05F);
}

float widest_radius(const Lathe& lathe) {
    return lathe.radii_mm.empty() ? 0.0F : *std::max_element(lathe.radii_mm.begin(), lathe.radii_mm.end());
}

float height_of(const Lathe& lathe) {
    return static_cast<float>(lathe.radii_mm.size()) * lathe.element_height_mm;
}

void grow(Box& box, vec3 point) {
    box.low = glm::min(box.low, point);
    box.high = glm::max(box.high, point);
}

// A box, together with where its shadow meets the ground at y_mm.
Box with_shadow(const Box& box, const DirectionalLight& light, float y_mm) {
    const vec2 direction = shadow_direction(light.towards_light);
    const float length = shadow_length(light.towards_light);
    Box result{{box.low.x, std::min(y_mm, box.low.y), box.low.z}, {box.high.x, y_mm, box.high.z}};
    for (const float top : {box.low.y, box.high.y}) {
        const float reach = (top - y_mm) * length;
        const float blur =
            (top - y_mm) * light.angular_radius_rad * 2.0F / std::max(light.towards_light.y, 0.05F);
        for (const vec3 corner : {box.low, box.high}) {
            const vec3 shadow(corner.x + direction.x * reach, y_mm, corner.z + direction.y * reach);
            grow(result, shadow - vec3(blur, 0.0F, blur));
            grow(result, shadow + vec3(blur, 0.0F, blur));
        }
    }
    return result;
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
    // q = p - L p.y / L.y, so each coordinate of q is linear in p, and so is its share of the rectangle.
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

std::vector<Box> moving_boxes(const Scene& scene) {
    std::vector<Box> boxes;
    if (scene.lathe) {
        const float r = widest_radius(*scene.lathe) * 1.01F;  // the polygon straddles the circle
        boxes.push_back({{-r, 0.0F, -r}, {r, height_of(*scene.lathe), r}});
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.spheres.size(), kMaxSpheres); ++i) {
        const Sphere& sphere = scene.spheres[i];
        boxes.push_back({sphere.centre_mm - sphere.radius_mm, sphere.centre_mm + sphere.radius_mm});
    }
    return boxes;
}

PixelRect shade_pixels(const Scene& scene, float lowest_mm, int width_px, int height_px) {
    std::vector<Box> boxes;
    for (Box box : moving_boxes(scene)) {
        // What reaches below the ground casts from there only.
        box.low.y = std::max(box.low.y, 0.0F);
        box.high.y = std::max(box.high.y, 0.0F);
        boxes.push_back(with_shadow(box, scene.key, 0.0F));
        boxes.push_back(with_shadow(box, scene.key, std::min(lowest_mm, 0.0F)));
    }
    if (scene.lathe) {
        const float r =
            (scene.lathe->radii_mm.empty() ? 0.0F : scene.lathe->radii_mm.front()) + kShadeOfFootMm;
        boxes.push_back({{-r, 0.0F, -r}, {r, 0.0F, r}});
    }
    for (const Sphere& sphere : scene.spheres) {
        const float r = sphere.radius_mm * 4.0F;  // its shade on the ground below it
        boxes.push_back({{sphere.centre_mm.x - r, 0.0F, sphere.centre_mm.z - r},
                         {sphere.centre_mm.x + r, 0.0F, sphere.centre_mm.z + r}});
    }
    return pixels_of(boxes, scene.camera, width_px, height_px);
}

}  // namespace onggi::render
