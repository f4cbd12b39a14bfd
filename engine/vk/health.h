// What has become of a device: whether it is lost, out of memory or without its surface, so that whoever owns
// it can make another; and failures on purpose, so that tests can see it done. Main thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/vk/vulkan.h"

namespace onggi::vk {

enum class Trouble {
    kNone,
    kLost,         // the device; it stays lost until another is made
    kOutOfMemory,  // the host's or the device's
    kSurfaceLost,  // the window's; the device is well
};

// A failure on purpose: after so many calls of this name have been let through, the next is not made and
// gives this result instead. One that loses the device makes every later call fail alike, as a lost device
// does.
struct Fault {
    std::string call;  // "vkQueueSubmit2"
    VkResult result = VK_ERROR_DEVICE_LOST;
    int after = 0;
};

class Health {
  public:
    [[nodiscard]] Trouble trouble() const { return trouble_; }
    void inject(Fault fault) { fault_ = std::move(fault); }

    // Around every call that may find trouble: what a fault wants of it, else VK_SUCCESS; and what came of
    // it. `call` is the source text of the call, of which the name counts.
    [[nodiscard]] VkResult before(std::string_view call);
    void note(VkResult result);

  private:
    Trouble trouble_ = Trouble::kNone;
    std::optional<Fault> fault_;
};

}  // namespace onggi::vk

// In a function that returns a Result: makes the call on behalf of a device, and leaves with its error.
#define ONGGI_VK_TRY_ON(device, call)                                                     \
    do {                                                                                  \
        VkResult onggi_result = (device).health().before(#call);                          \
        if (onggi_result == VK_SUCCESS) onggi_result = (call);                            \
        (device).health().note(onggi_result);                                             \
        if (auto onggi_checked = ::onggi::vk::check(onggi_result, #call); !onggi_checked) \
            return onggi_checked.error();                                                 \
    } while (false)
