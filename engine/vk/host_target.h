// A frame target in a window's own memory (HostSurface), for a software device: one image that keeps its
// contents, so that only changes are drawn and shown. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/vk/frame_target.h"
#include "engine/vk/host_surface.h"
#include "engine/vk/pipeline.h"
#include "engine/vk/timeline.h"

namespace onggi::vk {

class HostTarget final : public FrameTarget {
  public:
    // The device must outlive the target, and import memory of the host.
    // extent: of the window, in pixels.
    static Result<std::unique_ptr<HostTarget>> create(const Device& device,
                                                      std::unique_ptr<HostSurface> surface,
                                                      VkExtent2D extent);
    ~HostTarget() override;
    HostTarget(const HostTarget&) = delete;
    HostTarget& operator=(const HostTarget&) = delete;

    [[nodiscard]] VkFormat format() const override { return kFormat; }
    [[nodiscard]] VkExtent2D extent() const override { return extent_; }
    void resize(VkExtent2D extent) override { wanted_ = extent; }
    Result<std::optional<TargetImage>> begin() override;
    Result<void> end(VkCommandBuffer commands, std::span<const VkRect2D> changed) override;
    Result<void> wait() override { return timeline_.wait(*device_); }

  private:
    static constexpr VkFormat kFormat = VK_FORMAT_B8G8R8A8_UNORM;

    HostTarget(const Device& device, std::unique_ptr<HostSurface> surface, VkExtent2D extent)
        : device_(&device),
          surface_(std::move(surface)),
          wanted_(extent) {}
    Result<void> rebuild();
    Result<void> import(std::span<std::byte> memory, std::uint32_t types);
    void drop();

    const Device* device_;
    std::unique_ptr<HostSurface> surface_;
    VkExtent2D wanted_{};
    VkExtent2D extent_{};
    std::uint32_t row_px_ = 0;
    Unique<VkImage, vkDestroyImage> image_;
    Unique<VkDeviceMemory, vkFreeMemory> memory_;  // the surface's
    Unique<VkImageView, vkDestroyImageView> view_;
    std::uint64_t frames_begun_ = 0;
    Timeline timeline_;
};

}  // namespace onggi::vk
