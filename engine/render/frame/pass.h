// A dynamic-rendering pass in a few words. Main thread.
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "engine/render/shapes/tiles.h"
#include "engine/vk/vulkan.h"

namespace onggi::render {

struct PassColour {
    VkImageView view = VK_NULL_HANDLE;
    VkAttachmentLoadOp load = VK_ATTACHMENT_LOAD_OP_DONT_CARE;  // cleared: to 0
    VkImageView resolve = VK_NULL_HANDLE;  // the average of the samples goes here, and they are dropped
};

struct PassDepth {
    VkImageView view = VK_NULL_HANDLE;                      // null: none
    VkAttachmentLoadOp load = VK_ATTACHMENT_LOAD_OP_CLEAR;  // to 1
    VkAttachmentStoreOp store = VK_ATTACHMENT_STORE_OP_DONT_CARE;
};

// Begins rendering with viewport and scissor over the whole extent. vkCmdEndRendering ends it.
void begin_pass(VkCommandBuffer commands, VkExtent2D extent, std::span<const PassColour> colours,
                const PassDepth& depth);
inline void begin_pass(VkCommandBuffer commands, VkExtent2D extent, std::initializer_list<PassColour> colours,
                       const PassDepth& depth) {
    begin_pass(commands, extent, std::span(colours.begin(), colours.size()), depth);
}

// The same rectangles of a picture of this width whose rows lie one after another in a buffer, four bytes a
// pixel, and of a colour image.
void rows_in_buffer(std::span<const PixelRect> rects, std::uint32_t width_px,
                    std::vector<VkBufferImageCopy>& regions);

}  // namespace onggi::render
