// A buffer with its memory. Main thread.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <string_view>

#include "engine/core/result.h"
#include "engine/vk/memory.h"

namespace onggi::vk {

struct BufferDesc {
    std::string_view name;
    VkDeviceSize size = 0;  // bytes
    VkBufferUsageFlags usage = 0;
    MemoryUse use = MemoryUse::kUpload;
};

class Buffer {
  public:
    Buffer() = default;
    // The device must outlive the buffer.
    static Result<Buffer> create(const Device& device, const BufferDesc& desc);
    ~Buffer() { destroy(); }
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept { return swap(other), *this; }

    [[nodiscard]] VkBuffer handle() const { return buffer_; }
    [[nodiscard]] VkDeviceSize size() const { return size_; }
    // Null unless the memory is host-visible.
    [[nodiscard]] std::byte* mapped() const { return static_cast<std::byte*>(allocation_.mapped); }

    // Returns the whole buffer as a span. Precondition: host-visible.
    template <typename T>
    [[nodiscard]] std::span<T> as() const {
        return {reinterpret_cast<T*>(mapped()), size_ / sizeof(T)};
    }

    // Precondition: host-visible and large enough.
    void write(std::span<const std::byte> bytes, std::size_t offset = 0) const {
        if (!bytes.empty()) std::memcpy(mapped() + offset, bytes.data(), bytes.size());
    }

  private:
    void destroy();
    void swap(Buffer& other) noexcept;

    const Device* device_ = nullptr;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceSize size_ = 0;
    Allocation allocation_;
};

// Makes a buffer at least `bytes` large; does nothing if it is. A buffer that grows becomes at least half as
// large again and loses its contents, so it grows only a few times. Precondition: the device no longer uses
// it.
Result<void> make_room(const Device& device, Buffer& buffer, std::string_view name, VkDeviceSize bytes,
                       VkBufferUsageFlags usage, MemoryUse use = MemoryUse::kUpload);

}  // namespace onggi::vk
