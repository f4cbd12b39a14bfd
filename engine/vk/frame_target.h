// A target for finished frames: a window's swapchain, a window's memory or an offscreen image. Drawing code
// is the same with and without a display. Main thread only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/core/result.h"
#include "engine/vk/vulkan.h"

namespace onggi::vk {

// The image to draw this frame into; leave it in `final_layout`.
struct TargetImage {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkExtent2D extent{};
    VkImageLayout final_layout = VK_IMAGE_LAYOUT_UNDEFINED;
    // Number of frames that were drawn into this image before. 0: its contents are undefined. Otherwise it
    // holds the last of those frames, in `final_layout`.
    std::uint64_t frames_before = 0;
};

class FrameTarget {
  public:
    virtual ~FrameTarget() = default;

    [[nodiscard]] virtual VkFormat format() const = 0;
    [[nodiscard]] virtual VkExtent2D extent() const = 0;

    // Waits until the device has finished the previous frame, then returns the next image. Empty if no frame
    // is wanted now (minimised, or the size has just changed): call again later.
    virtual Result<std::optional<TargetImage>> begin() = 0;
    // Submits the recorded commands and presents the image. `changed` are the parts that may differ from what
    // the image held before. Precondition: begin() returned an image.
    virtual Result<void> end(VkCommandBuffer commands, std::span<const VkRect2D> changed) = 0;
    // Blocks until the device has finished all submissions.
    virtual Result<void> wait() = 0;
    // Sets the size of the next image, pixels: the window's, 0 x 0 while minimised. Offscreen images keep
    // theirs.
    virtual void resize(VkExtent2D /*extent*/) {}
};

}  // namespace onggi::vk
