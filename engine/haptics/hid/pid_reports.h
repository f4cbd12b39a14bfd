// Builds the output reports of a force-feedback joystick. Pure; any thread; one report per call, no
// allocation. A report that the device lacks is empty and must not be sent. Source: PID 1.0 (pid_layout.h).
// Values are fractions of full scale, converted to the field's declared range.
#pragma once

#include <optional>

#include "engine/haptics/hid/hid_port.h"
#include "engine/haptics/hid/pid_layout.h"

namespace onggi::haptics::hid {

constexpr std::int64_t kLoopForever = 255;  // "infinite" in an 8-bit loop count; clamped to the field's range

// The common part of every effect.
struct PidEffect {
    std::uint8_t block = 0;  // from Block Load
    PidUsage type = PidUsage::kConstantForceType;
    int duration_ms = 0;
    double gain = 1.0;       // fraction of full
    bool acts_on_x = false;  // for a device without a direction
    bool acts_on_y = false;
    // Where a positive force comes from, in turns clockwise from north, as for a wind: 0.25 is east, and the
    // stick is pushed west, to -X; 0.5 is south, the hand's side. So say DirectInput's "Effect Direction" and
    // SDL's SDL_HapticDirection, and so compute OpenFFBoard and ArduinoJoystickWithFFBLibrary.
    double direction_turns = 0.0;
};

// One axis of a spring, damper or friction; forces and positions are fractions of full scale. Force =
// -clip(coefficient (place - centre -+ dead band)), the coefficient and saturation of the side on which the
// stick is; places from -1 to 1.
struct PidCondition {
    double centre = 0.0;                // -1 to 1
    double positive_coefficient = 0.0;  // -1 to 1, beyond the centre
    double negative_coefficient = 0.0;  // -1 to 1, before it
    double saturation = 1.0;            // 0 to 1
};

[[nodiscard]] Report create_effect(const PidLayout& layout, PidUsage type) noexcept;
[[nodiscard]] Report block_load_request(const PidLayout& layout) noexcept;
[[nodiscard]] Report set_effect(const PidLayout& layout, const PidEffect& effect) noexcept;
// Empty for Y if the device has one condition for both axes.
[[nodiscard]] Report set_condition(const PidLayout& layout, std::uint8_t block, Axis axis,
                                   const PidCondition& condition) noexcept;
// magnitude: -1 to 1 of full scale.
[[nodiscard]] Report set_constant_force(const PidLayout& layout, std::uint8_t block,
                                        double magnitude) noexcept;
// operation: kStart or kStop.
[[nodiscard]] Report effect_operation(const PidLayout& layout, std::uint8_t block, PidUsage operation,
                                      std::int64_t loops) noexcept;
[[nodiscard]] Report block_free(const PidLayout& layout, std::uint8_t block) noexcept;
// control: kEnableActuators, kDisableActuators, kStopAll or kReset; an array or one bit each, depending on
// the device.
[[nodiscard]] Report device_control(const PidLayout& layout, PidUsage control) noexcept;
[[nodiscard]] Report device_gain(const PidLayout& layout, double fraction) noexcept;

struct BlockLoad {
    enum class Status : std::uint8_t { kOk, kFull, kError, kUnknown };
    std::uint8_t block = 0;
    Status status = Status::kUnknown;  // unknown: not ready yet, ask again
};
// Empty: the answer is too short or another report.
[[nodiscard]] std::optional<BlockLoad> block_load(const PidLayout& layout,
                                                  std::span<const std::uint8_t> report) noexcept;

}  // namespace onggi::haptics::hid
