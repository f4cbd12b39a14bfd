// A window's picture in memory that the window system reads: what a software device draws there is shown
// without being sent. Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/core/result.h"
#include "engine/vk/vulkan.h"

namespace onggi::vk {

class HostSurface {
  public:
    virtual ~HostSurface() = default;

    // Lends memory for pictures: whole pages, zero at first, in place of what was lent before. Errors: no
    // memory, or the window system does not take it.
    virtual Result<std::span<std::byte>> lend(std::size_t bytes) = 0;
    // Blocks until the window system has read the picture of the last show(): only then may the memory
    // change. Error: the connection has ended.
    virtual Result<void> wait_until_read() = 0;
    // Shows the lent memory in the window: pixels of blue, green, red and an unused byte, rows of row_px
    // pixels. `changed` are the parts that differ from the last picture; the window system may read less than
    // the whole. Precondition: the last picture has been read.
    virtual void show(VkExtent2D size, std::uint32_t row_px, std::span<const VkRect2D> changed) = 0;
};

}  // namespace onggi::vk
