// The health of a device: whether it is lost, out of memory or without its surface, so that the owner can
// create another. Tests can inject faults. Main thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/vk/vulkan.h"

namespace onggi::vk {

enum class Trouble {
    kNone,
    kLost,         // the device is lost, and stays so until another is created
    kOutOfMemory,  // of the host or of the device
    kSurfaceLost,  // of the window; the device is usable
};

// An injected fault. The first `after` calls with this name succeed; the next call is not made and returns
// `result`. If that loses the device, all later calls with this name fail too, as on a real lost device.
struct Fault {
    std::string call;  // "vkQueueSubmit2"
    VkResult result = VK_ERROR_DEVICE_LOST;
    int after = 0;
};

class Health {
  public:
    [[nodiscard]] Trouble trouble() const { return trouble_; }
    void inject(Fault fault) { fault_ = std::move(fault); }

    // Call these around every Vulkan call that may fail. before() returns the injected fault's result, or
    // VK_SUCCESS. note() records the call's result. `call` is the call's source text, compared by its name.
    [[nodiscard]] VkResult before(std::string_view call);
    void note(VkResult result);

  private:
    Trouble trouble_ = Trouble::kNone;
    std::optional<Fault> fault_;
};

}  // namespace onggi::vk

// In a function that returns a Result: makes the call for a device, and returns its error.
#define ONGGI_VK_TRY_ON(device, call)                                                     \
    do {                                                                                  \
        VkResult onggi_result = (device).health().before(#call);                          \
        if (onggi_result == VK_SUCCESS) onggi_result = (call);                            \
        (device).health().note(onggi_result);                                             \
        if (auto onggi_checked = ::onggi::vk::check(onggi_result, #call); !onggi_checked) \
            return onggi_checked.error();                                                 \
    } while (false)
