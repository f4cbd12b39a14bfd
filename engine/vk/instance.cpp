#include "engine/vk/instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "engine/vk/check.h"

namespace onggi::vk {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL hear(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                    const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    // An exception must not propagate through the driver; losing a message is harmless.
    try {
        static_cast<std::vector<std::string>*>(user)->emplace_back(data->pMessage);
    } catch (...) {
    }
    return VK_FALSE;
}

bool has_layer(const char* name) {
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(), [&](const VkLayerProperties& layer) {
        return std::strcmp(layer.layerName, name) == 0;
    });
}

bool has_extension(const char* name) {
    std::uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(), [&](const VkExtensionProperties& extension) {
        return std::strcmp(extension.extensionName, name) == 0;
    });
}

// An instance that is never destroyed keeps the drivers loaded. Otherwise the loader reloads them for each
// instance, and each reload uses up some of the static thread-local storage that glibc reserves for late
// libraries (rtld.optional_static_tls): with NVIDIA's 580, the thirtieth instance fails.
void keep_drivers_loaded(const VkApplicationInfo& application) {
    static const VkInstance kept = [&] {
        const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                        .pApplicationInfo = &application};
        VkInstance made = VK_NULL_HANDLE;
        static_cast<void>(vkCreateInstance(&info, nullptr, &made));
        return made;
    }();
    static_cast<void>(kept);
}

}  // namespace

Result<std::unique_ptr<Instance>> Instance::create(const InstanceDesc& desc) {
    std::uint32_t loader_version = VK_API_VERSION_1_0;
    vkEnumerateInstanceVersion(&loader_version);
    if (loader_version < VK_API_VERSION_1_3) {
        return system_lacks(
            fmt::format("Vulkan loader: expected version 1.3 or later, found {}.{}; install libvulkan1",
                        VK_API_VERSION_MAJOR(loader_version), VK_API_VERSION_MINOR(loader_version)));
    }
    std::unique_ptr<Instance> self(new Instance);

    std::vector<const char*> layers;
    if (desc.validation) {
        if (!has_layer(kValidationLayer)) {
            return system_lacks(fmt::format(
                "Vulkan validation: expected layer {}, found none; install vulkan-validationlayers",
                kValidationLayer));
        }
        layers.push_back(kValidationLayer);
    }
    std::vector<const char*> extensions;
    for (const std::string& extension : desc.extensions)
        extensions.push_back(extension.c_str());
    self->has_debug_utils_ = desc.validation || has_extension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (self->has_debug_utils_) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

    const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                        .pApplicationName = "onggi",
                                        .pEngineName = "onggi",
                                        .apiVersion = VK_API_VERSION_1_3};
    const VkDebugUtilsMessengerCreateInfoEXT messenger{
        .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
        .messageSeverity =
            VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
        // Not VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL: there the loader reports which drivers it skipped.
        .messageType =
            VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT,
        .pfnUserCallback = hear,
        .pUserData = self->messages_.get()};
    // Also reports missing synchronisation between commands.
    const VkValidationFeatureEnableEXT synchronization =
        VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    const VkValidationFeaturesEXT features{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                           .pNext = &messenger,
                                           .enabledValidationFeatureCount = 1,
                                           .pEnabledValidationFeatures = &synchronization};
    const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                    // Chained in, so that messages during creation and destruction are
                                    // received too.
                                    .pNext = desc.validation ? &features : nullptr,
                                    .pApplicationInfo = &application,
                                    .enabledLayerCount = static_cast<std::uint32_t>(layers.size()),
                                    .ppEnabledLayerNames = layers.data(),
                                    .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
                                    .ppEnabledExtensionNames = extensions.data()};
    if (const VkResult result = vkCreateInstance(&info, nullptr, &self->instance_); result != VK_SUCCESS) {
        // has_layer() checks only the layer's manifest, not that it loads.
        const char* remedy = result == VK_ERROR_LAYER_NOT_PRESENT
                                 ? "a requested layer does not load; reinstall it (vulkan-validationlayers)"
                                 : "install a driver (mesa-vulkan-drivers)";
        return system_lacks(
            fmt::format("Vulkan: expected an instance, found {}; {}", result_name(result), remedy));
    }
    keep_drivers_loaded(application);
    if (desc.validation) {
        const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(self->instance_, "vkCreateDebugUtilsMessengerEXT"));
        ONGGI_VK_TRY(create(self->instance_, &messenger, nullptr, &self->messenger_));
    }
    return self;
}

Instance::~Instance() {
    if (messenger_ != VK_NULL_HANDLE) {
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(instance_, messenger_, nullptr);
    }
    if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

}  // namespace onggi::vk
