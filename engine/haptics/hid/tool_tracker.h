// Converts a device's hand input to a tool position: the haptic thread's half of a HID device. Pure; no
// allocation and no clock (time is the sum of the ticks' steps). mm, s.
#pragma once

#include <cstdint>

#include "engine/haptics/control_sense.h"
#include "engine/haptics/hand_sample.h"
#include "engine/haptics/haptic_device.h"
#include "engine/haptics/hid/device_input.h"

namespace onggi::haptics::hid {

class ToolTracker {
  public:
    explicit ToolTracker(const ToolReach& reach = {})
        : reach_(reach),
          place_mm_(reach.within({reach.start_radius_mm, reach.start_height_mm})) {}

    // The tool after dt_s. While the input is not live, because it is marked so or its heartbeat stands
    // still, the tool stays where it is and the button is up.
    [[nodiscard]] HandSample moved(const DeviceInput& input, double dt_s) noexcept;
    [[nodiscard]] bool input_is_live() const noexcept { return is_live_; }
    // Whether the device refreshed the position between the last two calls of moved(); the heartbeat alone
    // only shows that the I/O thread runs.
    [[nodiscard]] bool was_refreshed() const noexcept { return was_refreshed_; }
    // Whether the hand moved or pressed a button in the last moved(), or holds a push that is not yet at
    // rest.
    [[nodiscard]] bool hand_moves() const noexcept { return is_live_ && hand_moves_; }
    // Whether the person changed a control in the last moved().
    [[nodiscard]] bool hand_lives() const noexcept { return is_live_ && hand_lives_; }
    [[nodiscard]] bool never_rests() const noexcept {
        return is_live_ && (push_.never_rests() || hold_.never_rests() || travel_.never_rests() ||
                            buttons_.never_rests());
    }
    // Another hand has moved the tool here; rate control continues from there.
    void put_at(const dvec3& position_mm) noexcept {
        place_mm_ = reach_.within({position_mm.x + press_mm_, position_mm.y});
    }

  private:
    void watch(const DeviceInput& input, double dt_s) noexcept;

    // Rounds of the I/O thread are some ms apart, writes included.
    static constexpr double kSilenceS = 0.05;
    // When a stick is plugged in while deflected, the tool moves to its position at this speed instead of
    // jumping through the work. Faster than a hand works.
    static constexpr double kFastestMmS = 600.0;

    static constexpr double kUsualRevMin = 120.0;
    static constexpr double kSlowestRevMin = 20.0;
    static constexpr double kFastestRevMin = 240.0;
    // More than the noise of a held stick or of a trigger at rest.
    static constexpr double kNoiseMm = 1.5;

    ToolReach reach_;
    dvec2 place_mm_;  // radius, height, without the press
    double press_mm_ = 0.0;
    dvec2 travelled_mm_{0.0};  // the part of the input's sum already added to place_mm_
    double rev_min_ = kUsualRevMin;
    std::uint64_t last_heartbeat_ = 0;
    std::uint64_t last_refreshed_ = 0;
    bool was_refreshed_ = false;
    double silence_s_ = 0.0;
    bool is_live_ = false;
    ControlSense push_{kPushNoise};
    ControlSense hold_{kNoiseMm};  // the tool, and the trigger that presses it
    ControlSense travel_{kNoiseMm};
    ControlSense buttons_{0.5};  // the bits as a number
    bool hand_moves_ = false;
    bool hand_lives_ = false;
};

}  // namespace onggi::haptics::hid
