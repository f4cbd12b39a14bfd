#include "engine/render/vulkan/shadow_pass.h"

namespace onggi::render {

void ShadowPass::update(VulkanFrame& frame, const Scene& scene) {
    const std::uint64_t now = shadow_hash(scene);
    frame.stats.shadow_drawn = !has_mask_ || now != drawn_;
    drawn_ = now;
}

void ShadowPass::record(const VulkanFrame& frame) {
    if (!frame.stats.shadow_drawn) return;
    const vk::Image& mask = frame.images.mask;
    vk::barrier(frame.commands, mask, vk::state::kDiscard, vk::state::kColour);
    begin_pass(frame.commands, mask.extent(), {{.view = mask.view()}}, {});
    frame.draw_screen(frame.pipelines.mask);
    vkCmdEndRendering(frame.commands);
    vk::barrier(frame.commands, mask, vk::state::kColour, vk::state::kSampled);
    has_mask_ = true;
}

}  // namespace onggi::render
