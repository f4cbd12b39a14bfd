// Measures when the device reaches marks in a command buffer. Main thread.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/device.h"
#include "engine/vk/pipeline.h"

namespace onggi::vk {

// Returns the ticks between two timestamps, of which only the low `valid_bits` count; handles one wraparound.
[[nodiscard]] std::uint64_t ticks_between(std::uint64_t earlier, std::uint64_t later,
                                          std::uint32_t valid_bits);

class Timestamps {
  public:
    // `capacity`: maximum number of marks. On a device whose queue has no clock it works, but measures
    // nothing.
    static Result<Timestamps> create(const Device& device, std::uint32_t capacity, std::string_view name);

    // Call before the first mark, outside of rendering.
    void begin(VkCommandBuffer commands);
    // Records a timestamp after all earlier commands. Marks beyond the capacity are ignored.
    void mark(VkCommandBuffer commands);
    [[nodiscard]] std::uint32_t marks() const { return marks_; }

    // Returns the time of each mark in ms, relative to the first mark. Call after the device has finished the
    // submission. Empty if nothing was measured.
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
