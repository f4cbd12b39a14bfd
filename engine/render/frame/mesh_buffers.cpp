#include "engine/render/frame/mesh_buffers.h"

#include <utility>

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

}  // namespace onggi::render
