// The last picture of a view that the camera is cut from, laid over the first of the next. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/vulkan/vulkan_frame.h"

namespace onggi::render {

class ViewFade {
  public:
    // Binds something to the slot, which must not be empty.
    static void bind_placeholder(const VulkanFrame& frame);

    // Once a frame, before it is recorded. The device is idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);

    // Where this frame's picture of the scene is to be drawn, laid out as colour, because it may be the last
    // of its view; null: nowhere.
    [[nodiscard]] const vk::Image* keeps() const { return keeps_ ? &kept_ : nullptr; }
    // It was, and was last used so.
    void keep(VkCommandBuffer commands, const vk::ImageState& used);
    // What is left of the view before, inside the caller's pass.
    void draw(const VulkanFrame& frame) const;

  private:
    vk::Image kept_{};
    bool keeps_ = false;  // this frame's
    bool shows_ = false;  // the one that was kept
    bool has_ = false;    // there is one
};

}  // namespace onggi::render
