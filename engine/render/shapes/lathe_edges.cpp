#include "engine/render/shapes/lathe_edges.h"

#include <cmath>

namespace onggi::render {

void add_edge(const vec4& from, const vec4& to, std::vector<OutlinePiece>& edges) {
    if (edges.size() >= kMaxEdges) return;
    if (std::abs(from.x - to.x) + std::abs(from.y - to.y) < 0.02F) return;
    edges.push_back({.from = from, .to = to});
}

void add_grid_edges(std::span<const shaders::VertexData> vertices, int sectors, bool open_sides,
                    const EdgeView& view, std::vector<OutlinePiece>& edges) {
    const auto in_row = static_cast<std::size_t>(sectors) + 1;
    const std::size_t rows = vertices.size() / in_row;
    if (rows < 2) return;
    const Projector project(view);
    std::vector<vec4> below(in_row);
    std::vector<vec4> above(in_row);
    std::vector<char> front_below(in_row, 0);
    std::vector<char> front(in_row, 0);
    for (std::size_t s = 0; s < in_row; ++s)
        below[s] = project(vec3(vertices[s].place));
    for (std::size_t row = 0; row + 1 < rows; ++row) {
        const std::span<const shaders::VertexData> next = vertices.subspan((row + 1) * in_row, in_row);
        for (std::size_t s = 0; s < in_row; ++s)
            above[s] = project(vec3(next[s].place));
        for (std::size_t s = 0; s + 1 < in_row; ++s) {
            const vec2 rising(above[s + 1].x - below[s].x, above[s + 1].y - below[s].y);
            const vec2 falling(above[s].x - below[s + 1].x, above[s].y - below[s + 1].y);
            front[s] = rising.x * falling.y - rising.y * falling.x > 0.0F ? 1 : 0;
        }
        for (std::size_t s = 0; s + 1 < in_row; ++s) {
            // The edge below this face; the first row has no faces below it.
            if (front[s] != front_below[s]) add_edge(below[s], below[s + 1], edges);
            const char before = s > 0 ? front[s - 1] : (open_sides ? char{0} : front[in_row - 2]);
            if (front[s] != before) add_edge(below[s], above[s], edges);
        }
        if (open_sides && front[in_row - 2] != 0) add_edge(below[in_row - 1], above[in_row - 1], edges);
        below.swap(above);
        front_below.swap(front);
    }
}

}  // namespace onggi::render
