#include "engine/vk/physical_device.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "engine/core/number_in.h"

namespace onggi::vk {
namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

int rank_of(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return 4;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return 3;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return 2;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return 1;
        default:
            return 0;
    }
}

}  // namespace

bool supports(VkPhysicalDevice device, const char* name) {
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(), [&](const VkExtensionProperties& extension) {
        return std::strcmp(extension.extensionName, name) == 0;
    });
}

namespace {

std::optional<std::uint32_t> find_queue_family(VkPhysicalDevice device, VkSurfaceKHR surface) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    for (std::uint32_t family = 0; family < count; ++family) {
        if ((families[family].queueFlags & VK_QUEUE_GRAPHICS_BIT) == 0) continue;
        if (surface == VK_NULL_HANDLE) return family;
        VkBool32 presents = VK_FALSE;
        const VkResult asked = vkGetPhysicalDeviceSurfaceSupportKHR(device, family, surface, &presents);
        if (asked == VK_SUCCESS && presents == VK_TRUE) return family;
    }
    return std::nullopt;
}

std::string what_it_lacks(VkPhysicalDevice device, std::uint32_t api_version) {
    if (api_version < VK_API_VERSION_1_3) return "Vulkan 1.3";
    VkPhysicalDeviceVulkan13Features features13{.sType =
                                                    VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceVulkan12Features features12{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, .pNext = &features13};
    VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2,
                                       .pNext = &features12};
    vkGetPhysicalDeviceFeatures2(device, &features);
    if (features13.dynamicRendering == VK_FALSE) return "dynamicRendering";
    if (features13.synchronization2 == VK_FALSE) return "synchronization2";
    if (features12.timelineSemaphore == VK_FALSE) return "timelineSemaphore";
    if (!find_queue_family(device, VK_NULL_HANDLE)) return "a graphics queue";
    return {};
}

std::string what_it_lacks_for(VkPhysicalDevice device, VkSurfaceKHR surface) {
    if (!find_queue_family(device, surface)) return "a graphics queue that presents to the window";
    if (!supports(device, VK_KHR_SWAPCHAIN_EXTENSION_NAME)) return VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    return {};
}

DeviceDescription describe(VkPhysicalDevice device, int index) {
    VkPhysicalDeviceDriverProperties driver{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    vkGetPhysicalDeviceProperties(device, &properties.properties);
    // The driver's name came with 1.2; older devices do not fill it in.
    if (properties.properties.apiVersion >= VK_API_VERSION_1_2) {
        properties.pNext = &driver;
        vkGetPhysicalDeviceProperties2(device, &properties);
    }
    const VkPhysicalDeviceProperties& plain = properties.properties;
    return {.index = index,
            .name = plain.deviceName,
            .type = plain.deviceType,
            .driver = driver.driverName,
            .driver_info = driver.driverInfo,
            .api_version = plain.apiVersion,
            .lacks = what_it_lacks(device, plain.apiVersion),
            .chosen = false};
}

std::vector<VkPhysicalDevice> enumerate(VkInstance instance) {
    std::uint32_t count = 0;
    if (vkEnumeratePhysicalDevices(instance, &count, nullptr) != VK_SUCCESS) return {};
    std::vector<VkPhysicalDevice> handles(count);
    if (vkEnumeratePhysicalDevices(instance, &count, handles.data()) < VK_SUCCESS) return {};
    handles.resize(count);
    return handles;
}

std::vector<DeviceDescription> describe_all(const std::vector<VkPhysicalDevice>& handles) {
    std::vector<DeviceDescription> descriptions;
    for (VkPhysicalDevice handle : handles)
        descriptions.push_back(describe(handle, static_cast<int>(descriptions.size())));
    return descriptions;
}

bool is_to_be_avoided(const DeviceDescription& device, const DevicePreference& preference) {
    const auto& avoided = preference.avoided;
    return (preference.avoids_gpus && !device.is_cpu()) ||
           std::find(avoided.begin(), avoided.end(), device.index) != avoided.end();
}

std::string names_of(const std::vector<DeviceDescription>& devices) {
    std::vector<std::string> names;
    for (const DeviceDescription& device : devices) {
        names.push_back(device.lacks.empty()
                            ? fmt::format("{} {}", device.index, device.name)
                            : fmt::format("{} {} (lacks {})", device.index, device.name, device.lacks));
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

bool tells_when_shown(VkPhysicalDevice device) {
    if (!supports(device, VK_KHR_PRESENT_ID_EXTENSION_NAME) ||
        !supports(device, VK_KHR_PRESENT_WAIT_EXTENSION_NAME))
        return false;
    VkPhysicalDevicePresentIdFeaturesKHR id{.sType =
                                                VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_ID_FEATURES_KHR};
    VkPhysicalDevicePresentWaitFeaturesKHR wait{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_WAIT_FEATURES_KHR, .pNext = &id};
    VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, .pNext = &wait};
    vkGetPhysicalDeviceFeatures2(device, &features);
    return id.presentId == VK_TRUE && wait.presentWait == VK_TRUE;
}

std::string_view type_name(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return "discrete GPU";
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return "integrated GPU";
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return "virtual GPU";
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return "CPU";
        default:
            return "other";
    }
}

std::string version_name(std::uint32_t api_version) {
    return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(api_version), VK_API_VERSION_MINOR(api_version),
                       VK_API_VERSION_PATCH(api_version));
}

std::string device_request_of_environment() {
    const char* request = std::getenv("ONGGI_VULKAN_DEVICE");
    return request == nullptr ? std::string() : std::string(request);
}

Result<std::size_t> choose(const std::vector<DeviceDescription>& devices, std::string_view request,
                           const DevicePreference& preference) {
    if (devices.empty()) {
        return system_lacks(
            "Vulkan: expected a device, found none; install a driver (mesa-vulkan-drivers draws without a "
            "GPU)");
    }
    const auto requested_index = number_in<int>(request);
    const auto fits = [&](const DeviceDescription& device) {
        if (requested_index) return device.index == *requested_index;
        return lower(device.name).find(lower(request)) != std::string::npos;
    };
    // Avoided devices rank after all others; among equals the first wins.
    const auto rank = [&](const DeviceDescription& device) {
        constexpr int kAboveAllTypes = 5;
        const int by_type = preference.cpu_first && device.is_cpu() ? kAboveAllTypes : rank_of(device.type);
        return is_to_be_avoided(device, preference) ? by_type - kAboveAllTypes - 1 : by_type;
    };
    std::optional<std::size_t> best;  // among those that match the request
    std::optional<std::size_t> of_all;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        if (!devices[i].lacks.empty()) continue;
        const auto is_better = [&](const std::optional<std::size_t>& than) {
            return !than || rank(devices[i]) > rank(devices[*than]);
        };
        if (is_better(of_all)) of_all = i;
        if (fits(devices[i]) && is_better(best)) best = i;
    }
    if (best && is_to_be_avoided(devices[*best], preference)) return *of_all;
    if (best) return *best;
    if (!request.empty()) {
        return bad_input(
            fmt::format("ONGGI_VULKAN_DEVICE '{}': expected the index or a part of the name of a Vulkan "
                        "device that can be "
                        "used, found {}",
                        request, names_of(devices)));
    }
    return system_lacks(
        fmt::format("Vulkan: expected a device with all required features, found {}; install a newer driver "
                    "(mesa-vulkan-drivers draws without a GPU)",
                    names_of(devices)));
}

Result<std::vector<DeviceDescription>> describe_devices(std::string_view request,
                                                        const DevicePreference& preference) {
    auto instance = Instance::create({});
    if (!instance) return instance.error();
    std::vector<DeviceDescription> devices = describe_all(enumerate((*instance)->handle()));
    if (const auto chosen = choose(devices, request, preference)) devices[*chosen].chosen = true;
    return devices;
}

Result<ChosenDevice> choose_device(const Instance& instance, VkSurfaceKHR surface, std::string_view request,
                                   const DevicePreference& preference) {
    const std::vector<VkPhysicalDevice> handles = enumerate(instance.handle());
    std::vector<DeviceDescription> devices = describe_all(handles);
    auto chosen = choose(devices, request, preference);
    // Query surface support only on the chosen device: some drivers crash in this query (NVIDIA's 580 does on
    // an X server without GLX). A device that keeps crashing is avoided, see DevicePreference.
    while (chosen && surface != VK_NULL_HANDLE) {
        devices[*chosen].lacks = what_it_lacks_for(handles[*chosen], surface);
        if (devices[*chosen].lacks.empty()) break;
        chosen = choose(devices, request, preference);
    }
    if (!chosen) return chosen.error();
    ChosenDevice device{.handle = handles[*chosen],
                        .description = devices[*chosen],
                        .queue_family = find_queue_family(handles[*chosen], surface).value_or(0)};
    device.description.chosen = true;
    return device;
}

}  // namespace onggi::vk
