#include "engine/render/shapes/lathe_faces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/render/shapes/projector.h"

namespace onggi::render {
namespace {

// The corners of a face: below, the next one below, above, the next one above.
using Corners = std::array<const shaders::VertexData*, 4>;

// Whether the shadow of a sphere may fall within margin_mm of a point; past_sphere() of shaders/surface.h.
bool may_be_in_shadow(const shaders::FrameData& frame, vec3 point, float margin_mm) {
    const vec3 light(frame.key_direction);
    return std::any_of(std::begin(frame.spheres), std::end(frame.spheres), [&](const vec4& sphere) {
        const vec3 to = vec3(sphere) - point;
        const float along = glm::dot(to, light);
        if (along < -margin_mm) return false;
        const float reach =
            sphere.w + std::max((along + margin_mm) * frame.key_direction.w, 0.5F) + margin_mm;
        return glm::dot(to, to) - along * along < reach * reach;
    });
}

bool may_be_in_shadow(const shaders::FrameData& frame, const Corners& corners) {
    const auto in_the_dark = [](const shaders::VertexData* corner) { return corner->place.w == 0.0F; };
    if (std::all_of(corners.begin(), corners.end(), in_the_dark)) return false;
    vec3 middle(0.0F);
    for (const shaders::VertexData* corner : corners)
        middle += 0.25F * vec3(corner->place);
    float reach_2_mm2 = 0.0F;
    for (const shaders::VertexData* corner : corners) {
        const vec3 to = vec3(corner->place) - middle;
        reach_2_mm2 = std::max(reach_2_mm2, glm::dot(to, to));
    }
    return may_be_in_shadow(frame, middle, std::sqrt(reach_2_mm2));
}

void add_face(std::size_t below, std::size_t in_row, std::vector<std::uint16_t>& indices) {
    const std::size_t above = below + in_row;
    for (const std::size_t index : {below, above, below + 1, below + 1, above, above + 1})
        indices.push_back(static_cast<std::uint16_t>(index));
}

// Twice the area of a triangle in the picture, y down: below 0 it turns counter-clockwise.
float turn_of(const vec4& a, const vec4& b, const vec4& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

void choose_faces(std::span<const shaders::VertexData> vertices, int sectors, const shaders::FrameData& frame,
                  const EdgeView& view, LatheFaces& faces) {
    faces.clear();
    const auto in_row = static_cast<std::size_t>(sectors) + 1;
    const std::size_t rows = vertices.size() / in_row;
    if (rows < 2) return;
    const Projector project(view);
    std::vector<vec4> pixels;
    pixels.reserve(vertices.size());
    for (const shaders::VertexData& vertex : vertices)
        pixels.push_back(project(vec3(vertex.place)));
    std::vector<std::uint16_t> near_spheres;
    constexpr float kEdgeOn = 0.05F;  // pixels squared, more than a rounded coordinate can turn it by
    for (std::size_t row = 0; row + 1 < rows; ++row) {
        for (std::size_t s = 0; s + 1 < in_row; ++s) {
            const std::size_t below = row * in_row + s;
            const std::size_t above = below + in_row;
            const vec4& corner = pixels[below + 1];
            const bool is_known =
                std::min(std::min(pixels[below].w, corner.w),
                         std::min(pixels[above].w, pixels[above + 1].w)) > view.camera.near_mm;
            const bool looks_away = turn_of(pixels[below], pixels[above], corner) > kEdgeOn &&
                                    turn_of(corner, pixels[above], pixels[above + 1]) > kEdgeOn;
            if (is_known && looks_away) continue;
            const bool is_near = may_be_in_shadow(
                frame, {&vertices[below], &vertices[below + 1], &vertices[above], &vertices[above + 1]});
            add_face(below, in_row, is_near ? near_spheres : faces.indices);
        }
    }
    faces.plain = static_cast<std::uint32_t>(faces.indices.size());
    faces.indices.insert(faces.indices.end(), near_spheres.begin(), near_spheres.end());
}

void take_all_faces(std::size_t rows, int sectors, LatheFaces& faces) {
    faces.clear();
    const auto in_row = static_cast<std::size_t>(sectors) + 1;
    for (std::size_t row = 0; row + 1 < rows; ++row) {
        for (std::size_t s = 0; s + 1 < in_row; ++s)
            add_face(row * in_row + s, in_row, faces.indices);
    }
}

}  // namespace onggi::render
