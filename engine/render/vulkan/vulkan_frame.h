// State of a frame that the Vulkan backend's passes share, in addition to FrameContext. Main thread. Pixels.
#pragma once

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/renderer_desc.h"
#include "engine/render/scene.h"
#include "engine/vk/image.h"

namespace onggi::render {

// Images that the Vulkan backend draws into besides its target. Those of the picture's size are re-created
// when it changes.

constexpr VkFormat kMaskFormat = VK_FORMAT_R8G8_UNORM;

struct VulkanImages {
    // With a fixed size.
    vk::Image detail;
    vk::Image mask;
    // With the size of the scene's picture.
    vk::Image depth;
    vk::Image multisampled;  // with samples > 1
    vk::Image smaller;       // if the scene's picture is smaller than the target
};

Result<void> create_fixed_images(const vk::Device& device, const RendererDesc& desc, VulkanImages& images);
Result<void> create_sized_images(const vk::Device& device, const RendererDesc& desc, VkExtent2D extent,
                                 VulkanImages& images);

// Pipelines and samplers that the Vulkan backend creates once, from its settings.
struct VulkanPipelines {
    vk::Sampler clamped;
    vk::Sampler repeated;
    vk::Pipeline backdrop;  // `backdrop` and `still`: scenes without a background
    vk::Pipeline still;
    vk::Pipeline background;  // instead of the backdrop and the still life's colours
    vk::Pipeline background_surface;
    vk::Pipeline view_fade;
    vk::Pipeline mask;
    vk::Pipeline lathe;               // where no sphere's shadow falls
    vk::Pipeline lathe_near_spheres;  // where a sphere's shadow may fall
    vk::Pipeline lathe_load;          // like lathe_near_spheres, with the load shown
    vk::Pipeline lathe_marks;         // with marks
    vk::Pipeline lathe_section;       // the faces of a cut
};

// Creates the pipelines that every scene may need. The others are left out, because a pipeline takes 2 MB of
// a software driver's memory.
Result<void> create_pipelines(const FrameContext& frame, VulkanPipelines& pipelines);
// Adds the pipelines that this scene needs besides, once.
Result<void> fit_pipelines(const FrameContext& frame, const Scene& scene, VulkanPipelines& pipelines);

struct VulkanFrame : FrameContext {
    VulkanPipelines pipelines{};
    VulkanImages images{};
    VkExtent2D target_extent{};  // the scene's picture may be smaller, see RendererDesc::scale
};

}  // namespace onggi::render
