// The output reports and fields of a force-feedback joystick (USB Physical Interface Device class), found by
// their usages, not by report numbers, which differ between makers. Pure; any thread. Source: "Device Class
// Definition for Physical Interface Devices" 1.0 (USB Implementers' Forum), usage page 0x0F; the usages are
// those that Linux's hid-pidff reads. Several firmwares leave fields out: only the fields that a force needs
// are required.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "engine/core/result.h"
#include "engine/haptics/hid/report_descriptor.h"
#include "engine/math/math.h"

namespace onggi::haptics::hid {

// Usages of page 0x0F: the reports, fields and choices that are used here.
enum class PidUsage : std::uint16_t {
    kSetEffect = 0x21,
    kBlockIndex = 0x22,
    kParameterBlockOffset = 0x23,
    kConstantForceType = 0x26,
    kSpringType = 0x40,
    kDamperType = 0x41,
    kFrictionType = 0x43,
    kDuration = 0x50,
    kGain = 0x52,
    kAxesEnable = 0x55,
    kDirectionEnable = 0x56,
    kDirection = 0x57,
    kSetCondition = 0x5f,
    kCentre = 0x60,
    kPositiveCoefficient = 0x61,
    kNegativeCoefficient = 0x62,
    kPositiveSaturation = 0x63,
    kNegativeSaturation = 0x64,
    kDeadBand = 0x65,
    kMagnitude = 0x70,
    kSetConstantForce = 0x73,
    kEffectOperation = 0x77,
    kStart = 0x79,
    kStop = 0x7b,
    kLoopCount = 0x7c,
    kDeviceGainReport = 0x7d,
    kDeviceGain = 0x7e,
    kBlockLoad = 0x89,
    kLoadOk = 0x8c,
    kLoadFull = 0x8d,
    kLoadError = 0x8e,
    kBlockFree = 0x90,
    kState = 0x92,
    kDeviceControlReport = 0x95,
    kDeviceControlList = 0x96,
    kEnableActuators = 0x97,
    kDisableActuators = 0x98,
    kStopAll = 0x99,
    kReset = 0x9a,
    kActuatorsEnabled = 0xa0,
    kSafetySwitch = 0xa4,
    kCreateEffect = 0xab,
};
constexpr Usage usage(PidUsage id) {
    return usage(0x0f, static_cast<std::uint16_t>(id));
}

// Usages of the page Generic Desktop.
constexpr Usage kUsageX = usage(0x01, 0x30);
constexpr Usage kUsageY = usage(0x01, 0x31);
constexpr Usage kUsageZ = usage(0x01, 0x32);

enum class Axis : std::uint8_t { kX, kY };
constexpr std::array<Axis, 2> kBothAxes{Axis::kX, Axis::kY};

// One report of the device: its number and its length with the id byte. bytes 0: the device has none.
struct ReportPlace {
    std::uint8_t id = 0;
    std::size_t bytes = 0;

    explicit operator bool() const noexcept { return bytes != 0; }
};

class PidLayout {
  public:
    // Error: bad input, naming the missing or unusable field, for a joystick without force feedback or of an
    // unknown kind. Reports are at most 64 bytes long.
    static Result<PidLayout> find(ReportDescriptor descriptor);

    [[nodiscard]] bool has_effect(PidUsage type) const noexcept;
    // The element of a report with the usage `wanted`; empty if the device lacks it.
    [[nodiscard]] Element element(PidUsage report, Usage wanted) const noexcept;
    [[nodiscard]] ReportPlace place(PidUsage report) const noexcept;
    [[nodiscard]] Element axis(Axis axis) const noexcept;  // input: the stick's position
    [[nodiscard]] const ReportDescriptor& descriptor() const noexcept { return descriptor_; }

  private:
    explicit PidLayout(ReportDescriptor descriptor) : descriptor_(std::move(descriptor)) {}
    static ReportKind kind_of(PidUsage report) noexcept;
    [[nodiscard]] Usage collection_of(PidUsage report) const noexcept;

    ReportDescriptor descriptor_;
    // Several firmwares have only the list, without the report around it; Linux's hid-pidff accepts that too.
    PidUsage device_control_ = PidUsage::kDeviceControlReport;
};

// The stick's state from its reports: -1 to 1, X to the right, Y towards the hand, as in the HID usage
// tables; buttons from bit 0.
struct StickState {
    dvec2 deflection{0.0};
    std::uint32_t buttons = 0;
};
// Takes an input report. Returns false, with the state unchanged, if it does not contain the axes.
bool take_stick_report(const PidLayout& layout, std::span<const std::uint8_t> report,
                       StickState& state) noexcept;

// The device's status from a PID State report; empty for any other report.
struct PidDeviceState {
    bool actuators_enabled = true;  // assumed on if the device does not say
    bool safety_switch_on = true;   // false: the emergency stop is pressed
};
[[nodiscard]] std::optional<PidDeviceState> pid_device_state(const PidLayout& layout,
                                                             std::span<const std::uint8_t> report) noexcept;

}  // namespace onggi::haptics::hid
