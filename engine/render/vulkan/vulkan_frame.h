// What the Vulkan backend's passes share in a frame, besides what every frame has. Main thread. Pixels.
#pragma once

#include "engine/render/frame/frame_context.h"
#include "engine/render/vulkan/vulkan_images.h"
#include "engine/render/vulkan/vulkan_pipelines.h"

namespace onggi::render {

struct VulkanFrame : FrameContext {
    VulkanPipelines pipelines{};
    VulkanImages images{};
    VkExtent2D target_extent{};  // the scene's picture may be smaller, see RendererDesc::scale
};

}  // namespace onggi::render
