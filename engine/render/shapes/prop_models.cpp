#include "engine/render/shapes/prop_models.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "engine/render/shapes/lathe_edges.h"
#include "engine/render/shapes/lathe_mesh.h"

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
    // The drawn pot has few rings and chords instead of circles, and a rounded rim.
    constexpr float kDrawnMm = 1.5F;
    slack_mm_ = largest_offset_mm(lathe) + kDrawnMm;
    rim_mm_ = lathe.cut ? 0.0F : std::max(samples.height_mm - lathe.edge_rounding_mm - kDrawnMm, 0.0F);
    // The outline is interpolated between two samples; a ray may pass just above one of them.
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
        constexpr float kLeastMm2 = 1e-12F;
        const vec3 unit = normal / std::max(glm::length(normal), kLeastMm2);
        planes.emplace_back(unit, glm::dot(unit, a));
    }
    return planes;
}

std::vector<std::uint8_t> faces_towards(const PlacedMesh& placed, vec3 eye_mm) {
    const vec3 eye(glm::inverse(placed.place) * vec4(eye_mm, 1.0F));
    // A mirror transform turns back faces into front faces.
    const float side = glm::determinant(mat3(placed.place)) < 0.0F ? -1.0F : 1.0F;
    std::vector<std::uint8_t> towards(placed.planes.size());
    const vec4 away(side * eye, -side);
    std::transform(placed.planes.begin(), placed.planes.end(), towards.begin(), [&](const vec4& plane) {
        // Keep nearly edge-on faces; the rasteriser culls them exactly.
        constexpr float kEdgeOnMm = 0.01F;
        return static_cast<std::uint8_t>(glm::dot(plane, away) >= -kEdgeOnMm ? 1 : 0);
    });
    return towards;
}

void choose_prop_faces(const PlacedMesh& placed, std::span<const std::uint8_t> towards_eye,
                       const InsidePot* pot, std::vector<std::uint32_t>& indices) {
    const PropMesh& mesh = placed.mesh;
    // Six triangles share a corner on average: each is looked at once.
    enum : std::uint8_t { kUnknown, kSeen, kHidden };
    std::vector<std::uint8_t> known(pot != nullptr ? mesh.vertices.size() : 0, kUnknown);
    const auto is_hidden = [&](std::uint32_t corner) {
        if (known[corner] == kUnknown) {
            const vec3 place(placed.place * vec4(mesh.vertices[corner].position_mm, 1.0F));
            known[corner] = pot->hides(place) ? kHidden : kSeen;
        }
        return known[corner] == kHidden;
    };
    for (std::size_t face = 0; face < towards_eye.size(); ++face) {
        if (towards_eye[face] == 0) continue;
        const std::span<const std::uint32_t> corners = std::span(mesh.indices).subspan(3 * face, 3);
        if (pot != nullptr && std::all_of(corners.begin(), corners.end(), is_hidden)) continue;
        indices.insert(indices.end(), corners.begin(), corners.end());
    }
}

namespace {

using Place = std::array<float, 3>;

// Maximum distance of a chord from the silhouette it replaces.
constexpr float kChordPx = 0.15F;

float from_chord_px(vec2 a, vec2 b, vec2 point) {
    const vec2 along = b - a;
    const vec2 to = point - a;
    const float square = std::max(glm::dot(along, along), 1e-6F);
    return glm::length(to - along * std::clamp(glm::dot(to, along) / square, 0.0F, 1.0F));
}

// Simplifies a polyline to few segments that pass all its points closely enough.
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
    // A vertex appears several times if normals or colours differ between its faces.
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
    // The silhouette edges that meet at each vertex (two at most): polylines are chained through them.
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
        // Follows the silhouette in one direction; the other direction becomes a polyline of its own.
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

void PropModels::learn(const std::shared_ptr<const PropLibrary>& library) {
    if (library == library_) return;
    library_ = library;
    known_.clear();
    for (const PropModel& model : library ? *library : PropLibrary()) {
        std::vector<Known>& known = known_.emplace_back();
        for (const PropMesh& mesh : model.meshes)
            known.push_back({.planes = face_planes(mesh), .edges = mesh_edges(mesh)});
    }
}

std::span<const PropModels::Known> PropModels::known_of(std::size_t model) const {
    return model < known_.size() ? std::span<const Known>(known_[model]) : std::span<const Known>();
}

void PropModels::choose(const Scene& scene, const RendererDesc& desc, const EdgeView& view,
                        BuiltFrame& built) {
    learn(scene.prop_library);
    chosen_.clear();
    chosen_indices_.clear();
    if (desc.draws_hidden_faces && !desc.smooths_outlines) return;
    std::optional<InsidePot> inside;
    if (scene.lathe) inside.emplace(*scene.lathe, built.samples, scene.camera.eye_mm);
    const InsidePot* const pot = inside ? &*inside : nullptr;
    for (const Prop& prop : scene.props) {
        const std::span<const Known> known = known_of(prop.model);
        for (std::size_t mesh = 0; mesh < known.size(); ++mesh) {
            const PlacedMesh placed{(*library_)[prop.model].meshes[mesh], known[mesh].planes, prop.place};
            const std::vector<std::uint8_t> towards_eye = faces_towards(placed, scene.camera.eye_mm);
            if (desc.smooths_outlines)
                add_prop_edges(placed, towards_eye, known[mesh].edges, pot, view, built.edges);
            if (desc.draws_hidden_faces) continue;
            const std::size_t first = chosen_indices_.size();
            choose_prop_faces(placed, towards_eye, pot, chosen_indices_);
            chosen_.push_back({first, chosen_indices_.size() - first});
        }
    }
}

}  // namespace onggi::render
