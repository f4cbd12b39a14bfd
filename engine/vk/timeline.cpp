#include "engine/vk/timeline.h"

#include <array>

#include "engine/vk/check.h"

namespace onggi::vk {
namespace {

// Longer than any frame, even a first one whose shaders are compiled in software on a machine that is busy
// with ten other things: a device that takes two minutes hangs.
constexpr std::uint64_t kHangNs = 120'000'000'000ULL;

VkSemaphoreSubmitInfo semaphore_info(VkSemaphore semaphore, std::uint64_t value,
                                     VkPipelineStageFlags2 stages) {
    VkSemaphoreSubmitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
    info.semaphore = semaphore;
    info.value = value;
    info.stageMask = stages;
    return info;
}

Result<Semaphore> create(const Device& device, VkSemaphoreType type, std::string_view name) {
    VkSemaphoreTypeCreateInfo type_info{};
    type_info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO;
    type_info.semaphoreType = type;
    VkSemaphoreCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
    info.pNext = &type_info;
    VkSemaphore semaphore = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device, vkCreateSemaphore(device.handle(), &info, nullptr, &semaphore));
    device.name(VK_OBJECT_TYPE_SEMAPHORE, semaphore, name);
    return Semaphore(device.handle(), semaphore);
}

}  // namespace

Result<Semaphore> create_semaphore(const Device& device, std::string_view name) {
    return create(device, VK_SEMAPHORE_TYPE_BINARY, name);
}

Result<Timeline> Timeline::create(const Device& device, std::string_view name) {
    auto semaphore = vk::create(device, VK_SEMAPHORE_TYPE_TIMELINE, name);
    if (!semaphore) return semaphore.error();
    Timeline timeline;
    timeline.semaphore_ = std::move(*semaphore);
    return timeline;
}

Result<void> Timeline::submit(const Device& device, VkCommandBuffer commands, VkSemaphore wait_for,
                              VkSemaphore signal) {
    VkCommandBufferSubmitInfo buffer{};
    buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    buffer.commandBuffer = commands;
    const VkSemaphoreSubmitInfo wait = semaphore_info(
        wait_for, 0, VK_PIPELINE_STAGE_2_COPY_BIT | VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT);
    const std::array signals{
        semaphore_info(semaphore_.get(), value_ + 1, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT),
        semaphore_info(signal, 0, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT)};
    VkSubmitInfo2 submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    submit.waitSemaphoreInfoCount = wait_for == VK_NULL_HANDLE ? 0 : 1;
    submit.pWaitSemaphoreInfos = &wait;
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &buffer;
    submit.signalSemaphoreInfoCount = signal == VK_NULL_HANDLE ? 1 : 2;
    submit.pSignalSemaphoreInfos = signals.data();
    ONGGI_VK_TRY_ON(device, vkQueueSubmit2(device.queue(), 1, &submit, VK_NULL_HANDLE));
    ++value_;
    return {};
}

Result<void> Timeline::wait(const Device& device) const {
    const VkSemaphore semaphore = semaphore_.get();
    VkSemaphoreWaitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO;
    info.semaphoreCount = 1;
    info.pSemaphores = &semaphore;
    info.pValues = &value_;
    ONGGI_VK_TRY_ON(device, vkWaitSemaphores(device.handle(), &info, kHangNs));
    return {};
}

}  // namespace onggi::vk
