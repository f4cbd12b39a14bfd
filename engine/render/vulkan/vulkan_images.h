// The images that the Vulkan backend draws into besides its target. Those of the picture's size are made
// again when it changes. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/renderer_desc.h"
#include "engine/vk/image.h"

namespace onggi::render {

constexpr VkFormat kMaskFormat = VK_FORMAT_R8G8_UNORM;

struct VulkanImages {
    // Of fixed size.
    vk::Image detail;
    vk::Image mask;
    // Of the scene's picture's size.
    vk::Image depth;
    vk::Image multisampled;  // with samples > 1
    vk::Image smaller;       // where it is not as large as the target
};

Result<void> create_fixed_images(const vk::Device& device, const RendererDesc& desc, VulkanImages& images);
Result<void> create_sized_images(const vk::Device& device, const RendererDesc& desc, VkExtent2D extent,
                                 VulkanImages& images);

}  // namespace onggi::render
