// When the device got to which place in a command buffer. Main thread.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/device.h"
#include "engine/vk/pipeline.h"

namespace onggi::vk {

// Ticks from one timestamp to a later one, of which only so many low bits count: the clock may have begun
// anew in between.
[[nodiscard]] std::uint64_t ticks_between(std::uint64_t earlier, std::uint64_t later,
                                          std::uint32_t valid_bits);

class Timestamps {
  public:
    // Room for so many marks. Works, and measures nothing, on a device that has no clock for its queue.
    static Result<Timestamps> create(const Device& device, std::uint32_t capacity, std::string_view name);

    // Before the first mark, outside of rendering.
    void begin(VkCommandBuffer commands);
    // Now: once all that was recorded before is done. What goes beyond the capacity is not noted.
    void mark(VkCommandBuffer commands);
    [[nodiscard]] std::uint32_t marks() const { return marks_; }

    // Milliseconds of each mark after the first. Only after the submission has left the device; empty where
    // nothing was measured.
    [[nodiscard]] const std::vector<double>& read(const Device& device);

  private:
    Unique<VkQueryPool, vkDestroyQueryPool> pool_;
    std::uint32_t capacity_ = 0;
    std::uint32_t marks_ = 0;
    std::uint32_t valid_bits_ = 64;
    double ms_a_tick_ = 0.0;
    std::vector<std::uint64_t> ticks_;
    std::vector<double> ms_;
};

}  // namespace onggi::vk
