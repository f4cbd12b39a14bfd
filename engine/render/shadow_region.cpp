#include "engine/render/shadow_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/render/lathe_vertices.h"

namespace onggi::render {
namespace {

constexpr float kShadeOfFootMm = 62.0F;  // where mask.frag ends the shade about the foot

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
    if (lathe.radii_mm.empty()) return 0.0F;
    return *std::max_element(lathe.radii_mm.begin(), lathe.radii_mm.end()) + largest_offset_mm(lathe);
}

// Of a ring; of the one after the last: the top.
float bottom_of(const Lathe& lathe, std::size_t ring) {
    const bool stacked = lathe.top_mm.size() == lathe.radii_mm.size();
    if (ring == 0 || lathe.radii_mm.empty()) return 0.0F;
    return stacked ? lathe.top_mm[ring - 1] : static_cast<float>(ring) * lathe.element_height_mm;
}

float height_of(const Lathe& lathe) {
    return bottom_of(lathe, lathe.radii_mm.size());
}

// The shadow that a level disc of the world casts on y = ground_mm, as an octagon about it with its penumbra.
struct Disc {
    vec3 centre_mm;
    float radius_mm;
    bool only_on_ground = false;  // shade from the sky, which falls on y = 0 alone
};
void add_shadow(const Disc& disc, const DirectionalLight& light, float ground_mm,
                std::vector<dvec3>& points) {
    const vec2 direction = shadow_direction(light.towards_light);
    const float drop = std::max(disc.centre_mm.y - ground_mm, 0.0F);
    const float reach = drop * shadow_length(light.towards_light);
    const float blur =
        1.1F * drop * std::tan(light.angular_radius_rad) / std::max(light.towards_light.y, 0.05F);
    const float radius =
        (disc.radius_mm + blur + 4.0F) * 1.0824F;  // an octagon's corners lie outside its circle
    for (int corner = 0; corner < 8; ++corner) {
        const float angle = (static_cast<float>(corner) + 0.5F) * std::numbers::pi_v<float> / 4.0F;
        points.emplace_back(disc.centre_mm.x + direction.x * reach + radius * std::cos(angle), ground_mm,
                            disc.centre_mm.z + direction.y * reach + radius * std::sin(angle));
    }
}

// Discs whose hull holds the lathe: the widest of each of a few slabs, at its top and bottom.
std::vector<Disc> discs_of(const Lathe& lathe) {
    constexpr std::size_t kSlabs = 3;
    const float offset_mm = largest_offset_mm(lathe);
    std::vector<Disc> discs;
    const std::size_t count = lathe.radii_mm.size();
    for (std::size_t slab = 0; slab < kSlabs; ++slab) {
        const std::size_t from = count * slab / kSlabs;
        const std::size_t to = count * (slab + 1) / kSlabs;
        if (from == to) continue;
        const float widest = *std::max_element(lathe.radii_mm.begin() + static_cast<std::ptrdiff_t>(from),
                                               lathe.radii_mm.begin() + static_cast<std::ptrdiff_t>(to)) +
                             offset_mm;
        for (const std::size_t level : {from, to})
            discs.push_back({{0.0F, bottom_of(lathe, level), 0.0F}, widest});
    }
    return discs;
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

Box lathe_box(const Lathe& lathe) {
    const float r = widest_radius(lathe) * 1.01F;  // the polygon straddles the circle
    return {{-r, 0.0F, -r}, {r, height_of(lathe), r}};
}

std::vector<Box> boxes_beside_lathe(const Scene& scene) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.spheres.size(), kMaxSpheres); ++i) {
        const Sphere& sphere = scene.spheres[i];
        boxes.push_back({sphere.centre_mm - sphere.radius_mm, sphere.centre_mm + sphere.radius_mm});
    }
    for (const Mover& mover : scene.movers) {
        if (!scene.mover_library || mover.model >= scene.mover_library->size()) continue;
        for (const Box& box : (*scene.mover_library)[mover.model].boxes_mm)
            boxes.push_back(placed(box, mover.place));
    }
    return boxes;
}

std::vector<dvec2> convex_hull(std::vector<dvec2> points) {
    // A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
    std::sort(points.begin(), points.end(),
              [](const dvec2& a, const dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    if (points.size() < 3) return points;
    const auto turns_in = [](const dvec2& a, const dvec2& b, const dvec2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) <= 0.0;
    };
    std::vector<dvec2> hull;
    const auto walk = [&](auto begin, auto end) {
        const std::size_t start = hull.size();
        for (auto point = begin; point != end; ++point) {
            while (hull.size() >= start + 2 && turns_in(hull[hull.size() - 2], hull.back(), *point))
                hull.pop_back();
            hull.push_back(*point);
        }
        hull.pop_back();  // it begins the other walk
    };
    walk(points.begin(), points.end());
    walk(points.rbegin(), points.rend());
    return hull;
}

std::vector<dvec2> shade_outline(const Scene& scene, float lowest_mm, int width_px, int height_px,
                                 std::size_t max_corners) {
    std::vector<Disc> discs;
    if (scene.lathe) {
        discs = discs_of(*scene.lathe);
        if (!discs.empty())
            discs.push_back({vec3(0.0F),
                             scene.lathe->radii_mm.front() + kShadeOfFootMm + largest_offset_mm(*scene.lathe),
                             true});
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.spheres.size(), kMaxSpheres); ++i) {
        const Sphere& sphere = scene.spheres[i];
        discs.push_back({sphere.centre_mm, sphere.radius_mm});
        const float clearance = std::max(sphere.centre_mm.y, sphere.radius_mm);
        // Its shade on the ground below it, (r / d)^2, is 2 % at seven radii.
        const float reach =
            std::sqrt(std::max(49.0F * sphere.radius_mm * sphere.radius_mm - clearance * clearance, 0.0F));
        if (reach > 0.0F) discs.push_back({{sphere.centre_mm.x, 0.0F, sphere.centre_mm.z}, reach, true});
    }
    std::vector<dvec3> points;
    for (const Disc& disc : discs) {
        add_shadow(disc, scene.key, 0.0F, points);
        if (!disc.only_on_ground) add_shadow(disc, scene.key, std::min(lowest_mm, 0.0F), points);
    }
    const std::vector<dvec2> whole{{0.0, 0.0}, {width_px, 0.0}, {width_px, height_px}, {0.0, height_px}};
    std::vector<dvec2> pixels;
    for (const dvec3& point : points) {
        const auto projected = project(scene.camera, width_px, height_px, point);
        if (!projected) return whole;
        pixels.push_back(projected->pixel);
    }
    std::vector<dvec2> hull = convex_hull(std::move(pixels));
    return hull.size() > max_corners ? whole : hull;
}

}  // namespace onggi::render
