// Converts VkResult to Result, according to the kind of call. Any thread.
#pragma once

#include <string_view>

#include "engine/core/result.h"
#include "engine/vk/vulkan.h"

namespace onggi::vk {

// Returns the name in the specification, such as "VK_ERROR_DEVICE_LOST".
[[nodiscard]] std::string_view result_name(VkResult result);

// For calls that succeed or fail. Out of memory and a lost device are system lacks.
[[nodiscard]] Result<void> check(VkResult result, std::string_view call);

// For swapchain calls: suboptimal counts as success; out of date is a state of its own, not an error.
enum class SwapchainState { kGood, kOutOfDate };
[[nodiscard]] Result<SwapchainState> check_swapchain(VkResult result, std::string_view call);

}  // namespace onggi::vk

// In a function that returns a Result: returns the error of a failed call.
#define ONGGI_VK_TRY(call)                                                          \
    do {                                                                            \
        if (auto onggi_checked = ::onggi::vk::check((call), #call); !onggi_checked) \
            return onggi_checked.error();                                           \
    } while (false)
