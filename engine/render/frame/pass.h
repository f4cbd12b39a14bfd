// Helpers for dynamic-rendering passes. Main thread.
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "engine/render/shapes/tiles.h"
#include "engine/vk/vulkan.h"

namespace onggi::render {

struct PassColour {
    VkImageView view = VK_NULL_HANDLE;
    VkAttachmentLoadOp load = VK_ATTACHMENT_LOAD_OP_DONT_CARE;  // if cleared: to 0
    VkImageView resolve = VK_NULL_HANDLE;  // receives the average of the samples; the samples are discarded
};

struct PassDepth {
    VkImageView view = VK_NULL_HANDLE;                      // null: no depth
    VkAttachmentLoadOp load = VK_ATTACHMENT_LOAD_OP_CLEAR;  // if cleared: to 1
    VkAttachmentStoreOp store = VK_ATTACHMENT_STORE_OP_DONT_CARE;
};

// Begins rendering, with viewport and scissor over the whole extent. vkCmdEndRendering ends it.
void begin_pass(VkCommandBuffer commands, VkExtent2D extent, std::span<const PassColour> colours,
                const PassDepth& depth);
inline void begin_pass(VkCommandBuffer commands, VkExtent2D extent, std::initializer_list<PassColour> colours,
                       const PassDepth& depth) {
    begin_pass(commands, extent, std::span(colours.begin(), colours.size()), depth);
}

// Copy regions for rectangles of a picture: the same rectangles in a buffer that holds the whole picture row
// by row (width_px wide, four bytes per pixel) and in a colour image.
void rows_in_buffer(std::span<const PixelRect> rects, std::uint32_t width_px,
                    std::vector<VkBufferImageCopy>& regions);

}  // namespace onggi::render
