// The logical device: one queue, one command pool, and the few features the renderer stands on (Vulkan 1.3
// with dynamic rendering, synchronization2 and timeline semaphores). Main thread.
#pragma once

#include <memory>
#include <string_view>

#include "engine/core/result.h"
#include "engine/vk/physical_device.h"
#include "engine/vk/vulkan.h"

namespace onggi::vk {

class Device {
  public:
    // presents: with VK_KHR_swapchain. The instance must outlive the device.
    static Result<std::unique_ptr<Device>> create(const Instance& instance, const ChosenDevice& chosen,
                                                  bool presents);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] VkDevice handle() const { return device_; }
    [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
    [[nodiscard]] VkQueue queue() const { return queue_; }
    [[nodiscard]] std::uint32_t queue_family() const { return queue_family_; }
    [[nodiscard]] const DeviceDescription& description() const { return description_; }
    [[nodiscard]] bool is_cpu() const { return description_.is_cpu(); }
    [[nodiscard]] const VkPhysicalDeviceMemoryProperties& memory() const { return memory_; }
    [[nodiscard]] const VkPhysicalDeviceLimits& limits() const { return limits_; }

    // Shown by the validation layer and by frame debuggers instead of a number.
    void name(VkObjectType type, std::uint64_t object, std::string_view name) const;
    template <typename Handle>
    void name(VkObjectType type, Handle handle, std::string_view text) const {
        name(type, reinterpret_cast<std::uint64_t>(handle), text);
    }

    [[nodiscard]] Result<VkCommandBuffer> allocate_commands(std::string_view name) const;

    // Records with `record` and waits until it is done: for loading, not for frames.
    template <typename Record>
    Result<void> run_once(Record&& record) const {
        auto commands = begin_once();
        if (!commands) return commands.error();
        record(*commands);
        return end_once(*commands);
    }

  private:
    Device() = default;
    Result<VkCommandBuffer> begin_once() const;
    Result<void> end_once(VkCommandBuffer commands) const;

    VkDevice device_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    std::uint32_t queue_family_ = 0;
    DeviceDescription description_;
    VkPhysicalDeviceMemoryProperties memory_{};
    VkPhysicalDeviceLimits limits_{};
    PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
};

}  // namespace onggi::vk
