#include "engine/haptics/hid/dual_sense.h"

#include <algorithm>

#include "engine/core/little_endian.h"

namespace onggi::haptics::hid {
namespace {

constexpr std::uint8_t kInputReport = 0x01;
constexpr std::size_t kInputBytes = 64;
constexpr std::uint8_t kOutputReport = 0x02;
constexpr std::size_t kOutputBytes = 48;

// Over Bluetooth: the id, one extra byte (two in an output report), the bytes of the USB report, and the
// checksum.
constexpr std::uint8_t kRadioReport = 0x31;
constexpr std::size_t kRadioBytes = 78;
constexpr std::size_t kRadioChecksum = 74;
constexpr std::uint8_t kRadioTag = 0x10;
static_assert(kRadioBytes <= kMaxReportBytes);

constexpr std::uint8_t kOff = 0x05;
constexpr std::uint8_t kFeedback = 0x21;

// The positions in the output report, and the bits that mark them as valid.
constexpr std::size_t kValid0 = 1;
constexpr std::size_t kValid1 = 2;
constexpr std::size_t kWeakMotor = 3;
constexpr std::size_t kStrongMotor = 4;
constexpr std::size_t kRightTrigger = 11;
constexpr std::size_t kLeftTrigger = 22;
constexpr std::size_t kValid2 = 39;
constexpr std::size_t kLightSetUp = 42;
constexpr std::size_t kRed = 45;
constexpr std::uint8_t kRumbleValid = 0x03;  // bit 0: plain rumble; bit 1: not the audio haptics
constexpr std::uint8_t kRightTriggerValid = 0x04;
constexpr std::uint8_t kLeftTriggerValid = 0x08;
constexpr std::uint8_t kLightValid = 0x04;
constexpr std::uint8_t kLightSetUpValid = 0x02;
constexpr std::uint8_t kReleaseLight = 0x02;

DualSenseTouch touch_at(std::span<const std::uint8_t> report, std::size_t at) noexcept {
    return {.touching = (report[at] & 0x80U) == 0,
            .id = static_cast<std::uint8_t>(report[at] & 0x7fU),
            .x = static_cast<std::uint16_t>(report[at + 1] | ((report[at + 2] & 0x0fU) << 8U)),
            .y = static_cast<std::uint16_t>((report[at + 2] >> 4U) | (report[at + 3] << 4U))};
}

// One bit for each used zone, low byte first, then three bits for each zone: its strength minus one.
TriggerEffect by_zone(std::uint8_t mode, const std::array<std::uint8_t, kTriggerZones>& strengths) noexcept {
    std::uint32_t zones = 0;
    std::uint32_t levels = 0;
    for (std::uint32_t zone = 0; zone < kTriggerZones; ++zone) {
        const std::uint32_t strength = std::min(strengths[zone], kStrongestZone);
        if (strength == 0) continue;
        zones |= 1U << zone;
        levels |= (strength - 1U) << (3U * zone);
    }
    if (zones == 0) return trigger_off();
    TriggerEffect effect;
    effect.bytes = {mode,
                    static_cast<std::uint8_t>(zones),
                    static_cast<std::uint8_t>(zones >> 8U),
                    static_cast<std::uint8_t>(levels),
                    static_cast<std::uint8_t>(levels >> 8U),
                    static_cast<std::uint8_t>(levels >> 16U),
                    static_cast<std::uint8_t>(levels >> 24U)};
    return effect;
}

}  // namespace

std::uint32_t radio_checksum(std::uint8_t seed, std::span<const std::uint8_t> bytes) noexcept {
    std::uint32_t rest = 0xffffffffU;
    const auto take = [&](std::uint8_t byte) {
        rest ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            rest = (rest >> 1U) ^ ((rest & 1U) != 0 ? 0xedb88320U : 0U);
    };
    take(seed);
    for (const std::uint8_t byte : bytes)
        take(byte);
    return ~rest;
}

std::optional<DualSenseState> dual_sense_state(std::span<const std::uint8_t> report) noexcept {
    if (report.size() >= kRadioBytes && report[0] == kRadioReport) {
        const bool is_whole = radio_checksum(kInputSeed, report.first(kRadioChecksum)) ==
                              little_endian::get<std::uint32_t>(report, kRadioChecksum);
        if (!is_whole) return std::nullopt;
        report = report.subspan(1);
    } else if (report.size() < kInputBytes || report[0] != kInputReport) {
        return std::nullopt;
    }
    DualSenseState state;
    state.left_stick = {report[1], report[2]};
    state.right_stick = {report[3], report[4]};
    state.left_trigger = report[5];
    state.right_trigger = report[6];
    state.hat = std::min<std::uint8_t>(report[8] & 0x0fU, DualSenseState::kNoHat);
    state.buttons =
        (report[8] & 0xf0U) | (std::uint32_t{report[9]} << 8U) | (std::uint32_t{report[10]} << 16U);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        state.gyro[axis] = little_endian::get<std::int16_t>(report, 16 + 2 * axis);
        state.accel[axis] = little_endian::get<std::int16_t>(report, 22 + 2 * axis);
    }
    state.sensor_time = little_endian::get<std::uint32_t>(report, 28);
    state.touches = {touch_at(report, 33), touch_at(report, 37)};
    state.right_trigger_zone = report[42] & 0x0fU;
    state.left_trigger_zone = report[43] & 0x0fU;
    state.right_trigger_loaded = (report[42] >> 4U) == 1;
    state.left_trigger_loaded = (report[43] >> 4U) == 1;
    state.right_effect = report[48] & 0x0fU;
    state.left_effect = report[48] >> 4U;
    state.battery_percent = std::min(report[53] & 0x0f, 10) * 10;
    state.charging = report[53] >> 4U;
    return state;
}

TriggerEffect trigger_off() noexcept {
    TriggerEffect effect;
    effect.bytes[0] = kOff;
    return effect;
}

TriggerEffect trigger_resistance(const std::array<std::uint8_t, kTriggerZones>& strengths) noexcept {
    return by_zone(kFeedback, strengths);
}

Report dual_sense_report(const DualSenseOrders& orders) noexcept {
    Report report;
    report.size = kOutputBytes;
    report.bytes[0] = kOutputReport;
    const auto mark = [&](std::size_t valid, std::uint8_t bits) {
        report.bytes[valid] = static_cast<std::uint8_t>(report.bytes[valid] | bits);
    };
    const auto put = [&](std::size_t at, const auto& bytes) {
        std::copy(bytes.begin(), bytes.end(), report.bytes.begin() + static_cast<std::ptrdiff_t>(at));
    };
    if (orders.rumble) {
        mark(kValid0, kRumbleValid);
        report.bytes[kWeakMotor] = orders.rumble->weak;
        report.bytes[kStrongMotor] = orders.rumble->strong;
    }
    if (orders.right_trigger) {
        mark(kValid0, kRightTriggerValid);
        put(kRightTrigger, orders.right_trigger->bytes);
    }
    if (orders.left_trigger) {
        mark(kValid0, kLeftTriggerValid);
        put(kLeftTrigger, orders.left_trigger->bytes);
    }
    if (orders.light) {
        mark(kValid1, kLightValid);
        put(kRed, *orders.light);
    }
    if (orders.end_start_up_light) {
        mark(kValid2, kLightSetUpValid);
        report.bytes[kLightSetUp] = kReleaseLight;
    }
    return report;
}

Report by_radio(const Report& over_usb, unsigned sequence) noexcept {
    Report report;
    report.size = kRadioBytes;
    report.bytes[0] = kRadioReport;
    report.bytes[1] = static_cast<std::uint8_t>((sequence & 0x0fU) << 4U);
    report.bytes[2] = kRadioTag;
    std::copy_n(over_usb.bytes.begin() + 1, kOutputBytes - 1, report.bytes.begin() + 3);
    const std::uint32_t checksum = radio_checksum(kOutputSeed, std::span(report.bytes).first(kRadioChecksum));
    for (unsigned byte = 0; byte < 4; ++byte)
        report.bytes[kRadioChecksum + byte] = static_cast<std::uint8_t>(checksum >> (8U * byte));
    return report;
}

}  // namespace onggi::haptics::hid
