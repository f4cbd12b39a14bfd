// Device memory, one allocation per resource. The scene has about twenty, far below any driver's limit
// (maxMemoryAllocationCount is at least 4096), so a sub-allocator would only obscure ownership. Main thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/device.h"

namespace onggi::vk {

enum class MemoryUse {
    kDevice,    // fastest for drawing
    kUpload,    // written by the host every frame, read by the device; stays mapped
    kReadback,  // written by the device, read by the host; stays mapped
    kWork,      // written and read by the host, then read by the device; stays mapped
};

// Not an owner: the resource that allocated it frees it. Host-visible memory is coherent.
struct Allocation {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    void* mapped = nullptr;  // null for kDevice
};

// Returns the memory types to try, best first: if one is full, the next is used.
[[nodiscard]] std::vector<std::uint32_t> memory_types(const VkPhysicalDeviceMemoryProperties& memory,
                                                      std::uint32_t allowed, MemoryUse use);

Result<Allocation> allocate(const Device& device, const VkMemoryRequirements& needs, MemoryUse use);
void free_allocation(const Device& device, Allocation& allocation);

}  // namespace onggi::vk
