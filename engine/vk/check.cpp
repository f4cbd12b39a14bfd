#include "engine/vk/check.h"

#include <fmt/format.h>

namespace onggi::vk {

std::string_view result_name(VkResult result) {
    switch (result) {
#define ONGGI_NAME(name) \
    case name:           \
        return #name
        ONGGI_NAME(VK_SUCCESS);
        ONGGI_NAME(VK_NOT_READY);
        ONGGI_NAME(VK_TIMEOUT);
        ONGGI_NAME(VK_INCOMPLETE);
        ONGGI_NAME(VK_SUBOPTIMAL_KHR);
        ONGGI_NAME(VK_ERROR_OUT_OF_HOST_MEMORY);
        ONGGI_NAME(VK_ERROR_OUT_OF_DEVICE_MEMORY);
        ONGGI_NAME(VK_ERROR_INITIALIZATION_FAILED);
        ONGGI_NAME(VK_ERROR_DEVICE_LOST);
        ONGGI_NAME(VK_ERROR_MEMORY_MAP_FAILED);
        ONGGI_NAME(VK_ERROR_LAYER_NOT_PRESENT);
        ONGGI_NAME(VK_ERROR_EXTENSION_NOT_PRESENT);
        ONGGI_NAME(VK_ERROR_FEATURE_NOT_PRESENT);
        ONGGI_NAME(VK_ERROR_INCOMPATIBLE_DRIVER);
        ONGGI_NAME(VK_ERROR_TOO_MANY_OBJECTS);
        ONGGI_NAME(VK_ERROR_FORMAT_NOT_SUPPORTED);
        ONGGI_NAME(VK_ERROR_UNKNOWN);
        ONGGI_NAME(VK_ERROR_SURFACE_LOST_KHR);
        ONGGI_NAME(VK_ERROR_NATIVE_WINDOW_IN_USE_KHR);
        ONGGI_NAME(VK_ERROR_OUT_OF_DATE_KHR);
#undef ONGGI_NAME
        default:
            return "another VkResult";
    }
}

Result<void> check(VkResult result, std::string_view call) {
    if (result == VK_SUCCESS) return {};
    // The name of the call, without its arguments.
    const std::string_view name = call.substr(0, call.find('('));
    std::string message = fmt::format("{}: expected VK_SUCCESS, found {} ({})", name, result_name(result),
                                      static_cast<int>(result));
    switch (result) {
        case VK_ERROR_OUT_OF_HOST_MEMORY:
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        case VK_ERROR_INITIALIZATION_FAILED:
        case VK_ERROR_DEVICE_LOST:
        case VK_ERROR_SURFACE_LOST_KHR:
        case VK_ERROR_LAYER_NOT_PRESENT:
        case VK_ERROR_EXTENSION_NOT_PRESENT:
        case VK_ERROR_FEATURE_NOT_PRESENT:
        case VK_ERROR_INCOMPATIBLE_DRIVER:
            return system_lacks(std::move(message));
        default:
            return failed(std::move(message));
    }
}

Result<SwapchainState> check_swapchain(VkResult result, std::string_view call) {
    if (result == VK_SUBOPTIMAL_KHR) return SwapchainState::kGood;
    if (result == VK_ERROR_OUT_OF_DATE_KHR) return SwapchainState::kOutOfDate;
    if (auto checked = check(result, call); !checked) return checked.error();
    return SwapchainState::kGood;
}

}  // namespace onggi::vk
