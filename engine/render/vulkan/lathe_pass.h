// The lathe, drawn by the device from its rings, with what it needs there. Main thread.
#pragma once

#include <cstdint>

#include "engine/core/result.h"
#include "engine/render/vulkan/vulkan_frame.h"

namespace onggi::render {

class LathePass {
  public:
    Result<void> create(const VulkanFrame& frame);
    // Errors: no memory for the marks, where there are some.
    Result<void> upload(const VulkanFrame& frame);

    // The lathe, inside the caller's pass.
    void draw(const VulkanFrame& frame) const;

  private:
    Result<void> upload_marks(const VulkanFrame& frame);
    static Result<void> upload_streaks(const VulkanFrame& frame);

    vk::Buffer outline_;
    vk::Buffer rows_;
    vk::Buffer vertices_;
    vk::Buffer normals_;
    vk::BufferView normal_texels_;
    vk::Buffer indices_;
    vk::Buffer marks_;
    std::uint64_t marks_revision_ = 0;  // that it holds, 0: none
};

}  // namespace onggi::render
