// What moves besides the clay: the tools. Main thread.
#pragma once

#include <cstdint>
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
    // Inside the caller's pass.
    void draw(const FrameContext& frame, const Scene& scene) const;

  private:
    // What is drawn of one mesh of a mover.
    struct Drawn {
        std::uint32_t first_index = 0;
        std::uint32_t index_count = 0;
    };
    void draw_models(const FrameContext& frame, const Scene& scene) const;

    StillMeshes sphere_;
    MoverModels models_;
    vk::Pipeline pipeline_;  // of the models
    std::vector<std::uint32_t> chosen_indices_;
    std::vector<Drawn> chosen_;  // of each mesh of each mover, where the host chooses
    vk::Buffer chosen_buffer_;
};

}  // namespace onggi::render
