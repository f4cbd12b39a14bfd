// A timeline semaphore and the value that the last submission will signal: the host waits for the one frame
// in flight with it. Main thread.
#pragma once

#include <cstdint>

#include "engine/core/result.h"
#include "engine/vk/pipeline.h"

namespace onggi::vk {

class Timeline {
  public:
    static Result<Timeline> create(const Device& device, std::string_view name);

    // Submits; wait() then waits for this submission. Either semaphore may be null.
    Result<void> submit(const Device& device, VkCommandBuffer commands, VkSemaphore wait_for,
                        VkSemaphore signal);
    // Waits until the device has finished all submissions.
    Result<void> wait(const Device& device) const;

  private:
    Semaphore semaphore_;
    std::uint64_t value_ = 0;
};

Result<Semaphore> create_semaphore(const Device& device, std::string_view name);

}  // namespace onggi::vk
