// Hands and tools, drawn by the device. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame/mesh_buffers.h"
#include "engine/render/vulkan/vulkan_frame.h"

namespace onggi::render {

class PropPass {
  public:
    Result<void> create(const VulkanFrame& frame);
    // The library of the scene onto the device, if it is another one. The device is idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);
    // The scene's, inside the caller's pass; those of a model that the library does not have are left out.
    void draw(const VulkanFrame& frame, const Scene& scene) const;

  private:
    // Where a mesh lies in the buffers.
    struct Range {
        std::uint32_t first_index = 0;
        std::uint32_t index_count = 0;
        std::int32_t first_vertex = 0;
    };

    vk::Pipeline pipeline_;
    MeshBuffers buffers_;
    std::vector<std::vector<Range>> ranges_;  // of each mesh of each model
    std::shared_ptr<const PropLibrary> uploaded_;
};

}  // namespace onggi::render
