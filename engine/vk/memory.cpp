#include "engine/vk/memory.h"

#include <fmt/format.h>

#include <array>
#include <optional>

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
        case MemoryUse::kReadback:
            return {kHost, VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
        case MemoryUse::kDevice:
            break;
    }
    return {0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT};
}

std::optional<std::uint32_t> find_type(const VkPhysicalDeviceMemoryProperties& memory, std::uint32_t allowed,
                                       VkMemoryPropertyFlags wanted) {
    for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
        const bool is_allowed = (allowed & (1U << type)) != 0;
        if (is_allowed && (memory.memoryTypes[type].propertyFlags & wanted) == wanted) return type;
    }
    return std::nullopt;
}

}  // namespace

Result<Allocation> allocate(const Device& device, const VkMemoryRequirements& needs, MemoryUse use) {
    const Preference preference = preference_of(use);
    auto type = find_type(device.memory(), needs.memoryTypeBits, preference.needed | preference.liked);
    if (!type) type = find_type(device.memory(), needs.memoryTypeBits, preference.needed);
    if (!type) return system_lacks("Vulkan memory: expected a type that the host can write, found none");

    const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                    .pNext = nullptr,
                                    .allocationSize = needs.size,
                                    .memoryTypeIndex = *type};
    Allocation allocation;
    ONGGI_VK_TRY_ON(device, vkAllocateMemory(device.handle(), &info, nullptr, &allocation.memory));
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
