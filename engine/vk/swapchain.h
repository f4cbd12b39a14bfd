// A window's images, as a frame target: made again when the window changes size, silent while it is
// minimised. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/vk/frame_target.h"
#include "engine/vk/timeline.h"

namespace onggi::vk {

// Owns a surface that a window made. The instance must outlive it, and it the swapchain.
class Surface {
  public:
    Surface(VkInstance instance, VkSurfaceKHR surface) : instance_(instance), surface_(surface) {}
    ~Surface() {
        if (surface_ != VK_NULL_HANDLE) vkDestroySurfaceKHR(instance_, surface_, nullptr);
    }
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;
    [[nodiscard]] VkSurfaceKHR handle() const { return surface_; }

  private:
    VkInstance instance_;
    VkSurfaceKHR surface_;
};

class Swapchain final : public FrameTarget {
  public:
    // extent: of the window's framebuffer, in pixels; what the surface says goes first.
    static Result<std::unique_ptr<Swapchain>> create(const Device& device, const Surface& surface,
                                                     VkExtent2D extent);
    ~Swapchain() override;
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    // The window has this many pixels now: 0 x 0 while minimised.
    void resize(VkExtent2D extent);

    [[nodiscard]] VkFormat format() const override { return format_.format; }
    [[nodiscard]] VkExtent2D extent() const override { return extent_; }
    Result<std::optional<TargetImage>> begin() override;
    Result<void> end(VkCommandBuffer commands) override;
    Result<void> wait() override { return timeline_.wait(*device_); }

    // Whether the driver will say when the last image is on the screen; once for each.
    [[nodiscard]] bool awaits_showing() const {
        return device_->wait_for_present() != nullptr && presented_ > shown_;
    }
    // Until it is, or this long. Precondition: awaits_showing().
    Result<bool> wait_until_shown(std::uint64_t most_ns);

  private:
    struct Frame {
        VkImage image = VK_NULL_HANDLE;
        Unique<VkImageView, vkDestroyImageView> view;
        Semaphore drawn;  // one an image: the one before it may still be waited on by the screen
        std::uint64_t begun = 0;
    };

    Swapchain(const Device& device, const Surface& surface) : device_(&device), surface_(surface.handle()) {}
    Result<void> choose_format();
    // False while the window has no pixels.
    Result<bool> rebuild();
    [[nodiscard]] VkExtent2D wanted_extent(const VkSurfaceCapabilitiesKHR& can) const;
    // Whether another swapchain would suit the surface better than this one, which is said to be suboptimal.
    Result<bool> is_of_another_size() const;
    Result<void> make_frames();
    void drop_frames();

    const Device* device_;
    VkSurfaceKHR surface_;
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    VkSurfaceFormatKHR format_{};
    VkExtent2D extent_{};
    VkExtent2D wanted_{};
    bool is_current_ = false;
    std::vector<Frame> frames_;
    std::uint32_t frame_ = 0;      // the image that begin() gave
    std::uint64_t presented_ = 0;  // how many images of this swapchain; the last one's number
    std::uint64_t shown_ = 0;      // the last one that was waited for
    Semaphore acquired_;           // one is enough for one frame in flight
    Timeline timeline_;
};

}  // namespace onggi::vk
