#include "engine/render/frame/still_meshes.h"

#include <algorithm>
#include <utility>

#include "engine/render/frame/pipelines.h"
#include "shaders/shaders.h"

namespace onggi::render {

Result<void> MeshBuffers::upload(const vk::Device& device, const std::string& name,
                                 std::span<const std::byte> vertices,
                                 std::span<const std::uint32_t> indices) {
    if (indices.empty()) return {};
    auto vertex_buffer = vk::Buffer::create(
        device,
        {.name = name + ": vertices", .size = vertices.size(), .usage = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT});
    if (!vertex_buffer) return vertex_buffer.error();
    auto index_buffer = vk::Buffer::create(device, {.name = name + ": indices",
                                                    .size = indices.size_bytes(),
                                                    .usage = VK_BUFFER_USAGE_INDEX_BUFFER_BIT});
    if (!index_buffer) return index_buffer.error();
    vertices_ = std::move(*vertex_buffer);
    indices_ = std::move(*index_buffer);
    vertices_.write(vertices);
    indices_.write(std::as_bytes(indices));
    return {};
}

void MeshBuffers::bind(VkCommandBuffer commands) const {
    const VkBuffer buffer = vertices_.handle();
    const VkDeviceSize offset = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &buffer, &offset);
    vkCmdBindIndexBuffer(commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT32);
}

namespace {

vec3 centre_of(const Mesh& mesh) {
    vec3 sum(0.0F);
    for (const Mesh::Vertex& vertex : mesh.vertices)
        sum += vertex.position_mm;
    return sum / std::max(1.0F, static_cast<float>(mesh.vertices.size()));
}

}  // namespace

Result<bool> StillMeshes::fit(const vk::Device& device, const std::shared_ptr<const StillLife>& still_life) {
    const std::uint64_t revision = still_life ? still_life->revision : 0;
    if (still_life == uploaded_ && revision == revision_) return false;
    if (auto sent = upload(device, still_life ? *still_life : StillLife{}); !sent) return sent.error();
    uploaded_ = still_life;
    revision_ = revision;
    return true;
}

Result<void> StillMeshes::upload(const vk::Device& device, const StillLife& still_life) {
    std::vector<Mesh::Vertex> vertices;
    std::vector<std::uint32_t> indices;
    parts_.clear();
    for (const StillLife::Part& part : still_life.parts) {
        parts_.push_back({.draw = mesh_draw(part.material, part.position_mm),
                          .first_index = static_cast<std::uint32_t>(indices.size()),
                          .index_count = static_cast<std::uint32_t>(part.mesh->indices.size()),
                          .first_vertex = static_cast<std::int32_t>(vertices.size()),
                          .centre_mm = part.position_mm + centre_of(*part.mesh),
                          .casts_shadow = part.casts_shadow});
        vertices.insert(vertices.end(), part.mesh->vertices.begin(), part.mesh->vertices.end());
        indices.insert(indices.end(), part.mesh->indices.begin(), part.mesh->indices.end());
    }
    bounds_ = bounds_of(still_life);
    return buffers_.upload(device, "still life", std::as_bytes(std::span(vertices)), indices);
}

void StillMeshes::look_from(const vec3& eye_mm) {
    std::ranges::sort(parts_, {}, [&](const Part& part) { return glm::distance(eye_mm, part.centre_mm); });
}

void StillMeshes::draw(const FrameContext& frame, Which which) const {
    if (parts_.empty()) return;
    buffers_.bind(frame.commands);
    for (const Part& part : parts_) {
        if (which == Which::kCasters && !part.casts_shadow) continue;
        frame.push(part.draw);
        vkCmdDrawIndexed(frame.commands, part.index_count, 1, part.first_index, part.first_vertex, 0);
        frame.count_draw(part.index_count);
    }
}

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
