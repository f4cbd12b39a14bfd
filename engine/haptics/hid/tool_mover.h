// From what a device says of the hand to where the tool is: the haptic thread's half of a HID device. Pure;
// no allocation, no clock: time is the sum of the ticks' steps. mm, s.
#pragma once

#include <cstdint>

#include "engine/haptics/hid/hand_input.h"
#include "engine/haptics/tool_state.h"

namespace onggi::haptics::hid {

class ToolMover {
  public:
    explicit ToolMover(const ToolReach& reach = {})
        : reach_(reach),
          place_mm_(reach.within({reach.start_radius_mm, reach.start_height_mm})) {}

    // The tool after dt_s. While the input is not live - said so, or its heartbeat stands still - the tool
    // stays where it is and the wheel's button is up.
    [[nodiscard]] ToolState moved(const HandInput& input, double dt_s) noexcept;
    [[nodiscard]] bool input_is_live() const noexcept { return is_live_; }

  private:
    // Rounds of the I/O thread are some ms apart, writes included.
    static constexpr double kSilenceS = 0.05;
    // A stick that is plugged in somewhere inside the clay draws the tool there at this speed, instead of
    // tearing it through at once. Faster than a hand works.
    static constexpr double kFastestMmS = 600.0;

    ToolReach reach_;
    dvec2 place_mm_;  // radius, height, without the press
    double press_mm_ = 0.0;
    std::uint64_t last_heartbeat_ = 0;
    double silence_s_ = 0.0;
    bool is_live_ = false;
};

}  // namespace onggi::haptics::hid
