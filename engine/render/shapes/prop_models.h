// Selects the visible faces and the silhouettes of hands and tools for the CPU backend; a GPU culls by
// itself. Main thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/render/prop.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/lathe_edges.h"
#include "engine/render/shapes/lathe_mesh.h"

namespace onggi::render {

// Culling for a software device, which pays for each vertex and each triangle: keeps triangles that face the
// eye, except those certainly inside the pot. The picture does not change. mm.

// Occlusion test for points inside the pot that cannot be seen through its mouth: the ray to the eye leaves
// the pot's outline below the height of the rim, so it passes through the wall.
class InsidePot {
  public:
    // Hides nothing for a lathe that is cut open. `samples`, the lathe's, must outlive this object.
    InsidePot(const Lathe& lathe, const LatheSamples& samples, vec3 eye_mm);
    [[nodiscard]] bool hides(vec3 point_mm) const;

  private:
    const LatheSamples* samples_;
    vec3 eye_mm_;
    float slack_mm_;       // maximum displacement of the outline by dents and an off-centre throw
    float rim_mm_;         // a little below the top; 0: hides nothing
    float outside_2_mm2_;  // squared radius of the outside at that height
};

// Returns a triangle's plane in its mesh's frame: the outward normal of length 1, or 0 without an area, and
// the plane's offset along it. One per triangle, in the order of the indices.
[[nodiscard]] std::vector<vec4> face_planes(const PropMesh& mesh);

// A mesh with the transform of its prop.
struct PlacedMesh {
    const PropMesh& mesh;
    std::span<const vec4> planes;
    const mat4& place;
};
// Returns for each triangle whether it faces the eye or is edge-on.
[[nodiscard]] std::vector<std::uint8_t> faces_towards(const PlacedMesh& placed, vec3 eye_mm);
// Appends the indices of the triangles to draw, chosen from those that face the eye. `pot` may be null: no
// pot.
void choose_prop_faces(const PlacedMesh& placed, std::span<const std::uint8_t> towards_eye,
                       const InsidePot* pot, std::vector<std::uint32_t>& indices);

// The silhouettes of hands and tools, see lathe_edges.h. mm, pixels.

// An edge between two triangles, found by their vertices' positions; or a border of one triangle.
struct MeshEdge {
    std::array<std::uint32_t, 2> corners{};
    std::array<std::uint32_t, 2>
        faces{};  // indices of the triangles; the second equals the first where there is one only
};
// Run once per mesh. If more than two triangles share an edge, the first two count.
[[nodiscard]] std::vector<MeshEdge> mesh_edges(const PropMesh& mesh);

// `towards_eye`: see faces_towards(). Appends the edges between triangles that face the eye and triangles
// that face away, and the borders of those that face it, except those inside the pot (null: no pot). Other
// hidden edges are included: the depth test rejects them.
void add_prop_edges(const PlacedMesh& placed, std::span<const std::uint8_t> towards_eye,
                    std::span<const MeshEdge> mesh_edges, const InsidePot* pot, const EdgeView& view,
                    std::vector<OutlinePiece>& edges);

class PropModels {
  public:
    // Chooses faces (unless desc.draws_hidden_faces) and appends silhouettes (if they are smoothed) to the
    // frame's. `built` must be this frame's. The first call with a library takes some ms.
    void choose(const Scene& scene, const RendererDesc& desc, const EdgeView& view, BuiltFrame& built);

    // The chosen indices of all props, back to back; empty if nothing was chosen.
    [[nodiscard]] std::span<const std::uint32_t> chosen_indices() const { return chosen_indices_; }
    // Calls `visit` with each prop, the number of each of its meshes, and the indices of the triangles to
    // draw: the chosen ones, or all of the mesh's.
    template <typename Visit>
    void for_parts(const Scene& scene, Visit visit) const {
        std::size_t number = 0;
        for (const Prop& prop : scene.props) {
            for (std::size_t mesh = 0; mesh < known_of(prop.model).size(); ++mesh) {
                std::span<const std::uint32_t> indices((*library_)[prop.model].meshes[mesh].indices);
                if (!chosen_.empty()) {
                    const Chosen& chosen = chosen_[number++];
                    indices = chosen_indices().subspan(chosen.first, chosen.count);
                }
                visit(prop, mesh, indices);
            }
        }
    }

  private:
    // Precomputed for a mesh: the planes of its faces, see face_planes(), and its edges.
    struct Known {
        std::vector<vec4> planes;
        std::vector<MeshEdge> edges;
    };
    struct Chosen {
        std::size_t first = 0;
        std::size_t count = 0;
    };
    void learn(const std::shared_ptr<const PropLibrary>& library);
    // One entry per mesh; empty for a model that is not in the library.
    [[nodiscard]] std::span<const Known> known_of(std::size_t model) const;

    std::shared_ptr<const PropLibrary> library_;
    std::vector<std::vector<Known>> known_;
    std::vector<std::uint32_t> chosen_indices_;
    std::vector<Chosen> chosen_;  // for each mesh of each prop; empty: not chosen
};

}  // namespace onggi::render
