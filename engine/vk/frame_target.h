// Something that takes finished frames one after another. A window's swapchain and an unseen image are peers
// behind it, so that all drawing code is the same with and without a display. Main thread only.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/core/result.h"
#include "engine/vk/vulkan.h"

namespace onggi::vk {

// The image to draw this frame into; leave it in `final_layout`.
struct TargetImage {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkExtent2D extent{};
    VkImageLayout final_layout = VK_IMAGE_LAYOUT_UNDEFINED;
    // How many frames it was given for before. 0: its contents are undefined. Else it still is as the last of
    // them left it, in `final_layout`.
    std::uint64_t frames_before = 0;
};

class FrameTarget {
  public:
    virtual ~FrameTarget() = default;

    [[nodiscard]] virtual VkFormat format() const = 0;
    [[nodiscard]] virtual VkExtent2D extent() const = 0;

    // Waits until the frame before has left the device, then gives the next image; nothing when no frame is
    // wanted now (minimised, or the size has just changed: ask again).
    virtual Result<std::optional<TargetImage>> begin() = 0;
    // Submits what was recorded and shows it. Only after a begin() that gave an image.
    virtual Result<void> end(VkCommandBuffer commands) = 0;
    // Blocks until everything submitted is done.
    virtual Result<void> wait() = 0;
};

}  // namespace onggi::vk
