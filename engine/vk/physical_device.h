// Which of the machine's Vulkan devices draws. Main thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/instance.h"
#include "engine/vk/vulkan.h"

namespace onggi::vk {

// A device in words, for `onggi doctor` and for choosing.
struct DeviceDescription {
    int index = 0;  // in the loader's order
    std::string name{};
    VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
    std::string driver{};       // "llvmpipe"
    std::string driver_info{};  // "Mesa 22.3.6 (LLVM 15.0.6)"
    std::uint32_t api_version = 0;
    std::string lacks{};  // what it misses of what we need; empty: it can be used
    bool chosen = false;

    [[nodiscard]] bool is_cpu() const { return type == VK_PHYSICAL_DEVICE_TYPE_CPU; }
};

[[nodiscard]] std::string_view type_name(VkPhysicalDeviceType type);  // "discrete GPU", "CPU", ...
[[nodiscard]] std::string version_name(std::uint32_t api_version);    // "1.3.230"

// Whether the driver says when an image is on the screen: VK_KHR_present_id and VK_KHR_present_wait.
[[nodiscard]] bool tells_when_shown(VkPhysicalDevice device);

// What counts beside the request.
struct DevicePreference {
    bool cpu_first = false;  // of those that fit the request, the processor before any GPU
    // Those that have failed, by DeviceDescription::index, and all GPUs: one of them draws only where nothing
    // else can, whatever the request.
    std::vector<int> avoided{};
    bool avoids_gpus = false;
};

// Which of these to use, as an index into `devices`. request: an index ("0"), or a part of a name in any case
// ("nvidia"); empty: the best by type (discrete, integrated, virtual, CPU), the first of equals.
// System lacks: none that can be used. Bad input: the request fits none.
Result<std::size_t> choose(const std::vector<DeviceDescription>& devices, std::string_view request,
                           const DevicePreference& preference = {});

// What ONGGI_VULKAN_DEVICE wishes; empty when it is not set.
[[nodiscard]] std::string device_request_of_environment();

// Every device, the one that would be chosen marked. Makes and drops an instance of its own; an empty list
// where there is no device or no driver.
Result<std::vector<DeviceDescription>> describe_devices(
    std::string_view request = device_request_of_environment(), const DevicePreference& preference = {});

struct ChosenDevice {
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    DeviceDescription description;
    std::uint32_t queue_family = 0;  // graphics, compute, transfer, and presenting where it must
};

// surface: VK_NULL_HANDLE when nothing is presented. Nothing of it is asked of a device that would not be
// chosen.
Result<ChosenDevice> choose_device(const Instance& instance, VkSurfaceKHR surface,
                                   std::string_view request = device_request_of_environment(),
                                   const DevicePreference& preference = {});

}  // namespace onggi::vk
