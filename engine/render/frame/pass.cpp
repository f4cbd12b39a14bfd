#include "engine/render/frame/pass.h"

#include <vector>

namespace onggi::render {

void begin_pass(VkCommandBuffer commands, VkExtent2D extent, std::span<const PassColour> colours,
                const PassDepth& depth) {
    std::vector<VkRenderingAttachmentInfo> colour_infos;
    for (const PassColour& colour : colours) {
        VkRenderingAttachmentInfo info{};
        info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
        info.imageView = colour.view;
        info.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        info.loadOp = colour.load;
        info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        if (colour.resolve != VK_NULL_HANDLE) {
            info.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
            info.resolveImageView = colour.resolve;
            info.resolveImageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
            info.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
        }
        colour_infos.push_back(info);
    }
    VkRenderingAttachmentInfo depth_info{};
    depth_info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    depth_info.imageView = depth.view;
    depth_info.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
    depth_info.loadOp = depth.load;
    depth_info.storeOp = depth.store;
    depth_info.clearValue.depthStencil = {1.0F, 0};

    VkRenderingInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    info.renderArea = {{0, 0}, extent};
    info.layerCount = 1;
    info.colorAttachmentCount = static_cast<std::uint32_t>(colour_infos.size());
    info.pColorAttachments = colour_infos.data();
    info.pDepthAttachment = depth.view == VK_NULL_HANDLE ? nullptr : &depth_info;
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
        VkBufferImageCopy region{};
        region.bufferOffset = VkDeviceSize{4} * (static_cast<VkDeviceSize>(rect.y) * width_px +
                                                 static_cast<VkDeviceSize>(rect.x));
        region.bufferRowLength = width_px;
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageOffset = {rect.x, rect.y, 0};
        region.imageExtent = {static_cast<std::uint32_t>(rect.width), static_cast<std::uint32_t>(rect.height),
                              1};
        regions.push_back(region);
    }
}

}  // namespace onggi::render
