// What moves besides the clay: the tools. Main thread.
#pragma once

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
    // Inside the caller's pass.
    void draw(const FrameContext& frame, const Scene& scene) const;

  private:
    void draw_models(const FrameContext& frame, const Scene& scene) const;

    StillMeshes sphere_;
    MoverModels models_;
    vk::Pipeline pipeline_;  // of the models
};

}  // namespace onggi::render
