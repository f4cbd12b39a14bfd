// What of hands and tools the processor draws in a frame: those of their faces that can be seen, which a GPU
// finds by itself, and their outlines. Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/render/prop.h"
#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/prop_edges.h"

namespace onggi::render {

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
