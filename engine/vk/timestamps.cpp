#include "engine/vk/timestamps.h"

#include "engine/vk/check.h"

namespace onggi::vk {

Result<Timestamps> Timestamps::create(const Device& device, std::uint32_t capacity, std::string_view name) {
    Timestamps timestamps;
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count, families.data());
    const std::uint32_t valid_bits =
        device.queue_family() < count ? families[device.queue_family()].timestampValidBits : 0;
    if (valid_bits == 0 || device.limits().timestampPeriod <= 0.0F) return timestamps;
    timestamps.valid_bits_ = valid_bits;
    const VkQueryPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                     .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                     .queryCount = capacity};
    VkQueryPool pool = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device, vkCreateQueryPool(device.handle(), &info, nullptr, &pool));
    timestamps.pool_ = {device.handle(), pool};
    device.name(VK_OBJECT_TYPE_QUERY_POOL, pool, name);
    timestamps.capacity_ = capacity;
    constexpr double kMsANanosecond = 1e-6;
    timestamps.ms_a_tick_ = double{device.limits().timestampPeriod} * kMsANanosecond;
    return timestamps;
}

std::uint64_t ticks_between(std::uint64_t earlier, std::uint64_t later, std::uint32_t valid_bits) {
    const std::uint64_t valid = valid_bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << valid_bits) - 1;
    return (later - earlier) & valid;
}

void Timestamps::begin(VkCommandBuffer commands) {
    marks_ = 0;
    if (capacity_ > 0) vkCmdResetQueryPool(commands, pool_.get(), 0, capacity_);
}

void Timestamps::mark(VkCommandBuffer commands) {
    if (marks_ >= capacity_) return;
    // The first mark needs no wait; a wait breaks up a software device's batches.
    const VkPipelineStageFlags2 after =
        marks_ == 0 ? VK_PIPELINE_STAGE_2_TOP_OF_PIPE_BIT : VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    vkCmdWriteTimestamp2(commands, after, pool_.get(), marks_++);
}

const std::vector<double>& Timestamps::read(const Device& device) {
    ms_.clear();
    if (marks_ == 0) return ms_;
    ticks_.resize(marks_);
    const VkResult result =
        vkGetQueryPoolResults(device.handle(), pool_.get(), 0, marks_, marks_ * sizeof(std::uint64_t),
                              ticks_.data(), sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT);
    if (result != VK_SUCCESS) return ms_;  // a missing time is no reason to lose a frame
    for (const std::uint64_t ticks : ticks_)
        ms_.push_back(static_cast<double>(ticks_between(ticks_.front(), ticks, valid_bits_)) * ms_a_tick_);
    return ms_;
}

}  // namespace onggi::vk
