#include "engine/render/frame/pass.h"

#include <vector>

namespace onggi::render {

void begin_pass(VkCommandBuffer commands, VkExtent2D extent, std::span<const PassColour> colours,
                const PassDepth& depth) {
    std::vector<VkRenderingAttachmentInfo> colour_infos;
    for (const PassColour& colour : colours) {
        VkRenderingAttachmentInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                       .imageView = colour.view,
                                       .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                       .loadOp = colour.load,
                                       .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
        if (colour.resolve != VK_NULL_HANDLE) {
            info.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
            info.resolveImageView = colour.resolve;
            info.resolveImageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
            info.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
        }
        colour_infos.push_back(info);
    }
    const VkRenderingAttachmentInfo depth_info{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                               .imageView = depth.view,
                                               .imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                               .loadOp = depth.load,
                                               .storeOp = depth.store,
                                               .clearValue = {.depthStencil = {1.0F, 0}}};

    const VkRenderingInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                               .renderArea = {{0, 0}, extent},
                               .layerCount = 1,
                               .colorAttachmentCount = static_cast<std::uint32_t>(colour_infos.size()),
                               .pColorAttachments = colour_infos.data(),
                               .pDepthAttachment = depth.view == VK_NULL_HANDLE ? nullptr : &depth_info};
    vkCmdBeginRendering(commands, &info);

    const VkViewport viewport{0.0F, 0.0F, static_cast<float>(extent.width), static_cast<float>(extent.height),
                              0.0F, 1.0F};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &info.renderArea);
}

void rows_in_buffer(std::span<const PixelRect> rects, std::uint32_t width_px,
                    std::vector<VkBufferImageCopy>& regions) {
    regions.clear();
    for (const PixelRect& rect : rects) {
        const VkBufferImageCopy region{
            .bufferOffset = VkDeviceSize{4} * (static_cast<VkDeviceSize>(rect.y) * width_px +
                                               static_cast<VkDeviceSize>(rect.x)),
            .bufferRowLength = width_px,
            .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
            .imageOffset = {rect.x, rect.y, 0},
            .imageExtent = {static_cast<std::uint32_t>(rect.width), static_cast<std::uint32_t>(rect.height),
                            1}};
        regions.push_back(region);
    }
}

}  // namespace onggi::render
