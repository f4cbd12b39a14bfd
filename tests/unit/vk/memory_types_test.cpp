// The order of memory types for each use, on machines as drivers describe them.
#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

#include "engine/vk/memory.h"

namespace onggi::vk {
namespace {

constexpr VkMemoryPropertyFlags kLocal = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
constexpr VkMemoryPropertyFlags kHost =
    VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr VkMemoryPropertyFlags kCached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
constexpr std::uint32_t kAll = ~0U;

VkPhysicalDeviceMemoryProperties memory_of(std::initializer_list<VkMemoryPropertyFlags> types) {
    VkPhysicalDeviceMemoryProperties memory{};
    for (const VkMemoryPropertyFlags flags : types)
        memory.memoryTypes[memory.memoryTypeCount++].propertyFlags = flags;
    return memory;
}

// A discrete GPU with a window of write-combined memory, as radv lists it.
const VkPhysicalDeviceMemoryProperties kDiscrete =
    memory_of({kLocal, kHost, kLocal | kHost, kHost | kCached});
using Types = std::vector<std::uint32_t>;

TEST(MemoryTypes, BeginWithTheBestAndEndWithAnyThatWillDo) {
    EXPECT_EQ(memory_types(kDiscrete, kAll, MemoryUse::kDevice), (Types{0, 2, 1, 3}));
    EXPECT_EQ(memory_types(kDiscrete, kAll, MemoryUse::kUpload), (Types{2, 1, 3}));
}

TEST(MemoryTypes, AreCachedBeforeAllOthersWhereTheHostReads) {
    for (const MemoryUse use : {MemoryUse::kReadback, MemoryUse::kWork})
        EXPECT_EQ(memory_types(kDiscrete, kAll, use), (Types{3, 1, 2}));
}

TEST(MemoryTypes, AreOnlyThoseThatAResourceMayHave) {
    EXPECT_EQ(memory_types(kDiscrete, 0b0010, MemoryUse::kDevice), (Types{1}));
    EXPECT_TRUE(memory_types(kDiscrete, 0b0001, MemoryUse::kUpload).empty());
}

TEST(MemoryTypes, ExcludeTypesThatNeedAnExtension) {
    constexpr VkMemoryPropertyFlags kDeviceCoherent = VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD;
    const auto memory = memory_of({kLocal | kDeviceCoherent, kLocal, kHost | kDeviceCoherent, kHost});
    EXPECT_EQ(memory_types(memory, kAll, MemoryUse::kDevice), (Types{1, 3}));
    EXPECT_EQ(memory_types(memory, kAll, MemoryUse::kUpload), (Types{3}));
}

}  // namespace
}  // namespace onggi::vk
