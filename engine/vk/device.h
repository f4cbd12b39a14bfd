// The logical device: one queue, one command pool, and the few features that the renderer requires (Vulkan
// 1.3 with dynamic rendering, synchronization2 and timeline semaphores). Main thread.
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

// Replacement shaders, keyed by the address of the original's first word.
using SpirvReplacements = std::map<const std::uint32_t*, std::vector<std::uint32_t>>;

// The device's use of a window.
enum class Presenting {
    kNone,
    kImages,  // VK_KHR_swapchain
    // Also, if the driver has them: VK_KHR_present_wait, to learn when an image is on the screen; on a
    // software device VK_EXT_external_memory_host, to draw into a window's memory.
    kImagesInStep,
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

    // Null if kImagesInStep was not requested, or if the driver cannot tell when an image is on the screen.
    [[nodiscard]] PFN_vkWaitForPresentKHR wait_for_present() const { return wait_for_present_; }

    // Null if the device does not import memory of the host: requested for windows of a software device.
    [[nodiscard]] PFN_vkGetMemoryHostPointerPropertiesEXT host_pointer_properties() const {
        return host_pointer_properties_;
    }

    // Sets the name that the validation layer and frame debuggers show for an object.
    void name(VkObjectType type, std::uint64_t object, std::string_view name) const;
    template <typename Handle>
    void name(VkObjectType type, Handle handle, std::string_view text) const {
        name(type, reinterpret_cast<std::uint64_t>(handle), text);
    }

    // Frame debuggers show the commands between begin_region() and end_region() under this name.
    void begin_region(VkCommandBuffer commands, const char* text) const;
    void end_region(VkCommandBuffer commands) const;

    // The device's health. The device outlives its resources, so all of them may report to it.
    [[nodiscard]] Health& health() const { return *health_; }

    // Applies to pipelines created from now on. Empty except while shaders are being edited.
    void replace_spirv(SpirvReplacements replacements) { replacements_ = std::move(replacements); }
    [[nodiscard]] std::span<const std::uint32_t> in_place_of(std::span<const std::uint32_t> spirv) const;

    [[nodiscard]] Result<VkCommandBuffer> allocate_commands(std::string_view name) const;
    // Precondition: the device has finished the commands. Commands that are not freed live as long as the
    // device.
    void free_commands(VkCommandBuffer commands) const;

    // Records with `record`, submits, and waits for completion: for loading, not for frames.
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
    PFN_vkGetMemoryHostPointerPropertiesEXT host_pointer_properties_ = nullptr;
    PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT begin_label_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT end_label_ = nullptr;
};

// A device for drawing without a window, and its instance.
struct OffscreenDevice {
    std::unique_ptr<Instance> instance;
    std::unique_ptr<Device> device;

    // Errors: those of Instance::create(), choose_device() and Device::create().
    static Result<OffscreenDevice> open(const InstanceDesc& desc = {});
};

}  // namespace onggi::vk
