// What the Vulkan backend's passes share in a frame, besides what every frame has. Main thread. Pixels.
#pragma once

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/renderer_desc.h"
#include "engine/render/scene.h"
#include "engine/vk/image.h"

namespace onggi::render {

// The images that the Vulkan backend draws into besides its target. Those of the picture's size are made
// again when it changes.

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

// The pipelines and samplers that the Vulkan backend makes once from its description.
struct VulkanPipelines {
    vk::Sampler clamped;
    vk::Sampler repeated;
    vk::Pipeline backdrop;  // this and the next without a background
    vk::Pipeline still;
    vk::Pipeline background;  // instead of the backdrop, and of the still life's colours
    vk::Pipeline background_surface;
    vk::Pipeline view_fade;
    vk::Pipeline mask;
    vk::Pipeline lathe;               // where no moving sphere's shadow falls
    vk::Pipeline lathe_near_spheres;  // where one may
    vk::Pipeline lathe_load;          // the same with its load shown
    vk::Pipeline lathe_marks;         // with what is painted on it, where something is
    vk::Pipeline lathe_section;       // the faces of a cut, where there is one
};

// All but those that not every scene needs: a pipeline takes 2 MB of a software driver's memory.
Result<void> create_pipelines(const FrameContext& frame, VulkanPipelines& pipelines);
// Those that this scene needs besides, once.
Result<void> fit_pipelines(const FrameContext& frame, const Scene& scene, VulkanPipelines& pipelines);

struct VulkanFrame : FrameContext {
    VulkanPipelines pipelines{};
    VulkanImages images{};
    VkExtent2D target_extent{};  // the scene's picture may be smaller, see RendererDesc::scale
};

}  // namespace onggi::render
