// Selects one of the machine's Vulkan devices. Main thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/instance.h"
#include "engine/vk/vulkan.h"

namespace onggi::vk {

// Description of a device, for `onggi doctor` and for the selection.
struct DeviceDescription {
    int index = 0;  // in the loader's order
    std::string name{};
    VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
    std::string driver{};       // "llvmpipe"
    std::string driver_info{};  // "Mesa 22.3.6 (LLVM 15.0.6)"
    std::uint32_t api_version = 0;
    std::string lacks{};  // missing requirements; empty: usable
    bool chosen = false;

    [[nodiscard]] bool is_cpu() const { return type == VK_PHYSICAL_DEVICE_TYPE_CPU; }
};

[[nodiscard]] std::string_view type_name(VkPhysicalDeviceType type);  // "discrete GPU", "CPU", ...
[[nodiscard]] std::string version_name(std::uint32_t api_version);    // "1.3.230"

// Whether the driver reports when an image is on the screen: VK_KHR_present_id and VK_KHR_present_wait.
[[nodiscard]] bool tells_when_shown(VkPhysicalDevice device);

// Criteria besides the request.
struct DevicePreference {
    bool cpu_first = false;  // prefers a CPU device to any GPU among the matching devices
    // Devices that have failed, by DeviceDescription::index; and whether to avoid all GPUs. An avoided device
    // is chosen only if no other is usable, whatever the request.
    std::vector<int> avoided{};
    bool avoids_gpus = false;
};

// Returns the device to use, as an index into `devices`. request: an index ("0"), or part of a name in any
// case ("nvidia"); empty: the best by type (discrete, integrated, virtual, CPU), the first among equals.
// System lacks: no device is usable. Bad input: no usable device matches the request.
Result<std::size_t> choose(const std::vector<DeviceDescription>& devices, std::string_view request,
                           const DevicePreference& preference = {});

// Returns the value of ONGGI_VULKAN_DEVICE; empty if it is not set.
[[nodiscard]] std::string device_request_of_environment();

// Returns all devices, with the one that would be chosen marked. Uses a temporary instance. Empty if there is
// no device or no driver.
Result<std::vector<DeviceDescription>> describe_devices(
    std::string_view request = device_request_of_environment(), const DevicePreference& preference = {});

[[nodiscard]] bool supports(VkPhysicalDevice device, const char* name);

struct ChosenDevice {
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    DeviceDescription description;
    // Supports graphics, compute and transfer, and presenting if there is a surface.
    std::uint32_t queue_family = 0;
};

// surface: VK_NULL_HANDLE if nothing is presented. Surface support is queried only on a device that would be
// chosen.
Result<ChosenDevice> choose_device(const Instance& instance, VkSurfaceKHR surface,
                                   std::string_view request = device_request_of_environment(),
                                   const DevicePreference& preference = {});

}  // namespace onggi::vk
