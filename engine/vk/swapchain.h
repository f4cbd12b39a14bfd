// A window's images as a frame target: re-created when the window's size changes, returns no image while it
// is minimised. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/vk/frame_target.h"
#include "engine/vk/timeline.h"

namespace onggi::vk {

// Owns a surface that a window created. The instance must outlive the surface, and the surface the swapchain.
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
    // extent: of the window's framebuffer, in pixels; the surface's own extent takes precedence.
    static Result<std::unique_ptr<Swapchain>> create(const Device& device, const Surface& surface,
                                                     VkExtent2D extent);
    ~Swapchain() override;
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    void resize(VkExtent2D extent) override;

    [[nodiscard]] VkFormat format() const override { return format_.format; }
    [[nodiscard]] VkExtent2D extent() const override { return extent_; }
    Result<std::optional<TargetImage>> begin() override;
    Result<void> end(VkCommandBuffer commands, std::span<const VkRect2D> changed) override;
    Result<void> wait() override { return timeline_.wait(*device_); }

    // Whether the driver will report that the last image is on the screen and the wait for it is still due.
    [[nodiscard]] bool awaits_showing() const {
        return device_->wait_for_present() != nullptr && presented_ > shown_;
    }
    // Waits until it is, or until the timeout. Returns whether it is. Precondition: awaits_showing().
    Result<bool> wait_until_shown(std::uint64_t most_ns);

  private:
    struct Frame {
        VkImage image = VK_NULL_HANDLE;
        Unique<VkImageView, vkDestroyImageView> view;
        Semaphore drawn;  // one per image: the presentation of the previous image may still wait on its own
        std::uint64_t begun = 0;
    };

    Swapchain(const Device& device, const Surface& surface) : device_(&device), surface_(surface.handle()) {}
    Result<void> choose_format();
    // Returns false while the window has no pixels.
    Result<bool> rebuild();
    [[nodiscard]] VkExtent2D wanted_extent(const VkSurfaceCapabilitiesKHR& can) const;
    // Whether a new swapchain would have another size, after this one was reported to be suboptimal.
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
    std::uint32_t frame_ = 0;      // the image that begin() returned
    std::uint64_t presented_ = 0;  // number of images presented by this swapchain; also the last one's id
    std::uint64_t shown_ = 0;      // id of the last image that was waited for
    Semaphore acquired_;           // one frame in flight needs only one
    Timeline timeline_;
};

}  // namespace onggi::vk
