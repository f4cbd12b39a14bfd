#include "engine/render/vulkan/prop_pass.h"

#include <array>
#include <cstddef>
#include <span>

#include "engine/render/frame/pipelines.h"
#include "shaders/shaders.h"

namespace onggi::render {
namespace {

constexpr std::array kAttributes{
    VkVertexInputAttributeDescription{0, 0, VK_FORMAT_R32G32B32_SFLOAT,
                                      offsetof(PropMesh::Vertex, position_mm)},
    VkVertexInputAttributeDescription{1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(PropMesh::Vertex, normal)},
    VkVertexInputAttributeDescription{2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(PropMesh::Vertex, tone)}};

shaders::PropDraw prop_draw(const Prop& prop, const PropMesh& mesh) {
    const mat4 rows = glm::transpose(prop.place);  // a column of the transposed is a row
    return {.row_x = rows[0],
            .row_y = rows[1],
            .row_z = rows[2],
            .albedo = vec4(mesh.albedo, mesh.roughness),
            .smear = vec4(prop.smear, prop.wetness),
            .surface = vec4(mesh.metalness, 0.0F, 0.0F, 0.0F)};
}

}  // namespace

Result<void> PropPass::create(const VulkanFrame& frame) {
    const std::array formats{frame.desc.colour_format};
    auto pipeline =
        vk::create_pipeline(frame.device, {.name = "hands and tools",
                                           .vertex_spirv = shaders::kPropVert,
                                           .fragment_spirv = shaders::kPropFrag,
                                           .layout = frame.layout.get(),
                                           .attributes = kAttributes,
                                           .vertex_stride = sizeof(PropMesh::Vertex),
                                           .colour_formats = formats,
                                           .depth_format = kDepthFormat,
                                           .samples = static_cast<VkSampleCountFlagBits>(frame.desc.samples),
                                           .depth_test = true,
                                           .depth_write = true});
    if (!pipeline) return pipeline.error();
    pipeline_ = std::move(*pipeline);
    return {};
}

Result<void> PropPass::fit(const VulkanFrame& frame, const Scene& scene) {
    if (scene.prop_library == uploaded_) return {};
    uploaded_.reset();
    ranges_.clear();
    std::vector<PropMesh::Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const PropModel& model : scene.prop_library ? *scene.prop_library : PropLibrary()) {
        std::vector<Range>& ranges = ranges_.emplace_back();
        for (const PropMesh& mesh : model.meshes) {
            ranges.push_back({.first_index = static_cast<std::uint32_t>(indices.size()),
                              .index_count = static_cast<std::uint32_t>(mesh.indices.size()),
                              .first_vertex = static_cast<std::int32_t>(vertices.size())});
            vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
            indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
        }
    }
    auto sent = buffers_.upload(frame.device, "hands and tools", std::as_bytes(std::span(vertices)), indices);
    if (!sent) return sent;
    uploaded_ = scene.prop_library;
    return {};
}

void PropPass::draw(const VulkanFrame& frame, const Scene& scene) const {
    if (scene.props.empty() || !uploaded_) return;
    frame.bind(pipeline_);
    buffers_.bind(frame.commands);
    for (const Prop& prop : scene.props) {
        if (prop.model >= ranges_.size()) continue;
        const std::vector<Range>& ranges = ranges_[prop.model];
        for (std::size_t mesh = 0; mesh < ranges.size(); ++mesh) {
            const Range& range = ranges[mesh];
            frame.push(prop_draw(prop, (*uploaded_)[prop.model].meshes[mesh]));
            vkCmdDrawIndexed(frame.commands, range.index_count, 1, range.first_index, range.first_vertex, 0);
            frame.count_draw(range.index_count);
        }
    }
}

}  // namespace onggi::render
