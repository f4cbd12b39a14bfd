#include "engine/render/pixels/bendable_mesh.h"

#include <map>
#include <utility>

namespace onggi::render {
namespace {

// Cuts triangles in two at the middle of their longest edge until none is too long. Whether an edge is cut is
// a matter of its own length, so both triangles at it cut it at the same point.
class Cutter {
  public:
    Cutter(BendableMesh& mesh, float longest_mm) : mesh_(mesh), longest_mm_(longest_mm) {}

    void add(const Corners& triangle) {
        std::vector<Corners> waiting{triangle};
        while (!waiting.empty()) {
            const Corners now = waiting.back();
            waiting.pop_back();
            const std::size_t longest = longest_edge(now);
            const std::uint32_t from = now[longest];
            const std::uint32_t to = now[(longest + 1) % 3];
            const std::uint32_t other = now[(longest + 2) % 3];
            if (length_mm(from, to) <= longest_mm_) {
                mesh_.triangles.push_back(now);
                continue;
            }
            const std::uint32_t middle = middle_of(from, to);
            waiting.push_back({from, middle, other});
            waiting.push_back({middle, to, other});
        }
    }

  private:
    [[nodiscard]] float length_mm(std::uint32_t a, std::uint32_t b) const {
        return glm::length(mesh_.positions_mm[a] - mesh_.positions_mm[b]);
    }
    [[nodiscard]] std::size_t longest_edge(const Corners& triangle) const {
        std::size_t longest = 0;
        for (std::size_t edge = 1; edge < 3; ++edge) {
            if (length_mm(triangle[edge], triangle[(edge + 1) % 3]) >
                length_mm(triangle[longest], triangle[(longest + 1) % 3]))
                longest = edge;
        }
        return longest;
    }
    std::uint32_t middle_of(std::uint32_t a, std::uint32_t b) {
        const auto number = static_cast<std::uint32_t>(mesh_.positions_mm.size());
        const auto [at, is_new] = middles_.emplace(std::minmax(a, b), number);
        if (is_new) {
            mesh_.positions_mm.push_back(0.5F * (mesh_.positions_mm[a] + mesh_.positions_mm[b]));
            mesh_.normals_up.push_back(0.5F * (mesh_.normals_up[a] + mesh_.normals_up[b]));
        }
        return at->second;
    }

    BendableMesh& mesh_;
    float longest_mm_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

}  // namespace

BendableMesh bendable_mesh(const StillLife& still_life, float longest_mm) {
    BendableMesh mesh;
    Cutter cutter(mesh, longest_mm);
    for (const StillLife::Part& part : still_life.parts) {
        if (part.in_relief) continue;
        const Mesh& shape = part.bent_mesh ? *part.bent_mesh : *part.mesh;
        const auto first = static_cast<std::uint32_t>(mesh.positions_mm.size());
        for (const Mesh::Vertex& vertex : shape.vertices) {
            mesh.positions_mm.push_back(part.position_mm + vertex.position_mm);
            mesh.normals_up.push_back(vertex.normal.y);
        }
        const std::vector<std::uint32_t>& indices = shape.indices;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
            cutter.add({first + indices[i], first + indices[i + 1], first + indices[i + 2]});
    }
    return mesh;
}

}  // namespace onggi::render
