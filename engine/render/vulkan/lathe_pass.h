// The lathe, drawn by the device from its rings, with what it needs there. Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/vulkan/vulkan_frame.h"

namespace onggi::render {

class LathePass {
  public:
    Result<void> create(const VulkanFrame& frame);
    // What has changed since the frame before, which has left the device. Errors: no memory for the marks,
    // where there are some.
    Result<void> upload(const VulkanFrame& frame);

    // The lathe, inside the caller's pass.
    void draw(const VulkanFrame& frame) const;

  private:
    Result<void> upload_marks(const VulkanFrame& frame);
    static Result<void> upload_streaks(const VulkanFrame& frame);

    // A buffer, and what was written to it: the host does not read it back, where that is slow.
    struct Kept {
        vk::Buffer buffer;
        std::vector<std::byte> there;
        void write(const VulkanFrame& frame, std::span<const std::byte> bytes);
    };

    Kept outline_;
    Kept rows_;
    Kept vertices_;
    Kept normals_;
    vk::BufferView normal_texels_;
    Kept indices_;
    vk::Buffer marks_;
    std::uint64_t marks_revision_ = 0;  // that it holds, 0: none
};

}  // namespace onggi::render
