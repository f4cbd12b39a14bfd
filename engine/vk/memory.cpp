#include "engine/vk/memory.h"

#include <algorithm>

#include "engine/vk/check.h"

namespace onggi::vk {
namespace {

struct Preference {
    VkMemoryPropertyFlags needed;
    VkMemoryPropertyFlags liked;
};

Preference preference_of(MemoryUse use) {
    constexpr VkMemoryPropertyFlags kHost =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    switch (use) {
        case MemoryUse::kUpload:
            return {kHost, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT};
        // Memory that the host reads must not be write-combined: such a read is about a hundred times slower.
        case MemoryUse::kReadback:
        case MemoryUse::kWork:
            return {kHost, VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
        case MemoryUse::kDevice:
            break;
    }
    return {0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT};
}

bool is_out_of_memory(VkResult result) {
    return result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY;
}

}  // namespace

std::vector<std::uint32_t> memory_types(const VkPhysicalDeviceMemoryProperties& memory, std::uint32_t allowed,
                                        MemoryUse use) {
    // Property flags from extensions are off limits without enabling the extension.
    constexpr VkMemoryPropertyFlags kKnown =
        VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
        VK_MEMORY_PROPERTY_HOST_COHERENT_BIT | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
    const Preference preference = preference_of(use);
    std::vector<std::uint32_t> types;
    for (const VkMemoryPropertyFlags wanted : {preference.needed | preference.liked, preference.needed}) {
        for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
            const VkMemoryPropertyFlags has = memory.memoryTypes[type].propertyFlags;
            const bool is_allowed = (allowed & (1U << type)) != 0 && (has & ~kKnown) == 0;
            const bool is_listed = std::find(types.begin(), types.end(), type) != types.end();
            if (is_allowed && !is_listed && (has & wanted) == wanted) types.push_back(type);
        }
    }
    return types;
}

Result<Allocation> allocate(const Device& device, const VkMemoryRequirements& needs, MemoryUse use) {
    Allocation allocation;
    VkResult result = VK_ERROR_FEATURE_NOT_PRESENT;
    for (const std::uint32_t type : memory_types(device.memory(), needs.memoryTypeBits, use)) {
        const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                        .allocationSize = needs.size,
                                        .memoryTypeIndex = type};
        result = device.health().before("vkAllocateMemory");
        if (result == VK_SUCCESS)
            result = vkAllocateMemory(device.handle(), &info, nullptr, &allocation.memory);
        if (!is_out_of_memory(result)) break;
    }
    if (result == VK_ERROR_FEATURE_NOT_PRESENT)
        return system_lacks("Vulkan memory: expected a type that the host can write, found none");
    device.health().note(result);
    if (auto allocated = check(result, "vkAllocateMemory"); !allocated) return allocated.error();
    if (use != MemoryUse::kDevice) {
        const VkResult mapped =
            vkMapMemory(device.handle(), allocation.memory, 0, VK_WHOLE_SIZE, 0, &allocation.mapped);
        if (mapped != VK_SUCCESS) free_allocation(device, allocation);
        device.health().note(mapped);
        ONGGI_VK_TRY(mapped);
    }
    return allocation;
}

void free_allocation(const Device& device, Allocation& allocation) {
    if (allocation.memory != VK_NULL_HANDLE) vkFreeMemory(device.handle(), allocation.memory, nullptr);
    allocation = {};
}

}  // namespace onggi::vk
