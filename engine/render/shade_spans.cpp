#include "engine/render/shade_spans.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

constexpr int kBandPx = 8;

// What of a line at height y lies inside a convex polygon.
Covered across(std::span<const dvec2> polygon, double y) {
    double left = 1e9;
    double right = -1e9;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec2& a = polygon[i];
        const dvec2& b = polygon[(i + 1) % polygon.size()];
        if (std::min(a.y, b.y) > y || std::max(a.y, b.y) < y || a.y == b.y) continue;
        const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
        left = std::min(left, x);
        right = std::max(right, x);
    }
    return {static_cast<float>(left), static_cast<float>(right)};
}

}  // namespace

std::vector<Covered> covered_by_lathe(std::span<const shaders::VertexData> vertices, std::size_t rows,
                                      int sectors, const Camera& camera, int width_px, int height_px) {
    std::vector<Covered> lines(static_cast<std::size_t>(std::max(height_px, 0)));
    const mat4 matrix = view_projection(camera, width_px, height_px);
    const auto in_row = static_cast<std::size_t>(sectors) + 1;
    vec2 left_before(0.0F);
    vec2 right_before(0.0F);
    for (std::size_t row = 0; row < rows && (row + 1) * in_row <= vertices.size(); ++row) {
        vec2 left(1e9F, 0.0F);
        vec2 right(-1e9F, 0.0F);
        for (const shaders::VertexData& vertex : vertices.subspan(row * in_row, in_row)) {
            const vec4 clip = matrix * vec4(vec3(vertex.place), 1.0F);
            if (clip.w <= camera.near_mm) return std::vector<Covered>(lines.size());
            const vec2 pixel((0.5F + 0.5F * clip.x / clip.w) * static_cast<float>(width_px),
                             (0.5F + 0.5F * clip.y / clip.w) * static_cast<float>(height_px));
            if (pixel.x < left.x) left = pixel;
            if (pixel.x > right.x) right = pixel;
        }
        if (row > 0) {
            // The ends of two rings are the corners of a piece of pot; a line through both sides passes it.
            const float top = std::max(std::min(left.y, left_before.y), std::min(right.y, right_before.y));
            const float low = std::min(std::max(left.y, left_before.y), std::max(right.y, right_before.y));
            const auto first = static_cast<int>(std::ceil(std::max(top - 0.5F, 0.0F)));
            for (int y = first; y < height_px && static_cast<float>(y) + 0.5F <= low; ++y) {
                const auto at = [&](vec2 a, vec2 b) {
                    const float run = b.y - a.y;
                    const float share =
                        std::abs(run) > 1e-3F
                            ? std::clamp((static_cast<float>(y) + 0.5F - a.y) / run, 0.0F, 1.0F)
                            : 0.5F;
                    return a.x + share * (b.x - a.x);
                };
                Covered& line = lines[static_cast<std::size_t>(y)];
                const Covered here{at(left_before, left), at(right_before, right)};
                if (here.right - here.left > line.right - line.left) line = here;
            }
        }
        left_before = left;
        right_before = right;
    }
    return lines;
}

std::vector<vec4> shade_rects(std::span<const dvec2> outline, std::span<const Covered> covered, int width_px,
                              int height_px) {
    std::vector<vec4> rects;
    if (outline.size() < 3) return rects;
    const auto [lowest, highest] = std::minmax_element(
        outline.begin(), outline.end(), [](const dvec2& a, const dvec2& b) { return a.y < b.y; });
    const int first = std::clamp(static_cast<int>(std::floor(lowest->y)), 0, height_px);
    const int end = std::clamp(static_cast<int>(std::ceil(highest->y)), 0, height_px);
    const auto width = static_cast<float>(width_px);
    for (int y0 = first; y0 < end; y0 += kBandPx) {
        const int y1 = std::min(y0 + kBandPx, end);
        // A convex outline is widest in a band at one of its borders, or at a corner inside it.
        Covered span{1e9F, -1e9F};
        const auto widen = [&](const Covered& line) {
            span.left = std::min(span.left, line.left);
            span.right = std::max(span.right, line.right);
        };
        widen(across(outline, y0));
        widen(across(outline, y1));
        for (const dvec2& corner : outline) {
            if (corner.y >= y0 && corner.y <= y1)
                widen({static_cast<float>(corner.x), static_cast<float>(corner.x)});
        }
        span.left = std::clamp(std::floor(span.left), 0.0F, width);
        span.right = std::clamp(std::ceil(span.right), 0.0F, width);
        if (span.right <= span.left) continue;
        Covered pot{-1e9F, 1e9F};
        for (int y = y0; y < y1; ++y) {
            const Covered line = static_cast<std::size_t>(y) < covered.size()
                                     ? covered[static_cast<std::size_t>(y)]
                                     : Covered{};
            pot.left = std::max(pot.left, line.left);
            pot.right = std::min(pot.right, line.right);
        }
        pot.left = std::max(std::ceil(pot.left) + kCoveredMarginPx, span.left);
        pot.right = std::min(std::floor(pot.right) - kCoveredMarginPx, span.right);
        const auto top = static_cast<float>(y0);
        const auto low = static_cast<float>(y1);
        if (pot.right <= pot.left) {
            rects.emplace_back(span.left, top, span.right, low);
            continue;
        }
        if (pot.left > span.left) rects.emplace_back(span.left, top, pot.left, low);
        if (span.right > pot.right) rects.emplace_back(pot.right, top, span.right, low);
    }
    return rects;
}

}  // namespace onggi::render
