#include "engine/vk/image.h"

#include <utility>

#include "engine/vk/check.h"

namespace onggi::vk {

Result<Image> Image::create(const Device& device, const ImageDesc& desc) {
    Image image;
    image.device_ = &device;
    image.extent_ = desc.extent;
    image.aspect_ = desc.aspect;
    const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                 .imageType = VK_IMAGE_TYPE_2D,
                                 .format = desc.format,
                                 .extent = {desc.extent.width, desc.extent.height, 1},
                                 .mipLevels = 1,
                                 .arrayLayers = 1,
                                 .samples = desc.samples,
                                 .tiling = VK_IMAGE_TILING_OPTIMAL,
                                 .usage = desc.usage,
                                 .sharingMode = VK_SHARING_MODE_EXCLUSIVE,
                                 .initialLayout = VK_IMAGE_LAYOUT_UNDEFINED};
    ONGGI_VK_TRY_ON(device, vkCreateImage(device.handle(), &info, nullptr, &image.image_));

    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device.handle(), image.image_, &needs);
    auto allocation = allocate(device, needs, MemoryUse::kDevice);
    if (!allocation) return allocation.error();
    image.allocation_ = *allocation;
    ONGGI_VK_TRY_ON(device, vkBindImageMemory(device.handle(), image.image_, image.allocation_.memory, 0));
    device.name(VK_OBJECT_TYPE_IMAGE, image.image_, desc.name);

    constexpr VkImageUsageFlags kViewed = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                          VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                          VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    if ((desc.usage & kViewed) != 0) {
        const VkImageViewCreateInfo view{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                         .image = image.image_,
                                         .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                         .format = desc.format,
                                         .subresourceRange = {desc.aspect, 0, 1, 0, 1}};
        ONGGI_VK_TRY_ON(device, vkCreateImageView(device.handle(), &view, nullptr, &image.view_));
        device.name(VK_OBJECT_TYPE_IMAGE_VIEW, image.view_, desc.name);
    }
    return image;
}

void Image::destroy() {
    if (device_ == nullptr) return;
    if (view_ != VK_NULL_HANDLE) vkDestroyImageView(device_->handle(), view_, nullptr);
    if (image_ != VK_NULL_HANDLE) vkDestroyImage(device_->handle(), image_, nullptr);
    free_allocation(*device_, allocation_);
    view_ = VK_NULL_HANDLE;
    image_ = VK_NULL_HANDLE;
    device_ = nullptr;
}

void Image::swap(Image& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(image_, other.image_);
    std::swap(view_, other.view_);
    std::swap(extent_, other.extent_);
    std::swap(aspect_, other.aspect_);
    std::swap(allocation_, other.allocation_);
}

void barrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, const ImageState& from,
             const ImageState& to) {
    const VkImageMemoryBarrier2 change{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                       .srcStageMask = from.stages,
                                       .srcAccessMask = from.access,
                                       .dstStageMask = to.stages,
                                       .dstAccessMask = to.access,
                                       .oldLayout = from.layout,
                                       .newLayout = to.layout,
                                       .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                       .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                       .image = image,
                                       .subresourceRange = {aspect, 0, 1, 0, 1}};
    const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                .imageMemoryBarrierCount = 1,
                                .pImageMemoryBarriers = &change};
    vkCmdPipelineBarrier2(commands, &info);
}

void copy(VkCommandBuffer commands, VkImage from, VkImage to, VkImageAspectFlags aspect,
          const VkRect2D& area) {
    const VkImageCopy region{.srcSubresource = {aspect, 0, 0, 1},
                             .srcOffset = {area.offset.x, area.offset.y, 0},
                             .dstSubresource = {aspect, 0, 0, 1},
                             .dstOffset = {area.offset.x, area.offset.y, 0},
                             .extent = {area.extent.width, area.extent.height, 1}};
    vkCmdCopyImage(commands, from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

}  // namespace onggi::vk
