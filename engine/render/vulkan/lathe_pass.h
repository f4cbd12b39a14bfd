// The lathe, drawn by the device from its rings, with what it needs there. Main thread.
#pragma once

#include <cstdint>

#include "engine/core/result.h"
#include "engine/render/vulkan/vulkan_frame.h"

namespace onggi::render {

class LathePass {
  public:
    Result<void> create(const VulkanFrame& frame);
    void upload(const BuiltFrame& built) const;

    // The lathe, inside the caller's pass.
    void draw(const VulkanFrame& frame) const;

  private:
    static Result<void> upload_streaks(const VulkanFrame& frame);

    vk::Buffer outline_;
    vk::Buffer rows_;
    vk::Buffer vertices_;
    vk::Buffer normals_;
    vk::BufferView normal_texels_;
    vk::Buffer indices_;
};

}  // namespace onggi::render
