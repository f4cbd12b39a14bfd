#include "engine/render/frame/frame_context.h"

#include "engine/vk/check.h"

namespace onggi::render {

Result<void> FrameContext::begin() {
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    ONGGI_VK_TRY(vkBeginCommandBuffer(commands, &info));
    clock.begin(device, commands);
    return {};
}

Result<void> FrameContext::end(const vk::TargetImage& target) {
    clock.end(device, commands);
    const vk::ImageState done{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                              target.final_layout};
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kColour, done);
    ONGGI_VK_TRY(vkEndCommandBuffer(commands));
    return {};
}

void FrameContext::build(const Scene& scene, const StillBounds& still) {
    const EdgeView seen = view(scene);
    build_frame(scene, still, desc, seen.width_px, seen.height_px, built);
    stats = {.rings = static_cast<int>(built.rows.size()), .ring_error_px = built.ring_error_px};
}

}  // namespace onggi::render
