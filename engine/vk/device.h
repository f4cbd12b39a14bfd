// The logical device: one queue, one command pool, and the few features the renderer stands on (Vulkan 1.3
// with dynamic rendering, synchronization2 and timeline semaphores). Main thread.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/health.h"
#include "engine/vk/instance.h"
#include "engine/vk/physical_device.h"
#include "engine/vk/vulkan.h"

namespace onggi::vk {

// Shaders that stand in for others, found by where the others' first word lies.
using SpirvReplacements = std::map<const std::uint32_t*, std::vector<std::uint32_t>>;

// What a device is to do with a window.
enum class Presenting {
    kNone,
    kImages,        // VK_KHR_swapchain
    kImagesInStep,  // and says when an image is on the screen, where its driver can: VK_KHR_present_wait
};

class Device {
  public:
    // The instance must outlive the device.
    static Result<std::unique_ptr<Device>> create(const Instance& instance, const ChosenDevice& chosen,
                                                  Presenting presenting);
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

    // Null where nobody asked for it, or the driver does not say when an image is on the screen.
    [[nodiscard]] PFN_vkWaitForPresentKHR wait_for_present() const { return wait_for_present_; }

    // Shown by the validation layer and by frame debuggers instead of a number.
    void name(VkObjectType type, std::uint64_t object, std::string_view name) const;
    template <typename Handle>
    void name(VkObjectType type, Handle handle, std::string_view text) const {
        name(type, reinterpret_cast<std::uint64_t>(handle), text);
    }

    // What is recorded between the two is shown under this name by frame debuggers.
    void begin_region(VkCommandBuffer commands, const char* text) const;
    void end_region(VkCommandBuffer commands) const;

    // What has become of it; it outlives none of its resources, so they all may note it.
    [[nodiscard]] Health& health() const { return *health_; }

    // For pipelines made from now on; empty but while somebody edits shaders.
    void replace_spirv(SpirvReplacements replacements) { replacements_ = std::move(replacements); }
    [[nodiscard]] std::span<const std::uint32_t> in_place_of(std::span<const std::uint32_t> spirv) const;

    [[nodiscard]] Result<VkCommandBuffer> allocate_commands(std::string_view name) const;
    // Precondition: the device is done with them. Whoever does not goes on having them until the device goes.
    void free_commands(VkCommandBuffer commands) const;

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
    SpirvReplacements replacements_;
    std::unique_ptr<Health> health_ = std::make_unique<Health>();
    PFN_vkWaitForPresentKHR wait_for_present_ = nullptr;
    PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT begin_label_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT end_label_ = nullptr;
};

// The device that draws where there is no window, and the instance it stands on.
struct OffscreenDevice {
    std::unique_ptr<Instance> instance;
    std::unique_ptr<Device> device;

    // Errors as of Instance::create(), choose_device() and Device::create().
    static Result<OffscreenDevice> open(const InstanceDesc& desc = {});
};

}  // namespace onggi::vk
