// A simulated display for drivers without one: a Vulkan layer that reports when an image is on the screen
// (VK_KHR_present_id, VK_KHR_present_wait), which no software driver does. An image is shown at the first
// refresh after it was presented, ONGGI_DISPLAY_HZ times a second; with ONGGI_DISPLAY_IS_OFF set, never. One
// device and one thread that presents. All other calls go to the driver unchanged.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>
#include <string_view>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

constexpr VkExtensionProperties kOwn[] = {
    {VK_KHR_PRESENT_ID_EXTENSION_NAME, VK_KHR_PRESENT_ID_SPEC_VERSION},
    {VK_KHR_PRESENT_WAIT_EXTENSION_NAME, VK_KHR_PRESENT_WAIT_SPEC_VERSION}};

// Functions of the next layer or driver.
PFN_vkGetInstanceProcAddr instance_proc = nullptr;
PFN_vkCreateDevice create_device_below = nullptr;
PFN_vkEnumerateDeviceExtensionProperties enumerate_below = nullptr;
PFN_vkGetPhysicalDeviceFeatures2 get_features_below = nullptr;
PFN_vkGetDeviceProcAddr device_proc = nullptr;
PFN_vkQueuePresentKHR present = nullptr;

struct Image {
    std::uint64_t id = 0;
    Clock::time_point shown{};
};
std::map<VkSwapchainKHR, Image> last_of;

bool is_own(std::string_view extension) {
    return extension == kOwn[0].extensionName || extension == kOwn[1].extensionName;
}

double period_s() {
    const char* rate = std::getenv("ONGGI_DISPLAY_HZ");
    return 1.0 / (rate == nullptr ? 60.0 : std::strtod(rate, nullptr));
}

bool is_off() {
    return std::getenv("ONGGI_DISPLAY_IS_OFF") != nullptr;
}

// The next refresh that no other image uses.
Clock::time_point refresh_after(Clock::time_point taken) {
    const auto refresh_of = [](Clock::time_point at) {
        return std::ceil(std::chrono::duration<double>(at.time_since_epoch()).count() / period_s() - 1e-6);
    };
    const double refresh = std::max(refresh_of(Clock::now()), refresh_of(taken) + 1.0);
    return Clock::time_point(
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(refresh * period_s())));
}

// The loader's own link of this layer's chain.
template <typename Link>
Link* link_of(const void* chain, VkStructureType type) {
    auto* link = static_cast<Link*>(const_cast<void*>(chain));
    while (link != nullptr && !(link->sType == type && link->function == VK_LAYER_LINK_INFO))
        link = static_cast<Link*>(const_cast<void*>(link->pNext));
    return link;
}

void set_own_features(const void* chain, VkBool32 has) {
    for (auto* link = static_cast<VkBaseOutStructure*>(const_cast<void*>(chain)); link != nullptr;
         link = link->pNext) {
        if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_ID_FEATURES_KHR)
            reinterpret_cast<VkPhysicalDevicePresentIdFeaturesKHR*>(link)->presentId = has;
        if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_WAIT_FEATURES_KHR)
            reinterpret_cast<VkPhysicalDevicePresentWaitFeaturesKHR*>(link)->presentWait = has;
    }
}

VKAPI_ATTR VkResult VKAPI_CALL create_instance(const VkInstanceCreateInfo* info,
                                               const VkAllocationCallbacks* memory, VkInstance* instance) {
    auto* link =
        link_of<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    instance_proc = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create =
        reinterpret_cast<PFN_vkCreateInstance>(instance_proc(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, memory, instance);
    if (result != VK_SUCCESS) return result;
    // Queried now: later the loader would return the uppermost layer's function.
    const auto below = [&](const char* name) { return instance_proc(*instance, name); };
    create_device_below = reinterpret_cast<PFN_vkCreateDevice>(below("vkCreateDevice"));
    enumerate_below = reinterpret_cast<PFN_vkEnumerateDeviceExtensionProperties>(
        below("vkEnumerateDeviceExtensionProperties"));
    get_features_below =
        reinterpret_cast<PFN_vkGetPhysicalDeviceFeatures2>(below("vkGetPhysicalDeviceFeatures2"));
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                             const VkAllocationCallbacks* memory, VkDevice* device) {
    auto* link = link_of<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    device_proc = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    // The driver would refuse unknown features, so they are cleared for the call and restored afterwards for
    // the layers above.
    set_own_features(info->pNext, VK_FALSE);
    std::vector<const char*> extensions;
    for (std::uint32_t k = 0; k < info->enabledExtensionCount; ++k) {
        if (!is_own(info->ppEnabledExtensionNames[k])) extensions.push_back(info->ppEnabledExtensionNames[k]);
    }
    VkDeviceCreateInfo without = *info;
    without.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    without.ppEnabledExtensionNames = extensions.data();
    const VkResult result = create_device_below(physical, &without, memory, device);
    set_own_features(info->pNext, VK_TRUE);
    if (result == VK_SUCCESS)
        present = reinterpret_cast<PFN_vkQueuePresentKHR>(device_proc(*device, "vkQueuePresentKHR"));
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL enumerate_device_extensions(VkPhysicalDevice physical, const char* layer,
                                                           std::uint32_t* count,
                                                           VkExtensionProperties* properties) {
    if (layer != nullptr) return enumerate_below(physical, layer, count, properties);
    std::uint32_t others = 0;
    if (const VkResult asked = enumerate_below(physical, nullptr, &others, nullptr); asked != VK_SUCCESS)
        return asked;
    std::vector<VkExtensionProperties> all(others);
    if (const VkResult asked = enumerate_below(physical, nullptr, &others, all.data()); asked != VK_SUCCESS)
        return asked;
    all.insert(all.end(), std::begin(kOwn), std::end(kOwn));
    const auto size = static_cast<std::uint32_t>(all.size());
    if (properties == nullptr) {
        *count = size;
        return VK_SUCCESS;
    }
    const bool fits = *count >= size;
    *count = fits ? size : *count;
    std::copy_n(all.begin(), *count, properties);
    return fits ? VK_SUCCESS : VK_INCOMPLETE;
}

VKAPI_ATTR void VKAPI_CALL get_features(VkPhysicalDevice physical, VkPhysicalDeviceFeatures2* features) {
    get_features_below(physical, features);
    set_own_features(features->pNext, VK_TRUE);
}

VKAPI_ATTR VkResult VKAPI_CALL queue_present(VkQueue queue, const VkPresentInfoKHR* info) {
    const VkResult result = present(queue, info);
    for (const auto* link = static_cast<const VkBaseInStructure*>(info->pNext); link != nullptr;
         link = link->pNext) {
        if (link->sType != VK_STRUCTURE_TYPE_PRESENT_ID_KHR) continue;
        const auto* ids = reinterpret_cast<const VkPresentIdKHR*>(link);
        for (std::uint32_t k = 0; k < ids->swapchainCount; ++k) {
            Image& last = last_of[info->pSwapchains[k]];
            last.id = ids->pPresentIds[k];
            if (is_off()) continue;  // the image is dropped
            last.shown = refresh_after(last.shown);
            // A queue of two is full.
            std::this_thread::sleep_until(last.shown - std::chrono::duration<double>(2.0 * period_s()));
        }
    }
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL wait_for_present(VkDevice /*device*/, VkSwapchainKHR swapchain,
                                                std::uint64_t id, std::uint64_t most_ns) {
    const Image& last = last_of[swapchain];
    const auto until = Clock::now() + std::chrono::nanoseconds(most_ns);
    const bool comes = !is_off() && last.id >= id && last.shown <= until;
    std::this_thread::sleep_until(comes ? last.shown : until);
    return comes ? VK_SUCCESS : VK_TIMEOUT;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_device_proc(VkDevice device, const char* name) {
    const std::string_view wanted(name);
    if (wanted == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(get_device_proc);
    if (wanted == "vkQueuePresentKHR") return reinterpret_cast<PFN_vkVoidFunction>(queue_present);
    if (wanted == "vkWaitForPresentKHR") return reinterpret_cast<PFN_vkVoidFunction>(wait_for_present);
    return device_proc(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_instance_proc(VkInstance instance, const char* name) {
    const std::string_view wanted(name);
    if (wanted == "vkGetInstanceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(get_instance_proc);
    if (wanted == "vkCreateInstance") return reinterpret_cast<PFN_vkVoidFunction>(create_instance);
    if (wanted == "vkCreateDevice") return reinterpret_cast<PFN_vkVoidFunction>(create_device);
    if (wanted == "vkEnumerateDeviceExtensionProperties")
        return reinterpret_cast<PFN_vkVoidFunction>(enumerate_device_extensions);
    if (wanted == "vkGetPhysicalDeviceFeatures2") return reinterpret_cast<PFN_vkVoidFunction>(get_features);
    if (wanted == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(get_device_proc);
    return instance_proc(instance, name);
}

}  // namespace

extern "C" [[gnu::visibility("default")]] VkResult vkNegotiateLoaderLayerInterfaceVersion(
    VkNegotiateLayerInterface* loader) {
    constexpr std::uint32_t kVersion = 2;
    if (loader->loaderLayerInterfaceVersion < kVersion) return VK_ERROR_INITIALIZATION_FAILED;
    loader->loaderLayerInterfaceVersion = kVersion;
    loader->pfnGetInstanceProcAddr = get_instance_proc;
    loader->pfnGetDeviceProcAddr = get_device_proc;
    loader->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
