#include "engine/render/direct/mover_pass.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "shaders/shaders.h"

namespace onggi::render {
namespace {

constexpr std::array kAttributes{
    VkVertexInputAttributeDescription{0, 0, VK_FORMAT_R32G32B32_SFLOAT,
                                      offsetof(MoverMesh::Vertex, position_mm)},
    VkVertexInputAttributeDescription{1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(MoverMesh::Vertex, normal)},
    VkVertexInputAttributeDescription{2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(MoverMesh::Vertex, tone)}};

shaders::MoverDraw mover_draw(const Mover& mover, const MoverMesh& mesh) {
    const mat4 rows = glm::transpose(mover.place);  // a column of the transposed is a row
    return {.row_x = rows[0],
            .row_y = rows[1],
            .row_z = rows[2],
            .albedo = vec4(mesh.albedo, mesh.roughness),
            .clay = vec4(mover.clay, mover.wetness),
            .surface = vec4(mesh.metalness, 0.0F, 0.0F, 0.0F)};
}

}  // namespace

Result<void> MoverPass::create(const FrameContext& frame) {
    const std::array constants{static_cast<std::uint32_t>(frame.desc.transfer)};
    const std::array formats{frame.desc.colour_format};
    const bool at_vertices = frame.desc.lights_movers_at_vertices;
    auto pipeline = vk::create_pipeline(
        frame.device, {.name = "hands and tools",
                       .vertex_spirv = at_vertices ? shaders::kMoverLitVert : shaders::kMoverVert,
                       .fragment_spirv = at_vertices ? shaders::kMoverLitFrag : shaders::kMoverFrag,
                       .constants = constants,
                       .layout = frame.pipelines.layout.get(),
                       .attributes = kAttributes,
                       .vertex_stride = sizeof(MoverMesh::Vertex),
                       .colour_formats = formats,
                       .depth_format = kDepthFormat,
                       .samples = static_cast<VkSampleCountFlagBits>(frame.desc.samples),
                       .depth_test = true,
                       .depth_write = true});
    if (!pipeline) return pipeline.error();
    pipeline_ = std::move(*pipeline);
    return {};
}

Result<void> MoverPass::fit(const FrameContext& frame, const Scene& scene) {
    if (scene.mover_library == uploaded_) return {};
    uploaded_.reset();
    ranges_.clear();
    std::vector<MoverMesh::Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const MoverModel& model : scene.mover_library ? *scene.mover_library : MoverLibrary()) {
        std::vector<Range>& ranges = ranges_.emplace_back();
        for (const MoverMesh& mesh : model.meshes) {
            ranges.push_back({.first_index = static_cast<std::uint32_t>(indices.size()),
                              .first_vertex = static_cast<std::int32_t>(vertices.size())});
            vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
            indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
        }
    }
    auto sent = buffers_.upload(frame.device, "hands and tools", std::as_bytes(std::span(vertices)), indices);
    if (!sent) return sent;
    uploaded_ = scene.mover_library;
    return {};
}

Result<void> MoverPass::upload(const FrameContext& frame, const MoverModels& models) {
    const auto bytes = std::as_bytes(models.chosen_indices());
    if (bytes.empty()) return {};
    if (auto made = vk::make_room(frame.device, chosen_, "hands' and tools' faces", bytes.size(),
                                  VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
        !made) {
        return made;
    }
    chosen_.write(bytes);
    return {};
}

void MoverPass::draw(const FrameContext& frame, const Scene& scene, const MoverModels& models) const {
    if (scene.movers.empty() || !uploaded_) return;
    frame.bind(pipeline_);
    buffers_.bind(frame.commands);
    const bool are_chosen = !models.chosen_indices().empty();
    if (are_chosen) vkCmdBindIndexBuffer(frame.commands, chosen_.handle(), 0, VK_INDEX_TYPE_UINT32);
    std::uint32_t next = 0;
    models.for_parts(
        scene, [&](const Mover& mover, std::size_t mesh, std::span<const std::uint32_t> indices) {
            if (indices.empty()) return;
            const auto count = static_cast<std::uint32_t>(indices.size());
            const Range& range = ranges_[mover.model][mesh];
            const std::uint32_t first = are_chosen ? std::exchange(next, next + count) : range.first_index;
            frame.push(mover_draw(mover, (*uploaded_)[mover.model].meshes[mesh]));
            vkCmdDrawIndexed(frame.commands, count, 1, first, range.first_vertex, 0);
        });
}

}  // namespace onggi::render
