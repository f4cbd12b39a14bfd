// What moves besides the clay: the tools. Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame_context.h"
#include "engine/render/mover_models.h"
#include "engine/render/still_meshes.h"

namespace onggi::render {

class MoverPass {
  public:
    Result<void> create(const FrameContext& frame);
    // The library of the scene onto the device, if it is another one. The device is idle.
    Result<void> fit(const FrameContext& frame, const Scene& scene);
    // Where the host chooses what is drawn of the models, and where outlines are smoothed: theirs are
    // appended to the frame's. `frame.built` must be this frame's.
    Result<void> upload(FrameContext& frame, const Scene& scene);
    // Inside the caller's pass; without the models where the host draws them.
    void draw(const FrameContext& frame, const Scene& scene) const;

    // Calls with each mover and each of its meshes, and the indices of the triangles to draw of that.
    template <typename Visit>
    void for_parts(const Scene& scene, Visit visit) const {
        std::size_t number = 0;
        for (const Mover& mover : scene.movers) {
            for (std::size_t mesh = 0; mesh < models_.ranges(mover.model).size(); ++mesh) {
                const MoverMesh& own = (*scene.mover_library)[mover.model].meshes[mesh];
                std::span<const std::uint32_t> indices(own.indices);
                if (!chosen_.empty()) {
                    const Drawn& drawn = chosen_[number++];
                    indices = std::span(chosen_indices_).subspan(drawn.first_index, drawn.index_count);
                }
                visit(mover, own, indices);
            }
        }
    }

  private:
    // What is drawn of one mesh of a mover.
    struct Drawn {
        std::uint32_t first_index = 0;
        std::uint32_t index_count = 0;
    };
    Result<void> create_pipeline(const FrameContext& frame);
    void draw_models(const FrameContext& frame, const Scene& scene) const;

    StillMeshes sphere_;
    MoverModels models_;
    vk::Pipeline pipeline_;  // of the models; none where the host draws them
    std::vector<std::uint32_t> chosen_indices_;
    std::vector<Drawn> chosen_;  // of each mesh of each mover, where the host chooses
    vk::Buffer chosen_buffer_;
};

}  // namespace onggi::render
