#include "engine/vk/buffer.h"

#include <algorithm>
#include <utility>

#include "engine/vk/check.h"

namespace onggi::vk {

Result<Buffer> Buffer::create(const Device& device, const BufferDesc& desc) {
    Buffer buffer;
    buffer.device_ = &device;
    buffer.size_ = desc.size;
    const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                  .size = desc.size,
                                  .usage = desc.usage,
                                  .sharingMode = VK_SHARING_MODE_EXCLUSIVE};
    ONGGI_VK_TRY_ON(device, vkCreateBuffer(device.handle(), &info, nullptr, &buffer.buffer_));

    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device.handle(), buffer.buffer_, &needs);
    auto allocation = allocate(device, needs, desc.use);
    if (!allocation) return allocation.error();
    buffer.allocation_ = *allocation;
    ONGGI_VK_TRY_ON(device,
                    vkBindBufferMemory(device.handle(), buffer.buffer_, buffer.allocation_.memory, 0));
    device.name(VK_OBJECT_TYPE_BUFFER, buffer.buffer_, desc.name);
    return buffer;
}

void Buffer::destroy() {
    if (device_ == nullptr) return;
    if (buffer_ != VK_NULL_HANDLE) vkDestroyBuffer(device_->handle(), buffer_, nullptr);
    free_allocation(*device_, allocation_);
    buffer_ = VK_NULL_HANDLE;
    device_ = nullptr;
}

void Buffer::swap(Buffer& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(buffer_, other.buffer_);
    std::swap(size_, other.size_);
    std::swap(allocation_, other.allocation_);
}

Result<void> make_room(const Device& device, Buffer& buffer, std::string_view name, VkDeviceSize bytes,
                       VkBufferUsageFlags usage, MemoryUse use) {
    if (bytes <= buffer.size()) return {};
    auto larger = Buffer::create(
        device, {.name = name, .size = std::max(bytes, buffer.size() * 3 / 2), .usage = usage, .use = use});
    if (!larger) return larger.error();
    buffer = std::move(*larger);
    return {};
}

}  // namespace onggi::vk
