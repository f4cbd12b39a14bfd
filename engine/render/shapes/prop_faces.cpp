#include "engine/render/shapes/prop_faces.h"

#include <algorithm>
#include <cstddef>

#include "engine/render/shapes/lathe_vertices.h"

namespace onggi::render {
namespace {

float square(float value) {
    return value * value;
}

float from_axis_2_mm2(vec3 point) {
    return square(point.x) + square(point.z);
}

}  // namespace

InsidePot::InsidePot(const Lathe& lathe, const LatheSamples& samples, vec3 eye_mm)
    : samples_(&samples),
      eye_mm_(eye_mm) {
    // What is drawn are few rings and chords of their circles; the rim is rounded.
    constexpr float kDrawnMm = 1.5F;
    slack_mm_ = largest_offset_mm(lathe) + kDrawnMm;
    rim_mm_ = lathe.cut ? 0.0F : std::max(samples.height_mm - lathe.edge_rounding_mm - kDrawnMm, 0.0F);
    // The outline is a line between two samples; a ray may pass just above one of them.
    const std::size_t at = samples.at(rim_mm_);
    const std::size_t below = at > 0 ? at - 1 : 0;
    outside_2_mm2_ = square(std::max(samples.outer_mm[at], samples.outer_mm[below]) + slack_mm_);
}

bool InsidePot::hides(vec3 point_mm) const {
    if (!(point_mm.y > 0.0F && point_mm.y < rim_mm_ && eye_mm_.y > rim_mm_)) return false;
    const float inside_mm = samples_->outer_mm[samples_->at(point_mm.y)] - slack_mm_;
    if (inside_mm <= 0.0F || from_axis_2_mm2(point_mm) > square(inside_mm)) return false;
    const float fraction = (rim_mm_ - point_mm.y) / (eye_mm_.y - point_mm.y);
    return from_axis_2_mm2(point_mm + (eye_mm_ - point_mm) * fraction) > outside_2_mm2_;
}

std::vector<vec4> face_planes(const PropMesh& mesh) {
    std::vector<vec4> planes;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const vec3 a = mesh.vertices[mesh.indices[i]].position_mm;
        const vec3 b = mesh.vertices[mesh.indices[i + 1]].position_mm;
        const vec3 c = mesh.vertices[mesh.indices[i + 2]].position_mm;
        const vec3 normal = glm::cross(b - a, c - a);
        planes.emplace_back(normal, glm::dot(normal, a));
    }
    return planes;
}

std::vector<std::uint8_t> faces_towards(const PlacedMesh& placed, vec3 eye_mm) {
    const vec3 eye(glm::inverse(placed.place) * vec4(eye_mm, 1.0F));
    // A mirrored face is seen from what was its back.
    const float side = glm::determinant(mat3(placed.place)) < 0.0F ? -1.0F : 1.0F;
    std::vector<std::uint8_t> towards(placed.planes.size());
    std::transform(placed.planes.begin(), placed.planes.end(), towards.begin(), [&](const vec4& plane) {
        const vec3 normal(plane);
        // Of one that is seen edge on the device finds out.
        constexpr float kEdgeOnMm = 0.01F;
        const float towards_eye = side * (glm::dot(normal, eye) - plane.w);
        const bool looks_away =
            towards_eye < 0.0F && square(towards_eye) > square(kEdgeOnMm) * glm::dot(normal, normal);
        return static_cast<std::uint8_t>(looks_away ? 0 : 1);
    });
    return towards;
}

void choose_prop_faces(const PlacedMesh& placed, std::span<const std::uint8_t> towards_eye,
                       const InsidePot* pot, std::vector<std::uint32_t>& indices) {
    const PropMesh& mesh = placed.mesh;
    const auto is_hidden = [&](std::uint32_t corner) {
        return pot->hides(vec3(placed.place * vec4(mesh.vertices[corner].position_mm, 1.0F)));
    };
    for (std::size_t face = 0; face < towards_eye.size(); ++face) {
        if (towards_eye[face] == 0) continue;
        const std::span<const std::uint32_t> corners = std::span(mesh.indices).subspan(3 * face, 3);
        if (pot != nullptr && std::all_of(corners.begin(), corners.end(), is_hidden)) continue;
        indices.insert(indices.end(), corners.begin(), corners.end());
    }
}

}  // namespace onggi::render
