#include "engine/render/shapes/prop_edges.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/render/shapes/projector.h"

namespace onggi::render {
namespace {

using Place = std::array<float, 3>;

// How far a chord may lie from the outline it stands for.
constexpr float kChordPx = 0.15F;

float from_chord_px(vec2 a, vec2 b, vec2 point) {
    const vec2 along = b - a;
    const vec2 to = point - a;
    const float square = std::max(glm::dot(along, along), 1e-6F);
    return glm::length(to - along * std::clamp(glm::dot(to, along) / square, 0.0F, 1.0F));
}

// A line through the picture as few pieces of an outline, which pass all of its points closely enough.
void add_chords(std::span<const vec4> points, std::vector<OutlinePiece>& edges) {
    std::size_t from = 0;
    for (std::size_t to = 1; to < points.size(); ++to) {
        const bool is_last = to + 1 == points.size();
        bool is_close = !is_last;
        for (std::size_t between = from + 1; is_close && between <= to; ++between)
            is_close = from_chord_px(points[from], points[to + 1], points[between]) < kChordPx;
        if (is_close) continue;
        add_edge(points[from], points[to], edges);
        from = to;
    }
}

}  // namespace

std::vector<MeshEdge> mesh_edges(const PropMesh& mesh) {
    // A corner is there several times where normals or colours differ on its sides.
    std::map<Place, std::uint32_t> corners;
    const auto corner_at = [&](std::uint32_t number) {
        const vec3& at = mesh.vertices[number].position_mm;
        return corners.emplace(Place{at.x, at.y, at.z}, number).first->second;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
    std::vector<MeshEdge> edges;
    for (std::uint32_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t face = i / 3;
        for (std::uint32_t side = 0; side < 3; ++side) {
            const std::uint32_t from = corner_at(mesh.indices[i + side]);
            const std::uint32_t to = corner_at(mesh.indices[i + (side + 1) % 3]);
            const auto [at, is_new] = known.emplace(std::minmax(from, to), edges.size());
            if (is_new) {
                edges.push_back({.corners = {from, to}, .faces = {face, face}});
            } else if (MeshEdge& edge = edges[at->second]; edge.faces[0] == edge.faces[1]) {
                edge.faces[1] = face;
            }
        }
    }
    return edges;
}

void add_prop_edges(const PlacedMesh& placed, std::span<const std::uint8_t> towards_eye,
                    std::span<const MeshEdge> mesh_edges, const InsidePot* pot, const EdgeView& view,
                    std::vector<OutlinePiece>& edges) {
    const auto place_of = [&](std::uint32_t corner) {
        return vec3(placed.place * vec4(placed.mesh.vertices[corner].position_mm, 1.0F));
    };
    // Of each corner the outline's edges there, of which a line goes on along one.
    constexpr std::uint32_t kNone = ~0U;
    std::vector<const MeshEdge*> outline;
    std::vector<std::array<std::uint32_t, 2>> at_corner(placed.mesh.vertices.size(), {kNone, kNone});
    for (const MeshEdge& edge : mesh_edges) {
        const bool is_border = edge.faces[0] == edge.faces[1];
        const std::uint8_t first = towards_eye[edge.faces[0]];
        if (is_border ? first == 0 : first == towards_eye[edge.faces[1]]) continue;
        if (pot != nullptr && pot->hides(place_of(edge.corners[0])) && pot->hides(place_of(edge.corners[1])))
            continue;
        const auto number = static_cast<std::uint32_t>(outline.size());
        for (const std::uint32_t corner : edge.corners)
            at_corner[corner][at_corner[corner][0] == kNone ? 0 : 1] = number;
        outline.push_back(&edge);
    }
    const Projector project(view);
    std::vector<std::uint8_t> is_done(outline.size(), 0);
    std::vector<vec4> line;
    for (std::uint32_t start = 0; start < outline.size(); ++start) {
        if (is_done[start] != 0) continue;
        // As far as it goes one way; what lies the other way is a line of its own.
        std::uint32_t corner = outline[start]->corners[0];
        const auto next_at = [&](std::uint32_t at) {
            for (const std::uint32_t next : at_corner[at]) {
                if (next != kNone && is_done[next] == 0) return next;
            }
            return kNone;
        };
        line.assign(1, project(place_of(corner)));
        for (std::uint32_t now = start; now != kNone; now = next_at(corner)) {
            is_done[now] = 1;
            const auto& ends = outline[now]->corners;
            corner = ends[0] == corner ? ends[1] : ends[0];
            line.push_back(project(place_of(corner)));
        }
        add_chords(line, edges);
    }
}

}  // namespace onggi::render
