#include "engine/vk/offscreen.h"

#include "engine/vk/readback.h"

namespace onggi::vk {

Result<std::unique_ptr<Offscreen>> Offscreen::create(const Device& device, VkExtent2D extent) {
    std::unique_ptr<Offscreen> self(new Offscreen(device));
    auto image =
        Image::create(device, {.name = "offscreen target",
                               .format = kFormat,
                               .extent = extent,
                               .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                        VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    if (!image) return image.error();
    self->image_ = std::move(*image);
    auto timeline = Timeline::create(device, "offscreen frames");
    if (!timeline) return timeline.error();
    self->timeline_ = std::move(*timeline);
    return self;
}

Offscreen::~Offscreen() {
    vkDeviceWaitIdle(device_->handle());
}

Result<std::optional<TargetImage>> Offscreen::begin() {
    if (auto waited = wait(); !waited) return waited.error();
    return std::optional(TargetImage{.image = image_.handle(),
                                     .view = image_.view(),
                                     .extent = image_.extent(),
                                     .final_layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                     .frames_before = frames_begun_++});
}

Result<void> Offscreen::end(VkCommandBuffer commands, std::span<const VkRect2D> /*changed*/) {
    return timeline_.submit(*device_, commands, VK_NULL_HANDLE, VK_NULL_HANDLE);
}

Result<std::vector<std::uint8_t>> Offscreen::read_back() {
    if (auto waited = wait(); !waited) return waited.error();
    return read_pixels(*device_, image_);
}

}  // namespace onggi::vk
