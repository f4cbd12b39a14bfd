// VkResult turned into Result, by what the call means. Any thread.
#pragma once

#include <string_view>

#include "engine/core/result.h"
#include "engine/vk/vulkan.h"

namespace onggi::vk {

// The name the specification gives it, as "VK_ERROR_DEVICE_LOST".
[[nodiscard]] std::string_view result_name(VkResult result);

// A call that succeeds or fails. Out of memory and a lost device are lacks of the system.
[[nodiscard]] Result<void> check(VkResult result, std::string_view call);

// A swapchain call: suboptimal is success, out of date is neither success nor failure.
enum class SwapchainState { kGood, kOutOfDate };
[[nodiscard]] Result<SwapchainState> check_swapchain(VkResult result, std::string_view call);

}  // namespace onggi::vk

// In a function that returns a Result: leave with the error of a failed call.
#define ONGGI_VK_TRY(call)                                                          \
    do {                                                                            \
        if (auto onggi_checked = ::onggi::vk::check((call), #call); !onggi_checked) \
            return onggi_checked.error();                                           \
    } while (false)
