// What of hands and tools the processor draws in a frame: those of their faces that can be seen, which a GPU
// finds by itself, and their outlines. Main thread.
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
#include "engine/render/shapes/lathe_profile.h"

namespace onggi::render {

// Which triangles of hands and tools are drawn, where the processor is the device and pays for each vertex
// and each triangle: those that look at the eye, and of them not those that are inside the pot for sure.
// What the picture shows is the same. mm.

// What is inside the pot and cannot be seen through its mouth. A ray from there to the eye that has left the
// pot's outline before it is as high as the rim has passed the wall.
class InsidePot {
  public:
    // Nothing, of a lathe that is cut open. The samples, which are the lathe's, must outlive it.
    InsidePot(const Lathe& lathe, const LatheSamples& samples, vec3 eye_mm);
    [[nodiscard]] bool hides(vec3 point_mm) const;

  private:
    const LatheSamples* samples_;
    vec3 eye_mm_;
    float slack_mm_;       // of the outline, by which dents and a throw off the centre move it
    float rim_mm_;         // a little below the top; 0: hides nothing
    float outside_2_mm2_;  // at that height, from the axis, squared
};

// A triangle's plane in its mesh's own frame: the normal outwards, not of unit length, and how far along it
// the triangle lies. One a triangle, in the order of the indices.
[[nodiscard]] std::vector<vec4> face_planes(const PropMesh& mesh);

// A mesh where a prop has it.
struct PlacedMesh {
    const PropMesh& mesh;
    std::span<const vec4> planes;
    const mat4& place;
};
// One entry a triangle: whether it looks at the eye, or is seen edge on.
[[nodiscard]] std::vector<std::uint8_t> faces_towards(const PlacedMesh& placed, vec3 eye_mm);
// Appends the indices of the triangles to draw, of those that look at the eye. `pot` may be null: there is
// none.
void choose_prop_faces(const PlacedMesh& placed, std::span<const std::uint8_t> towards_eye,
                       const InsidePot* pot, std::vector<std::uint32_t>& indices);

// The outlines of hands and tools: see lathe_edges.h. mm, pixels.

// Where two triangles of a mesh meet, wherever their corners are in its lists; or where one ends.
struct MeshEdge {
    std::array<std::uint32_t, 2> corners{};
    std::array<std::uint32_t, 2>
        faces{};  // numbers of triangles; the second is the first where there is none
};
// Once a mesh. Where more than two triangles meet, the first two do.
[[nodiscard]] std::vector<MeshEdge> mesh_edges(const PropMesh& mesh);

// `towards_eye`: see faces_towards(). Appends the edges between a triangle that looks at the eye and one that
// looks away, and the borders of what looks at it, but for what is inside the pot (null: there is none).
// Other hidden ones are there too: the depth test knows.
void add_prop_edges(const PlacedMesh& placed, std::span<const std::uint8_t> towards_eye,
                    std::span<const MeshEdge> mesh_edges, const InsidePot* pot, const EdgeView& view,
                    std::vector<OutlinePiece>& edges);

class PropModels {
  public:
    // Chooses faces, unless hidden ones are asked for, and appends outlines, where they are smoothed, to the
    // frame's. `built` must be this frame's. The first time with a library takes some ms.
    void choose(const Scene& scene, const RendererDesc& desc, const EdgeView& view, BuiltFrame& built);

    // Of all props, one after another; empty where none are chosen.
    [[nodiscard]] std::span<const std::uint32_t> chosen_indices() const { return chosen_indices_; }
    // Calls with each prop, the number of each of its meshes, and the indices of the triangles to draw of
    // that: some of the chosen ones, or all of the mesh's own.
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
    // Of a mesh: the planes of its faces, see face_planes(), and its edges.
    struct Known {
        std::vector<vec4> planes;
        std::vector<MeshEdge> edges;
    };
    struct Chosen {
        std::size_t first = 0;
        std::size_t count = 0;
    };
    void learn(const std::shared_ptr<const PropLibrary>& library);
    // One a mesh; empty for a model that the library does not have.
    [[nodiscard]] std::span<const Known> known_of(std::size_t model) const;

    std::shared_ptr<const PropLibrary> library_;
    std::vector<std::vector<Known>> known_;
    std::vector<std::uint32_t> chosen_indices_;
    std::vector<Chosen> chosen_;  // of each mesh of each prop; empty: not chosen
};

}  // namespace onggi::render
