// The pipelines and samplers that the Vulkan backend makes once from its description. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/scene.h"

namespace onggi::render {

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

}  // namespace onggi::render
