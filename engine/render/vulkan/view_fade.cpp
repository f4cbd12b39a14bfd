#include "engine/render/vulkan/view_fade.h"

#include <utility>

namespace onggi::render {

void ViewFade::bind_placeholder(const VulkanFrame& frame) {
    vk::write_image(frame.device, frame.set(), shaders::kBindViewBefore, frame.images.mask.view(),
                    frame.pipelines.clamped.get());
}

Result<void> ViewFade::fit(const VulkanFrame& frame, const Scene& scene) {
    const VkExtent2D have = kept_.extent();
    const bool fits = have.width == frame.extent.width && have.height == frame.extent.height;
    shows_ = scene.fade_in.has_value() && has_ && fits;
    // What is still read is not drawn into: a view that is wanted meanwhile waits.
    keeps_ = scene.next_view.has_value() && !scene.fade_in;
    has_ = shows_;
    if (!keeps_ || fits) return {};
    auto made = vk::Image::create(frame.device,
                                  {.name = "last picture of a view",
                                   .format = frame.desc.colour_format,
                                   .extent = frame.extent,
                                   .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                            VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    if (!made) return made.error();
    kept_ = std::move(*made);
    vk::write_image(frame.device, frame.set(), shaders::kBindViewBefore, kept_.view(),
                    frame.pipelines.clamped.get());
    return {};
}

void ViewFade::keep(VkCommandBuffer commands, const vk::ImageState& used) {
    vk::barrier(commands, kept_, used, vk::state::kSampled);
    has_ = true;
}

void ViewFade::draw(const VulkanFrame& frame) const {
    if (shows_) frame.draw_screen(frame.pipelines.view_fade);
}

}  // namespace onggi::render
