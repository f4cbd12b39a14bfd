#include "engine/render/pixels/bent_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace onggi::render {
namespace {

float smooth_step(float low, float high, float value) {
    const float share = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
    return share * share * (3.0F - 2.0F * share);
}

// Where a plate shows a point: place_in() of the shader.
struct InPlate {
    vec2 at_w{0.0F};  // 0 to 1 from the top left, times w
    float w = 0.0F;
};
InPlate place_in(const mat4& plate, vec3 point) {
    const vec4 clip = plate * vec4(point, 1.0F);
    return {0.5F * (vec2(clip) + clip.w), clip.w};
}

// In texels from the middle of the first, times w.
vec2 texels_of(const Plate& plate, float scale, const InPlate& place) {
    return place.at_w * vec2(plate.width_px, plate.height_px) * scale - 0.5F * place.w;
}

// How well a plate shows a point: not at all where something stands before it or the plate ends.
float shown_by(const Plate& plate, const InPlate& place) {
    if (place.w <= 0.0F) return 0.0F;
    const vec2 at = place.at_w / place.w;
    const float from_edge = std::min(std::min(at.x, 1.0F - at.x), std::min(at.y, 1.0F - at.y));
    const float inside = smooth_step(-0.01F, 0.03F, from_edge);
    const Relief& relief = plate.relief;
    if (inside == 0.0F || relief.depth_mm.empty()) return inside;
    const auto nearest = [](float share, int count) {
        return std::clamp(static_cast<int>(share * static_cast<float>(count)), 0, count - 1);
    };
    const int corner = nearest(at.y, relief.rows) * relief.columns + nearest(at.x, relief.columns);
    const float behind = place.w - relief.depth_mm[static_cast<std::size_t>(corner)];
    return inside * (1.0F - smooth_step(50.0F, 130.0F, behind));
}

// How much of the second plate belongs to a point.
float share_at(const BendView& view, const InPlate& from, const InPlate& to) {
    const float share = view.frame.glide.x;
    if (share <= 0.0F || share >= 1.0F) return share;
    constexpr float kLeast = 0.001F;
    const float in_from = (1.0F - share) * std::max(shown_by(view.from, from), kLeast);
    const float in_to = share * std::max(shown_by(view.to, to), kLeast);
    return in_to / (in_from + in_to);
}

vec2 in_mask(const shaders::FrameData& frame, vec3 point) {
    return {glm::dot(vec3(frame.mask_u), point) + frame.mask_u.w,
            glm::dot(vec3(frame.mask_v), point) + frame.mask_v.w};
}

// The key light there, 0 to 1. Beside the mask is nothing in shade.
float key_at(const ShadowMask& mask, vec2 at) {
    constexpr int kAcross = shaders::kMaskTexels;
    const vec2 texel = at * static_cast<float>(kAcross) - 0.5F;
    const int column = static_cast<int>(std::floor(texel.x));
    const int row = static_cast<int>(std::floor(texel.y));
    if (column < 0 || row < 0 || column + 1 >= kAcross || row + 1 >= kAcross) return 1.0F;
    const auto key = [&](int x, int y) {
        return static_cast<float>(mask[static_cast<std::size_t>(y * kAcross + x)] & 0xFFFFU);
    };
    const float right = texel.x - static_cast<float>(column);
    const float down = texel.y - static_cast<float>(row);
    const float upper = key(column, row) * (1.0F - right) + key(column + 1, row) * right;
    const float lower = key(column, row + 1) * (1.0F - right) + key(column + 1, row + 1) * right;
    return (upper * (1.0F - down) + lower * down) / 255.0F;
}

// Fills in where in the picture; false where that is beside the eye or behind it.
template <std::size_t kValues>
bool put(const BendView& view, vec3 point, PictureCorner<kValues>& corner) {
    const vec4 clip = view.frame.view_projection * vec4(point, 1.0F);
    corner = {};
    // A point behind the nearest plane is left out, and all triangles it belongs to.
    if (clip.w <= 0.0F || clip.z < 0.0F) return false;
    const float share = 1.0F / clip.w;
    corner.at_px = 0.5F * (vec2(clip) * share + 1.0F) * vec2(view.frame.picture) * view.scale;
    corner.depth = clip.z * share;
    corner.away_mm = clip.w;
    return true;
}

}  // namespace

void bend_corners(std::span<const vec3> positions_mm, const BendView& view,
                  std::vector<ReliefCorner>& corners) {
    corners.resize(positions_mm.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec3 point = positions_mm[i];
        ReliefCorner& corner = corners[i];
        if (!put(view, point, corner)) continue;
        const InPlate from = place_in(view.frame.plate_from, point);
        const InPlate to = place_in(view.frame.plate_to, point);
        const vec2 in_from = texels_of(view.from, view.scale, from) / from.w;
        const vec2 in_to = texels_of(view.to, view.scale, to) / to.w;
        // So far from the foot the shadow is soft: a look a corner of the grid will do.
        corner.values = {in_from.x,
                         in_from.y,
                         in_to.x,
                         in_to.y,
                         share_at(view, from, to),
                         key_at(view.mask, in_mask(view.frame, point))};
    }
}

void bend_corners(const BendableMesh& mesh, const BendView& view, std::vector<SurfaceCorner>& corners) {
    corners.resize(mesh.positions_mm.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec3 point = mesh.positions_mm[i];
        SurfaceCorner& corner = corners[i];
        if (!put(view, point, corner)) continue;
        const InPlate from = place_in(view.frame.plate_from, point);
        const InPlate to = place_in(view.frame.plate_to, point);
        const vec2 in_from = texels_of(view.from, view.scale, from) / from.w;
        const vec2 in_to = texels_of(view.to, view.scale, to) / to.w;
        const vec2 mask = in_mask(view.frame, point);
        const float near_foot = smooth_step(-7.0F, -1.0F, point.y) * std::max(mesh.normals_up[i], 0.0F);
        corner.values = {in_from.x, in_from.y, in_to.x,  in_to.y, share_at(view, from, to),
                         mask.x,    mask.y,    near_foot};
    }
}

void order_relief(std::span<const Quad> cells, std::span<const ReliefCorner> corners, float nearest_mm,
                  ReliefOrder& order) {
    // The relief is coarse: where a mesh stands for the same thing, the mesh is to be seen.
    constexpr float kCoarseMm = 60.0F;
    struct Place {
        float away_mm;  // of its middle, four times
        std::uint32_t number;
    };
    std::vector<Place> behind;
    std::vector<Place> before;
    for (std::uint32_t number = 0; number < cells.size(); ++number) {
        float sum = 0.0F;
        float farthest = 0.0F;
        for (const std::uint32_t corner : cells[number]) {
            const float away = corners[corner].away_mm;
            sum += away;
            farthest = std::max(farthest, away);
        }
        (farthest + kCoarseMm < nearest_mm ? before : behind).push_back({sum, number});
    }
    order.quads.clear();
    for (std::vector<Place>* places : {&behind, &before}) {
        std::stable_sort(places->begin(), places->end(),
                         [](const Place& a, const Place& b) { return a.away_mm > b.away_mm; });
        for (const Place& place : *places)
            order.quads.push_back(cells[place.number]);
        if (places == &behind) order.behind = order.quads.size();
    }
}

}  // namespace onggi::render
