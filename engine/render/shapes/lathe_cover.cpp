#include "engine/render/shapes/lathe_cover.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
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
                    const float fraction =
                        std::abs(run) > 1e-3F
                            ? std::clamp((static_cast<float>(y) + 0.5F - a.y) / run, 0.0F, 1.0F)
                            : 0.5F;
                    return a.x + fraction * (b.x - a.x);
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

}  // namespace onggi::render
