#include "engine/render/frame/pipelines.h"

#include <utility>

#include "shaders/shaders.h"

namespace onggi::render {

vk::PipelineDesc screen_pipeline(const FrameContext& frame, std::string_view name,
                                 std::span<const std::uint32_t> fragment_spirv) {
    return {.name = name,
            .vertex_spirv = shaders::kScreenVert,
            .fragment_spirv = fragment_spirv,
            .layout = frame.layout.get(),
            .depth_format = kDepthFormat,
            .samples = static_cast<VkSampleCountFlagBits>(frame.desc.samples),
            .depth_test = true,
            .cull = VK_CULL_MODE_NONE};
}

vk::PipelineDesc mesh_pipeline(const FrameContext& frame, std::string_view name,
                               std::span<const std::uint32_t> fragment_spirv) {
    return {.name = name,
            .vertex_spirv = shaders::kMeshVert,
            .fragment_spirv = fragment_spirv,
            .layout = frame.layout.get(),
            .attributes = kMeshAttributes,
            .vertex_stride = sizeof(Mesh::Vertex),
            .depth_format = kDepthFormat,
            .samples = static_cast<VkSampleCountFlagBits>(frame.desc.samples),
            .depth_test = true,
            .depth_write = true};
}

void PipelineMaker::make(vk::Pipeline& into, const vk::PipelineDesc& desc) {
    if (!error_ || into.get() != VK_NULL_HANDLE) return;
    auto made = vk::create_pipeline(device_, desc);
    if (made) {
        into = std::move(*made);
    } else {
        error_ = made.error();
    }
}

}  // namespace onggi::render
