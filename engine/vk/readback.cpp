#include "engine/vk/readback.h"

#include "engine/vk/buffer.h"

namespace onggi::vk {

void barrier_to_host(VkCommandBuffer commands) {
    const VkMemoryBarrier2 to_host{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                                   .srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT,
                                   .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                   .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT,
                                   .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT};
    const VkDependencyInfo info{
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &to_host};
    vkCmdPipelineBarrier2(commands, &info);
}

Result<std::vector<std::uint8_t>> read_pixels(const Device& device, const Image& image) {
    const VkExtent2D extent = image.extent();
    const VkDeviceSize size = VkDeviceSize{4} * extent.width * extent.height;
    auto buffer = Buffer::create(device, {.name = "readback",
                                          .size = size,
                                          .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                          .use = MemoryUse::kReadback});
    if (!buffer) return buffer.error();
    const auto copied = device.run_once([&](VkCommandBuffer commands) {
        const VkBufferImageCopy region{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                       .imageExtent = {extent.width, extent.height, 1}};
        vkCmdCopyImageToBuffer(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                               buffer->handle(), 1, &region);
        barrier_to_host(commands);
    });
    if (!copied) return copied.error();
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(buffer->mapped());
    return std::vector<std::uint8_t>(bytes, bytes + size);
}

}  // namespace onggi::vk
