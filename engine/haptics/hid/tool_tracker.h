// From what a device says of the hand to where the tool is: the haptic thread's half of a HID device. Pure;
// no allocation, no clock: time is the sum of the ticks' steps. mm, s.
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

    // The tool after dt_s. While the input is not live - said so, or its heartbeat stands still - the tool
    // stays where it is and the button is up.
    [[nodiscard]] HandSample moved(const DeviceInput& input, double dt_s) noexcept;
    [[nodiscard]] bool input_is_live() const noexcept { return is_live_; }
    // About the last moved(): the place was refreshed since the one before; a beating heart alone is the I/O
    // thread's, not the device's.
    [[nodiscard]] bool was_refreshed() const noexcept { return was_refreshed_; }
    // About the last moved(): the person does something, a press of a button included, or a push that is held
    // still, until it is at rest.
    [[nodiscard]] bool hand_moves() const noexcept { return is_live_ && hand_moves_; }
    // About the last moved(): the person has changed something.
    [[nodiscard]] bool hand_lives() const noexcept { return is_live_ && hand_lives_; }
    [[nodiscard]] bool never_rests() const noexcept {
        return is_live_ && (push_.never_rests() || hold_.never_rests() || travel_.never_rests() ||
                            buttons_.never_rests());
    }
    // The tool was brought here; a hand that says how fast goes on from there.
    void put_at(const dvec3& position_mm) noexcept {
        place_mm_ = reach_.within({position_mm.x + press_mm_, position_mm.y});
    }

  private:
    void watch(const DeviceInput& input, double dt_s) noexcept;

    // Rounds of the I/O thread are some ms apart, writes included.
    static constexpr double kSilenceS = 0.05;
    // A stick that is plugged in somewhere inside the work draws the tool there at this speed, instead of
    // tearing it through at once. Faster than a hand works.
    static constexpr double kFastestMmS = 600.0;

    static constexpr double kUsualRevMin = 120.0;
    static constexpr double kSlowestRevMin = 20.0;
    static constexpr double kFastestRevMin = 240.0;
    // A held stick trembles by less, and a trigger at rest too.
    static constexpr double kNoiseMm = 1.5;
    static constexpr double kPushNoise = 0.05;  // the same of a stick that says how fast, of its travel

    ToolReach reach_;
    dvec2 place_mm_;  // radius, height, without the press
    double press_mm_ = 0.0;
    dvec2 travelled_mm_{0.0};  // of the input's sum, what is in place_mm_ already
    double rev_min_ = kUsualRevMin;
    std::uint64_t last_heartbeat_ = 0;
    std::uint64_t last_refreshed_ = 0;
    bool was_refreshed_ = false;
    double silence_s_ = 0.0;
    bool is_live_ = false;
    ControlSense push_{kPushNoise};
    ControlSense hold_{kNoiseMm};  // of the tool, and of the trigger that presses it
    ControlSense travel_{kNoiseMm};
    ControlSense buttons_{0.5};  // their bits as a number
    bool hand_moves_ = false;
    bool hand_lives_ = false;
};

}  // namespace onggi::haptics::hid
