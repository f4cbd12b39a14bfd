#include "engine/vk/timeline.h"

#include <array>

#include "engine/vk/check.h"

namespace onggi::vk {
namespace {

// Hang timeout: longer than any frame, even a first one that compiles its shaders in software on a busy
// machine.
constexpr std::uint64_t kHangNs = 120'000'000'000ULL;

VkSemaphoreSubmitInfo semaphore_info(VkSemaphore semaphore, std::uint64_t value,
                                     VkPipelineStageFlags2 stages) {
    return {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
            .semaphore = semaphore,
            .value = value,
            .stageMask = stages};
}

Result<Semaphore> create(const Device& device, VkSemaphoreType type, std::string_view name) {
    const VkSemaphoreTypeCreateInfo type_info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO,
                                              .semaphoreType = type};
    const VkSemaphoreCreateInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, .pNext = &type_info};
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
    const VkCommandBufferSubmitInfo buffer{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                           .commandBuffer = commands};
    const VkSemaphoreSubmitInfo wait = semaphore_info(
        wait_for, 0, VK_PIPELINE_STAGE_2_COPY_BIT | VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT);
    const std::array signals{
        semaphore_info(semaphore_.get(), value_ + 1, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT),
        semaphore_info(signal, 0, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT)};
    const VkSubmitInfo2 submit{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                               .waitSemaphoreInfoCount = wait_for == VK_NULL_HANDLE ? 0U : 1U,
                               .pWaitSemaphoreInfos = &wait,
                               .commandBufferInfoCount = 1,
                               .pCommandBufferInfos = &buffer,
                               .signalSemaphoreInfoCount = signal == VK_NULL_HANDLE ? 1U : 2U,
                               .pSignalSemaphoreInfos = signals.data()};
    ONGGI_VK_TRY_ON(device, vkQueueSubmit2(device.queue(), 1, &submit, VK_NULL_HANDLE));
    ++value_;
    return {};
}

Result<void> Timeline::wait(const Device& device) const {
    const VkSemaphore semaphore = semaphore_.get();
    const VkSemaphoreWaitInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO,
                                   .semaphoreCount = 1,
                                   .pSemaphores = &semaphore,
                                   .pValues = &value_};
    ONGGI_VK_TRY_ON(device, vkWaitSemaphores(device.handle(), &info, kHangNs));
    return {};
}

}  // namespace onggi::vk
