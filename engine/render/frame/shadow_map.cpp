#include "engine/render/frame/shadow_map.h"

#include <span>

#include "engine/render/frame/pipelines.h"
#include "shaders/shaders.h"

namespace onggi::render {

Result<void> fit_shadow_map(FrameContext& frame) {
    PipelineMaker maker(frame.device);
    vk::PipelineDesc desc = mesh_pipeline(frame, "still life's shadow map", {});
    desc.vertex_spirv = shaders::kShadowMapVert;
    desc.attributes = std::span(kMeshAttributes).first(1);
    desc.samples = VK_SAMPLE_COUNT_1_BIT;
    desc.depth_bias = true;
    desc.cull = VK_CULL_MODE_NONE;
    maker.make(frame.shadow_map_pipeline, desc);
    return maker.outcome();
}

void record_shadow_map(const FrameContext& frame, const StillMeshes& meshes) {
    const vk::Image& map = frame.shadow_map;
    vk::barrier(frame.commands, map, vk::state::kDiscard, vk::state::kDepth);
    begin_pass(frame.commands, map.extent(), {}, {.view = map.view(), .store = VK_ATTACHMENT_STORE_OP_STORE});
    frame.bind(frame.shadow_map_pipeline);
    meshes.draw(frame, StillMeshes::Which::kCasters);
    vkCmdEndRendering(frame.commands);
    vk::barrier(frame.commands, map, vk::state::kDepth, vk::state::kSampled);
}

}  // namespace onggi::render
