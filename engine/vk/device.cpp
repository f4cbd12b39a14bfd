#include "engine/vk/device.h"

#include <string>
#include <vector>

#include "engine/vk/check.h"

namespace onggi::vk {

Result<std::unique_ptr<Device>> Device::create(const Instance& instance, const ChosenDevice& chosen,
                                               Presenting presenting) {
    std::unique_ptr<Device> self(new Device);
    self->physical_ = chosen.handle;
    self->description_ = chosen.description;
    self->queue_family_ = chosen.queue_family;
    vkGetPhysicalDeviceMemoryProperties(chosen.handle, &self->memory_);
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(chosen.handle, &properties);
    self->limits_ = properties.limits;

    VkPhysicalDeviceVulkan13Features features13{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
        .synchronization2 = VK_TRUE,
        .dynamicRendering = VK_TRUE};
    VkPhysicalDeviceVulkan12Features features12{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES,
        .pNext = &features13,
        .timelineSemaphore = VK_TRUE};

    const float priority = 1.0F;
    const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                        .queueFamilyIndex = chosen.queue_family,
                                        .queueCount = 1,
                                        .pQueuePriorities = &priority};
    std::vector<const char*> extensions;
    if (presenting != Presenting::kNone) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    VkPhysicalDevicePresentIdFeaturesKHR present_id{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_ID_FEATURES_KHR, .presentId = VK_TRUE};
    VkPhysicalDevicePresentWaitFeaturesKHR present_wait{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_WAIT_FEATURES_KHR,
        .pNext = &present_id,
        .presentWait = VK_TRUE};
    const bool tells = presenting == Presenting::kImagesInStep && tells_when_shown(chosen.handle);
    if (tells) {
        extensions.push_back(VK_KHR_PRESENT_ID_EXTENSION_NAME);
        extensions.push_back(VK_KHR_PRESENT_WAIT_EXTENSION_NAME);
        features13.pNext = &present_wait;
    }
    const bool imports = presenting == Presenting::kImagesInStep && chosen.description.is_cpu() &&
                         supports(chosen.handle, VK_EXT_EXTERNAL_MEMORY_HOST_EXTENSION_NAME);
    if (imports) extensions.push_back(VK_EXT_EXTERNAL_MEMORY_HOST_EXTENSION_NAME);
    const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                  .pNext = &features12,
                                  .queueCreateInfoCount = 1,
                                  .pQueueCreateInfos = &queue,
                                  .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
                                  .ppEnabledExtensionNames = extensions.data()};
    ONGGI_VK_TRY(vkCreateDevice(chosen.handle, &info, nullptr, &self->device_));
    vkGetDeviceQueue(self->device_, chosen.queue_family, 0, &self->queue_);
    if (tells) {
        self->wait_for_present_ = reinterpret_cast<PFN_vkWaitForPresentKHR>(
            vkGetDeviceProcAddr(self->device_, "vkWaitForPresentKHR"));
    }
    if (imports) {
        self->host_pointer_properties_ = reinterpret_cast<PFN_vkGetMemoryHostPointerPropertiesEXT>(
            vkGetDeviceProcAddr(self->device_, "vkGetMemoryHostPointerPropertiesEXT"));
    }
    if (instance.names_objects()) {
        self->set_name_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
            vkGetInstanceProcAddr(instance.handle(), "vkSetDebugUtilsObjectNameEXT"));
        self->begin_label_ = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(
            vkGetInstanceProcAddr(instance.handle(), "vkCmdBeginDebugUtilsLabelEXT"));
        self->end_label_ = reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(
            vkGetInstanceProcAddr(instance.handle(), "vkCmdEndDebugUtilsLabelEXT"));
    }

    const VkCommandPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                       .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                       .queueFamilyIndex = chosen.queue_family};
    ONGGI_VK_TRY(vkCreateCommandPool(self->device_, &pool, nullptr, &self->pool_));
    self->name(VK_OBJECT_TYPE_DEVICE, self->device_, self->description_.name);
    self->name(VK_OBJECT_TYPE_QUEUE, self->queue_, "queue");
    self->name(VK_OBJECT_TYPE_COMMAND_POOL, self->pool_, "commands");
    return self;
}

Device::~Device() {
    if (device_ == VK_NULL_HANDLE) return;
    vkDeviceWaitIdle(device_);
    if (pool_ != VK_NULL_HANDLE) vkDestroyCommandPool(device_, pool_, nullptr);
    vkDestroyDevice(device_, nullptr);
}

void Device::name(VkObjectType type, std::uint64_t object, std::string_view name) const {
    if (set_name_ == nullptr) return;
    const std::string text(name);
    const VkDebugUtilsObjectNameInfoEXT info{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                                             .objectType = type,
                                             .objectHandle = object,
                                             .pObjectName = text.c_str()};
    set_name_(device_, &info);  // failure is harmless: the object has no name
}

void Device::begin_region(VkCommandBuffer commands, const char* text) const {
    if (begin_label_ == nullptr) return;
    const VkDebugUtilsLabelEXT label{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT, .pLabelName = text};
    begin_label_(commands, &label);
}

void Device::end_region(VkCommandBuffer commands) const {
    if (end_label_ != nullptr) end_label_(commands);
}

std::span<const std::uint32_t> Device::in_place_of(std::span<const std::uint32_t> spirv) const {
    const auto found = replacements_.find(spirv.data());
    return found == replacements_.end() ? spirv : std::span<const std::uint32_t>(found->second);
}

Result<VkCommandBuffer> Device::allocate_commands(std::string_view text) const {
    const VkCommandBufferAllocateInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                           .commandPool = pool_,
                                           .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                           .commandBufferCount = 1};
    VkCommandBuffer commands = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(*this, vkAllocateCommandBuffers(device_, &info, &commands));
    name(VK_OBJECT_TYPE_COMMAND_BUFFER, commands, text);
    return commands;
}

void Device::free_commands(VkCommandBuffer commands) const {
    if (commands != VK_NULL_HANDLE) vkFreeCommandBuffers(device_, pool_, 1, &commands);
}

Result<VkCommandBuffer> Device::begin_once() const {
    auto commands = allocate_commands("loading");
    if (!commands) return commands;
    const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                         .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    ONGGI_VK_TRY_ON(*this, vkBeginCommandBuffer(*commands, &begin));
    return commands;
}

Result<void> Device::end_once(VkCommandBuffer commands) const {
    ONGGI_VK_TRY_ON(*this, vkEndCommandBuffer(commands));
    const VkCommandBufferSubmitInfo buffer{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                           .commandBuffer = commands};
    const VkSubmitInfo2 submit{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                               .commandBufferInfoCount = 1,
                               .pCommandBufferInfos = &buffer};
    ONGGI_VK_TRY_ON(*this, vkQueueSubmit2(queue_, 1, &submit, VK_NULL_HANDLE));
    ONGGI_VK_TRY_ON(*this, vkQueueWaitIdle(queue_));
    free_commands(commands);
    return {};
}

Result<OffscreenDevice> OffscreenDevice::open(const InstanceDesc& desc) {
    auto instance = Instance::create(desc);
    if (!instance) return instance.error();
    const auto chosen = choose_device(**instance, VK_NULL_HANDLE);
    if (!chosen) return chosen.error();
    auto device = Device::create(**instance, *chosen, Presenting::kNone);
    if (!device) return device.error();
    return OffscreenDevice{std::move(*instance), std::move(*device)};
}

}  // namespace onggi::vk
