// Copies pixels back to the host. Main thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/image.h"

namespace onggi::vk {

// Makes copies recorded before visible to the host once the commands have finished.
void barrier_to_host(VkCommandBuffer commands);

// Waits for the copy. The image has four bytes per pixel and is in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL.
// Returns rows from the top, tightly packed, in the image's channel order.
Result<std::vector<std::uint8_t>> read_pixels(const Device& device, const Image& image);

}  // namespace onggi::vk
