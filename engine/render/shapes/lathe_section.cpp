#include "engine/render/shapes/lathe_section.h"

namespace onggi::render {

std::size_t add_section(const LatheMeshInput& input, int sectors,
                        std::vector<shaders::VertexData>& vertices) {
    const std::size_t rows = input.rows.size();
    const auto in_row = static_cast<std::size_t>(sectors) + 1;
    if (rows < 2 || vertices.size() < rows * in_row) return 0;
    const std::size_t before = vertices.size();
    std::size_t summit = 0;
    for (std::size_t row = 1; row < rows; ++row) {
        if (input.rows[row].place.y > input.rows[summit].place.y) summit = row;
    }
    for (const std::size_t edge : {std::size_t{0}, in_row - 1}) {
        const float side = edge == 0 ? -1.0F : 1.0F;
        const auto corner = [&](std::size_t row, float across) {
            const vec4& place = vertices[row * in_row + edge].place;
            return shaders::VertexData{
                .place = vec4(vec3(place), 1.0F),
                .lean = vec4(side * input.rows[row].place.x, input.rows[row].water.z, across, 0.0F)};
        };
        // Two chains from the base to the top of the rim: up the outside, and from the axis over the floor up
        // the inside. Whichever is lower takes the next step, so that triangles stay level.
        std::vector<shaders::VertexData> outer;
        std::vector<shaders::VertexData> inner;
        for (std::size_t row = 0; row <= summit; ++row)
            outer.push_back(corner(row, 0.0F));
        inner.push_back({.place = vec4(0.0F, 0.0F, 0.0F, 1.0F), .lean = vec4(0.0F, 0.0F, 0.5F, 0.0F)});
        for (std::size_t row = rows; row-- > summit;)
            inner.push_back(corner(row, 1.0F));
        std::size_t o = 0;
        std::size_t i = 0;
        while (o + 1 < outer.size() || i + 1 < inner.size()) {
            const bool outer_next = i + 1 >= inner.size() ||
                                    (o + 1 < outer.size() && outer[o + 1].place.y <= inner[i + 1].place.y);
            const shaders::VertexData& next = outer_next ? outer[o + 1] : inner[i + 1];
            if (vertices.size() - before + 3 > kMaxSectionVertices) return vertices.size() - before;
            const shaders::VertexData a = outer[o];
            const shaders::VertexData b = inner[i];
            vertices.push_back(a);
            vertices.push_back(b);
            vertices.push_back(next);
            (outer_next ? o : i) += 1;
        }
    }
    return vertices.size() - before;
}

}  // namespace onggi::render
