// The pipelines that draw what stands still into the layers that the processor reads. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/scene.h"

namespace onggi::render {

// Two numbers of sixteen bits each, as two bytes each: see shaders/packed.glsl.
constexpr VkFormat kPackedFormat = VK_FORMAT_R8G8B8A8_UNORM;

struct LayerPipelines {
    vk::Pipeline backdrop;  // this and the next of a room in its own colours
    vk::Pipeline still;
    vk::Pipeline places;  // of a photographed room
};

// Those that every scene may need, and those that this scene needs besides; each once.
Result<void> create_pipelines(const FrameContext& frame, LayerPipelines& pipelines);
Result<void> fit_pipelines(const FrameContext& frame, const Scene& scene, LayerPipelines& pipelines);

}  // namespace onggi::render
