// An offscreen target: one image, drawn repeatedly, read back on request. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/vk/frame_target.h"
#include "engine/vk/image.h"
#include "engine/vk/timeline.h"

namespace onggi::vk {

class Offscreen final : public FrameTarget {
  public:
    static constexpr VkFormat kFormat = VK_FORMAT_R8G8B8A8_UNORM;

    // The device must outlive the target.
    static Result<std::unique_ptr<Offscreen>> create(const Device& device, VkExtent2D extent);
    ~Offscreen() override;
    Offscreen(const Offscreen&) = delete;
    Offscreen& operator=(const Offscreen&) = delete;

    [[nodiscard]] VkFormat format() const override { return kFormat; }
    [[nodiscard]] VkExtent2D extent() const override { return image_.extent(); }
    Result<std::optional<TargetImage>> begin() override;
    Result<void> end(VkCommandBuffer commands, std::span<const VkRect2D> changed) override;
    Result<void> wait() override { return timeline_.wait(*device_); }

    // Waits for the last frame and returns it: rows from the top, width x height x 4 bytes (red, green, blue,
    // alpha).
    Result<std::vector<std::uint8_t>> read_back();

  private:
    explicit Offscreen(const Device& device) : device_(&device) {}

    const Device* device_;
    Image image_;
    Timeline timeline_;
    std::uint64_t frames_begun_ = 0;
};

}  // namespace onggi::vk
