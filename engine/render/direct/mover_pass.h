// Hands and tools, drawn by the device. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/mesh_buffers.h"
#include "engine/render/shapes/mover_models.h"

namespace onggi::render {

class MoverPass {
  public:
    Result<void> create(const FrameContext& frame);
    // The library of the scene onto the device, if it is another one. The device is idle.
    Result<void> fit(const FrameContext& frame, const Scene& scene);
    // What the models have chosen.
    Result<void> upload(const FrameContext& frame, const MoverModels& models);
    // The same inside the caller's pass.
    void draw(const FrameContext& frame, const Scene& scene, const MoverModels& models) const;

  private:
    // Where a mesh lies in the buffers.
    struct Range {
        std::uint32_t first_index = 0;
        std::int32_t first_vertex = 0;
    };

    vk::Pipeline pipeline_;
    MeshBuffers buffers_;
    std::vector<std::vector<Range>> ranges_;  // of each mesh of each model
    std::shared_ptr<const MoverLibrary> uploaded_;
    vk::Buffer chosen_;
};

}  // namespace onggi::render
