// Drivers of the devices without force: SpaceMouse and foot pedal. I/O thread. Never tried on hardware by
// this project.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/haptics/hid/device_input.h"
#include "engine/haptics/hid/hid_driver.h"
#include "engine/haptics/hid/hid_port.h"

namespace onggi::haptics::hid {

// VEC Infinity foot pedal (05f3:00ff): three pedals, no force. Pure; any thread. Source: reports as captured
// in public (fenimore/scribouillage).
struct VecPedalState {
    bool left = false;
    bool middle = false;
    bool right = false;

    [[nodiscard]] bool any() const noexcept { return left || middle || right; }
};

// The report has no id: 2 bytes, byte 0 the pedals in bits 0 to 2, byte 1 zero. Empty for any other report.
[[nodiscard]] inline std::optional<VecPedalState> vec_pedal_state(
    std::span<const std::uint8_t> report) noexcept {
    if (report.size() != 2 || (report[0] & 0xf8U) != 0 || report[1] != 0) return std::nullopt;
    return VecPedalState{
        .left = (report[0] & 1U) != 0, .middle = (report[0] & 2U) != 0, .right = (report[0] & 4U) != 0};
}

// 3Dconnexion SpaceMouse: six axes at rest in the middle, buttons, one lamp; no force. Decoding and mapping,
// pure; one thread at a time. Source: the two report layouts as captured in public from a SpaceNavigator
// (046d:c626), a SpaceMouse Compact (256f:c635) and, by its descriptor only, a SpaceMouse Wireless
// (AndunHH/spacemouse; CloudCompare pull request 2339).

// The device's own axes: X right, Y towards the user, Z down; each about -350 to 350, some a little beyond.
struct SpaceMouseState {
    std::array<std::int16_t, 3> translation{};  // X, Y, Z
    std::array<std::int16_t, 3> rotation{};     // Rx, Ry, Rz
    std::uint32_t buttons = 0;                  // bit 0 is button 1
    int battery_percent = -1;                   // -1: not reported

    [[nodiscard]] bool at_rest() const noexcept {
        return translation == std::array<std::int16_t, 3>{} && rotation == std::array<std::int16_t, 3>{};
    }
};

// Updates the state from one report. The length of report 1, not the model, says whether it includes the
// rotation. Returns false for any other report; the state is unchanged.
//   id 1, 7 bytes: X Y Z;  id 2, 7 bytes: Rx Ry Rz;  id 1, 13 bytes: X Y Z Rx Ry Rz; all int16, low byte
//   first id 3, 2 to 5 bytes and more: buttons from byte 1, bit 0;  id 0x17, 3 bytes: byte 1 the battery in
//   percent
bool take_space_mouse_report(std::span<const std::uint8_t> report, SpaceMouseState& state) noexcept;

// Host to device: 04 01 lamp on, 04 00 off.
[[nodiscard]] Report space_mouse_lamp(bool on) noexcept;

// Rate control: push sideways to move the tool out and in, down to lower it.
struct SpaceMouseMapping {
    double full_scale = 350.0;  // of the descriptor's logical range; larger values are clamped
    double dead_band = 15.0;
    double fastest_mm_s = 150.0;
    double fastest_change_rev_min_s = 80.0;  // of the wheel, at full twist
};

// Maps an axis to -1 to 1: zero within the dead band, then even, as the hand pushes.
[[nodiscard]] double pushed_axis(std::int16_t value, const SpaceMouseMapping& mapping) noexcept;
// The same, cubic, so that a light push moves finely.
[[nodiscard]] double shaped_axis(std::int16_t value, const SpaceMouseMapping& mapping) noexcept;
// Radius and height, mm/s: X right is outwards, Z down is down.
[[nodiscard]] dvec2 space_mouse_rate_mm_s(const SpaceMouseState& state,
                                          const SpaceMouseMapping& mapping) noexcept;

// Push to move the tool (rate control); button 1 starts and stops the wheel, a twist changes its speed; the
// lamp is on while the device is in use.
class SpaceMouseDriver final : public HidDriver {
  public:
    explicit SpaceMouseDriver(const SpaceMouseMapping& mapping = {}) : mapping_(mapping) {}

    [[nodiscard]] DeviceCapabilities capabilities() const override;
    Result<void> start(const HidDeviceInfo& device, HidPort& port) override;
    void take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept override;
    [[nodiscard]] DeviceInput input(std::int64_t now_ns) const noexcept override;
    // A stick that leans reports all the time, and no motion.
    [[nodiscard]] bool has_moved(std::span<const std::uint8_t> before,
                                 std::span<const std::uint8_t> now) const noexcept override;
    Result<void> send(HidPort&, const ForceOrder&, std::int64_t) override { return {}; }
    void stop(HidPort& port) noexcept override;

  private:
    SpaceMouseMapping mapping_;
    SpaceMouseState state_;
    bool wheel_turns_ = false;
    std::int64_t heard_ns_ = 0;
};

// Any pedal turns the wheel; the right one speeds it up while pressed, the left one slows it down.
class VecPedalDriver final : public HidDriver {
  public:
    [[nodiscard]] DeviceCapabilities capabilities() const override;
    Result<void> start(const HidDeviceInfo& device, HidPort& port) override;
    void take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept override;
    [[nodiscard]] DeviceInput input(std::int64_t now_ns) const noexcept override;
    Result<void> send(HidPort&, const ForceOrder&, std::int64_t) override { return {}; }
    void stop(HidPort&) noexcept override {}

  private:
    VecPedalState state_;
};

}  // namespace onggi::haptics::hid
