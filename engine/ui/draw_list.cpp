#include "engine/ui/draw_list.h"

#include <algorithm>
#include <cmath>

#include "engine/core/hash.h"
#include "engine/math/eight_bits.h"

namespace onggi::ui {

std::uint32_t packed(const Colour& colour) {
    const auto eight = [](float value) { return std::uint32_t{eight_bits(value)}; };
    const float a = std::clamp(colour.a, 0.0F, 1.0F);
    return eight(colour.r * a) | eight(colour.g * a) << 8U | eight(colour.b * a) << 16U | eight(a) << 24U;
}

void DrawList::clear() {
    vertices_.clear();
    indices_.clear();
    runs_.clear();
}

std::uint32_t DrawList::begin(bool from_atlas) {
    if (runs_.empty() || runs_.back().from_atlas != from_atlas) {
        runs_.push_back({from_atlas, static_cast<std::uint32_t>(indices_.size()), 0});
    }
    return static_cast<std::uint32_t>(vertices_.size());
}

void DrawList::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    indices_.insert(indices_.end(), {a, b, c});
    runs_.back().index_count += 3;
}

void DrawList::add_box(const Rect& rect, const Colour& colour) {
    add_box(rect, {colour, colour, colour, colour});
}

void DrawList::add_box(const Rect& rect, const std::array<Colour, 4>& corners) {
    const std::uint32_t first = begin(false);
    vertices_.push_back({{rect.x, rect.y}, {}, packed(corners[0])});
    vertices_.push_back({{rect.right(), rect.y}, {}, packed(corners[1])});
    vertices_.push_back({{rect.right(), rect.bottom()}, {}, packed(corners[2])});
    vertices_.push_back({{rect.x, rect.bottom()}, {}, packed(corners[3])});
    triangle(first, first + 1, first + 2);
    triangle(first, first + 2, first + 3);
}

void DrawList::add_polygon(std::span<const vec2> corners, const Colour& colour) {
    if (corners.size() < 3) return;
    const std::uint32_t first = begin(false);
    for (const vec2& corner : corners)
        vertices_.push_back({corner, {}, packed(colour)});
    for (std::uint32_t i = 2; i < corners.size(); ++i)
        triangle(first, first + i - 1, first + i);
}

void DrawList::add_line(std::span<const vec2> points, float width_px, const Colour& colour) {
    if (points.size() < 2) return;
    const std::uint32_t first = begin(false);
    const std::uint32_t whole = packed(colour);
    const std::array<float, 4> offsets{-0.5F * width_px - 1.0F, -0.5F * width_px, 0.5F * width_px,
                                       0.5F * width_px + 1.0F};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const vec2 along = points[std::min(i + 1, points.size() - 1)] - points[i == 0 ? 0 : i - 1];
        const float length = glm::length(along);
        const vec2 across = length > 0.0F ? vec2(-along.y, along.x) / length : vec2(0.0F, 1.0F);
        for (std::size_t k = 0; k < offsets.size(); ++k)
            vertices_.push_back({points[i] + offsets[k] * across, {}, k == 1 || k == 2 ? whole : 0U});
    }
    for (std::uint32_t i = 0; i + 1 < points.size(); ++i) {
        const std::uint32_t row = first + 4 * i;
        for (std::uint32_t k = 0; k < 3; ++k) {
            triangle(row + k, row + k + 1, row + k + 5);
            triangle(row + k, row + k + 5, row + k + 4);
        }
    }
}

void DrawList::add_disc(vec2 centre, float radius_px, const Colour& colour) {
    constexpr int kCorners = 28;
    std::array<vec2, kCorners + 1> circle;
    for (std::size_t i = 0; i < circle.size(); ++i) {
        const float angle = kTurnF * static_cast<float>(i) / kCorners;
        circle[i] = centre + radius_px * vec2(std::cos(angle), std::sin(angle));
    }
    add_polygon(std::span(circle).first(kCorners), colour);
    add_line(circle, 0.5F, colour);
}

void DrawList::add_picture(vec2 corner_px, const Rect& in_atlas_px, float alpha) {
    if (alpha <= 0.0F) return;
    const vec2 corner = glm::round(corner_px);
    const Rect rect{corner.x, corner.y, in_atlas_px.width, in_atlas_px.height};
    const std::uint32_t first = begin(true);
    const std::uint32_t white = packed({1.0F, 1.0F, 1.0F, alpha});
    const Rect& from = in_atlas_px;
    vertices_.push_back({{rect.x, rect.y}, {from.x, from.y}, white});
    vertices_.push_back({{rect.right(), rect.y}, {from.right(), from.y}, white});
    vertices_.push_back({{rect.right(), rect.bottom()}, {from.right(), from.bottom()}, white});
    vertices_.push_back({{rect.x, rect.bottom()}, {from.x, from.bottom()}, white});
    triangle(first, first + 1, first + 2);
    triangle(first, first + 2, first + 3);
}

std::uint64_t DrawList::hash() const {
    StateHash hash;
    hash.add_bytes(std::as_bytes(std::span(vertices_)));
    hash.add_bytes(std::as_bytes(std::span(indices_)));
    for (const Run& run : runs_)
        hash.add_word(std::uint64_t{run.from_atlas} << 32U | run.index_count);
    return hash.value();
}

}  // namespace onggi::ui
