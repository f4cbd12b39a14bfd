#include "engine/render/lathe_shape.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

std::array<std::int16_t, 2> packed(vec2 normal) {
    const auto pack = [](float value) {
        return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 32767.0F));
    };
    return {pack(normal.x), pack(normal.y)};
}

// The radius between two elements' centres, by position in elements.
float radius_at(std::span<const float> wall, float position) {
    const float clamped = std::clamp(position, 0.0F, static_cast<float>(wall.size() - 1));
    const auto below = static_cast<std::size_t>(clamped);
    const std::size_t above = std::min(below + 1, wall.size() - 1);
    return wall[below] + (clamped - static_cast<float>(below)) * (wall[above] - wall[below]);
}

}  // namespace

LatheOutline outline_of(const Lathe& lathe) {
    LatheOutline outline;
    if (lathe.radii_mm.empty()) return outline;
    const std::size_t count = lathe.radii_mm.size();
    outline.height_mm = static_cast<float>(count) * lathe.element_height_mm;
    outline.rounding_mm = std::clamp(lathe.edge_rounding_mm, 0.0F,
                                     std::min(0.5F * lathe.radii_mm.back(), 0.25F * outline.height_mm));
    outline.wall_height_mm = outline.height_mm - outline.rounding_mm;
    const auto below_rounding =
        static_cast<std::size_t>(std::ceil(outline.wall_height_mm / lathe.element_height_mm - 0.5F));
    outline.wall = lathe.radii_mm.first(std::clamp<std::size_t>(below_rounding, 1, count));
    return outline;
}

void lathe_rings(const LatheOutline& outline, float element_height_mm, const RingChoice& choice,
                 std::vector<shaders::RingData>& rings) {
    rings.clear();
    const auto add = [&](std::uint32_t element, float y_mm) {
        const float share = outline.wall_height_mm > 0.0F ? y_mm / outline.wall_height_mm : 0.0F;
        rings.push_back(
            {.element = element,
             .y_mm = y_mm,
             .radius_mm = outline.wall[element],
             .open_sky = 1.0F,
             .profile_u = (0.5F + share * (shaders::kProfileWallTexels - 1)) / shaders::kProfileTexels});
    };
    add(0, 0.0F);
    for (const std::uint32_t element : choice.elements)
        add(element,
            std::min((static_cast<float>(element) + 0.5F) * element_height_mm, outline.wall_height_mm));
    add(choice.elements.back(), outline.wall_height_mm);
    for (std::size_t ring = 0; ring < rings.size(); ++ring)
        rings[ring].open_sky = open_sky(rings, ring);
}

float open_sky(std::span<const shaders::RingData> rings, std::size_t ring) {
    float steepest_above = 0.0F;  // tangent of the horizon's lean over the ring, outwards from upright
    float steepest_below = 0.0F;
    for (std::size_t other = 0; other < rings.size(); ++other) {
        const float rise = rings[other].y_mm - rings[ring].y_mm;
        const float out = rings[other].radius_mm - rings[ring].radius_mm;
        if (rise > 0.0F) steepest_above = std::max(steepest_above, out / rise);
        if (rise < 0.0F) steepest_below = std::max(steepest_below, out / -rise);
    }
    const auto sine_of_view = [](float tangent) { return 1.0F / std::sqrt(1.0F + tangent * tangent); };
    return 0.5F * (sine_of_view(steepest_above) + sine_of_view(steepest_below));
}

void lathe_normals(const LatheOutline& outline, float element_height_mm, float footprint_mm,
                   NormalTexels& texels) {
    constexpr int kWall = shaders::kProfileWallTexels;
    constexpr int kEdge = shaders::kProfileEdgeTexels;
    const float texel_mm = outline.wall_height_mm / (kWall - 1);
    // A mean slope over a span is the difference of its ends: no sum is needed. At least two elements, or the
    // steps between them would show.
    const float span_mm = std::max({footprint_mm, texel_mm, 2.0F * element_height_mm});
    // Between the first and the last centre the radii say something; before and after, nothing changes.
    const float last_centre_mm = (static_cast<float>(outline.wall.size()) - 0.5F) * element_height_mm;
    for (int i = 0; i < kWall; ++i) {
        const float y_mm = static_cast<float>(i) * texel_mm;
        const float from_mm = std::clamp(y_mm - 0.5F * span_mm, 0.5F * element_height_mm, last_centre_mm);
        const float to_mm = std::max(std::min(y_mm + 0.5F * span_mm, last_centre_mm), from_mm);
        const float run_mm = std::max(to_mm - from_mm, 1e-3F);
        const float out_mm = radius_at(outline.wall, to_mm / element_height_mm - 0.5F) -
                             radius_at(outline.wall, from_mm / element_height_mm - 0.5F);
        texels[static_cast<std::size_t>(i)] = packed(glm::normalize(vec2(run_mm, -out_mm)));
    }
    constexpr float kQuarterTurn = 1.57079633F;
    for (int i = 0; i < kEdge; ++i) {
        const float angle = kQuarterTurn * static_cast<float>(i) / (kEdge - 1);
        texels[static_cast<std::size_t>(kWall + i)] = packed(vec2(std::cos(angle), std::sin(angle)));
    }
    for (int i = kWall + kEdge; i < shaders::kProfileTexels; ++i)
        texels[static_cast<std::size_t>(i)] = packed(vec2(0.0F, 1.0F));
}

}  // namespace onggi::render
