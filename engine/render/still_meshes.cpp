#include "engine/render/still_meshes.h"

#include <algorithm>

namespace onggi::render {
namespace {

constexpr VkShaderStageFlags kBothStages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

}  // namespace

Result<void> StillMeshes::upload(const vk::Device& device, const StillLife& still_life) {
    std::vector<Mesh::Vertex> vertices;
    std::vector<std::uint32_t> indices;
    parts_.clear();
    for (const StillLife::Part& part : still_life.parts) {
        parts_.push_back({.draw = mesh_draw(part.material, part.position_mm, 1.0F),
                          .first_index = static_cast<std::uint32_t>(indices.size()),
                          .index_count = static_cast<std::uint32_t>(part.mesh->indices.size()),
                          .first_vertex = static_cast<std::int32_t>(vertices.size()),
                          .casts_shadow = part.casts_shadow});
        vertices.insert(vertices.end(), part.mesh->vertices.begin(), part.mesh->vertices.end());
        indices.insert(indices.end(), part.mesh->indices.begin(), part.mesh->indices.end());
    }
    bounds_ = bounds_of(still_life);
    if (indices.empty()) return {};
    auto vertex_buffer = vk::Buffer::create(device, {.name = "still life vertices",
                                                     .size = vertices.size() * sizeof(Mesh::Vertex),
                                                     .usage = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT});
    if (!vertex_buffer) return vertex_buffer.error();
    auto index_buffer = vk::Buffer::create(device, {.name = "still life indices",
                                                    .size = indices.size() * sizeof(std::uint32_t),
                                                    .usage = VK_BUFFER_USAGE_INDEX_BUFFER_BIT});
    if (!index_buffer) return index_buffer.error();
    vertices_ = std::move(*vertex_buffer);
    indices_ = std::move(*index_buffer);
    vertices_.write(std::as_bytes(std::span(vertices)));
    indices_.write(std::as_bytes(std::span(indices)));
    return {};
}

void StillMeshes::bind(VkCommandBuffer commands) const {
    const VkBuffer buffer = vertices_.handle();
    const VkDeviceSize offset = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &buffer, &offset);
    vkCmdBindIndexBuffer(commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT32);
}

void StillMeshes::draw(VkCommandBuffer commands, VkPipelineLayout layout, bool casters_only) const {
    if (parts_.empty()) return;
    bind(commands);
    for (const Part& part : parts_) {
        if (casters_only && !part.casts_shadow) continue;
        vkCmdPushConstants(commands, layout, kBothStages, 0, sizeof part.draw, &part.draw);
        vkCmdDrawIndexed(commands, part.index_count, 1, part.first_index, part.first_vertex, 0);
    }
}

void StillMeshes::draw_as(VkCommandBuffer commands, VkPipelineLayout layout,
                          const shaders::MeshDraw& draw) const {
    if (parts_.empty()) return;
    bind(commands);
    vkCmdPushConstants(commands, layout, kBothStages, 0, sizeof draw, &draw);
    for (const Part& part : parts_)
        vkCmdDrawIndexed(commands, part.index_count, 1, part.first_index, part.first_vertex, 0);
}

}  // namespace onggi::render
