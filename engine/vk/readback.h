// Pixels back to the host. Main thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/image.h"

namespace onggi::vk {

// What was copied before it can be read by the host once the commands are done.
void barrier_to_host(VkCommandBuffer commands);

// Waits. Of an image with four bytes a pixel in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL: rows from the top,
// tightly packed, in the image's own channel order.
Result<std::vector<std::uint8_t>> read_pixels(const Device& device, const Image& image);

}  // namespace onggi::vk
