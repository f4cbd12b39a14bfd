// Pipeline descriptions common to both backends, and a maker for pipelines. Main thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/scene.h"
#include "engine/vk/pipeline.h"

namespace onggi::render {

inline constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;

inline constexpr std::array kMeshAttributes{
    VkVertexInputAttributeDescription{0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Mesh::Vertex, position_mm)},
    VkVertexInputAttributeDescription{1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Mesh::Vertex, normal)},
    VkVertexInputAttributeDescription{2, 0, VK_FORMAT_R32_SFLOAT, offsetof(Mesh::Vertex, open_sky)}};

// Descriptions without constants and colour formats, which the caller adds: a full-screen triangle that is
// visible where nothing else was drawn, and static meshes.
[[nodiscard]] vk::PipelineDesc screen_pipeline(const FrameContext& frame, std::string_view name,
                                               std::span<const std::uint32_t> fragment_spirv);
[[nodiscard]] vk::PipelineDesc mesh_pipeline(const FrameContext& frame, std::string_view name,
                                             std::span<const std::uint32_t> fragment_spirv);

// Creates pipelines until one fails, and keeps the first error.
class PipelineMaker {
  public:
    explicit PipelineMaker(const vk::Device& device) : device_(device) {}

    // Does nothing if `into` is set already: a pipeline takes 2 MB of a software driver's memory.
    void make(vk::Pipeline& into, const vk::PipelineDesc& desc);
    [[nodiscard]] Result<void> outcome() const { return error_; }

  private:
    const vk::Device& device_;
    Result<void> error_;
};

}  // namespace onggi::render
