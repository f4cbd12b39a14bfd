// Device memory, one allocation a resource: the scene has some twenty of them, far below any driver's limit
// (maxMemoryAllocationCount is at least 4096), so a sub-allocator would only hide who owns what. Main thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/device.h"

namespace onggi::vk {

enum class MemoryUse {
    kDevice,    // where drawing is quickest
    kUpload,    // written by the host every frame, read by the device; stays mapped
    kReadback,  // written by the device, read by the host; stays mapped
    kWork,      // written and read by the host, then read by the device; stays mapped
};

// Owns nothing: the resource that asked for it frees it. Host-visible memory is coherent.
struct Allocation {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    void* mapped = nullptr;  // null for kDevice
};

// The types of memory to try, the best first: what is full leaves the next, slower or not.
[[nodiscard]] std::vector<std::uint32_t> memory_types(const VkPhysicalDeviceMemoryProperties& memory,
                                                      std::uint32_t allowed, MemoryUse use);

Result<Allocation> allocate(const Device& device, const VkMemoryRequirements& needs, MemoryUse use);
void free_allocation(const Device& device, Allocation& allocation);

}  // namespace onggi::vk
