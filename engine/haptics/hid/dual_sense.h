// Sony DualSense (054c:0ce6) and DualSense Edge (054c:0df2) over USB and Bluetooth: its input and output
// reports. Pure; any thread; no allocation. Over Bluetooth the same bytes come one later, in longer reports
// with a checksum; a report with a wrong checksum is rejected. Source: public byte tables (SDL's and Linux's
// drivers, dualsensectl, nondebug/dualsense, Nielk1's trigger effects). Never tried on hardware by this
// project.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/haptics/hid/hid_port.h"

namespace onggi::haptics::hid {

struct DualSenseTouch {
    bool touching = false;
    std::uint8_t id = 0;  // changes with each new touch
    std::uint16_t x = 0;  // 0 to 1919, left to right
    std::uint16_t y = 0;  // 0 to 1079, top to bottom
};

struct DualSenseState {
    enum Button : std::uint32_t {  // bytes 8 (upper half), 9 and 10 of the report
        kSquare = 1U << 4U,
        kCross = 1U << 5U,
        kCircle = 1U << 6U,
        kTriangle = 1U << 7U,
        kL1 = 1U << 8U,
        kR1 = 1U << 9U,
        kL2 = 1U << 10U,
        kR2 = 1U << 11U,
        kCreate = 1U << 12U,
        kOptions = 1U << 13U,
        kL3 = 1U << 14U,
        kR3 = 1U << 15U,
        kPs = 1U << 16U,
        kTouchpad = 1U << 17U,
        kMute = 1U << 18U,
        kLeftPaddle = 1U << 22U,   // Edge
        kRightPaddle = 1U << 23U,  // Edge
    };
    static constexpr std::uint8_t kNoHat = 8;

    std::array<std::uint8_t, 2> left_stick{0x80, 0x80};  // X, Y: 0 to 255, right and down are large
    std::array<std::uint8_t, 2> right_stick{0x80, 0x80};
    std::uint8_t left_trigger = 0;  // 0 to 255, pulled
    std::uint8_t right_trigger = 0;
    std::uint8_t hat = kNoHat;  // 0 to 7 clockwise from up
    std::uint32_t buttons = 0;
    std::array<std::int16_t, 3> gyro{};   // pitch, yaw, roll; about 1/16 degree/s a step, uncalibrated
    std::array<std::int16_t, 3> accel{};  // 8192 per g
    std::uint32_t sensor_time = 0;        // steps of 1/3 us
    std::array<DualSenseTouch, 2> touches{};
    // The zone of ten that each trigger is in, and whether it meets its resistance now.
    std::uint8_t right_trigger_zone = 0;
    std::uint8_t left_trigger_zone = 0;
    bool right_trigger_loaded = false;
    bool left_trigger_loaded = false;
    std::uint8_t right_effect = 0;  // effect that the pad runs: 0 other, 1 feedback, 2 weapon, 3 vibration
    std::uint8_t left_effect = 0;
    int battery_percent = 0;
    std::uint8_t charging = 0;  // 0 discharging, 1 charging, 2 full; larger: a fault
};

// Parses input report 1 over USB (64 bytes with its id) or 0x31 over Bluetooth (78 bytes with its checksum).
// Empty for any other report (such as the short report 1 that a Bluetooth pad sends until asked for the long
// one), a short report, or a wrong checksum.
[[nodiscard]] std::optional<DualSenseState> dual_sense_state(std::span<const std::uint8_t> report) noexcept;

constexpr std::size_t kTriggerZones = 10;
constexpr std::uint8_t kStrongestZone = 8;

// The effect of a trigger along its travel: mode and ten parameters. Only effects that the maker uses: others
// can damage the mechanism.
struct TriggerEffect {
    std::array<std::uint8_t, 11> bytes{};
    friend bool operator==(const TriggerEffect&, const TriggerEffect&) = default;
};
[[nodiscard]] TriggerEffect trigger_off() noexcept;
// Mode 0x21: a resistance of 0 to 8 (larger values are clamped) for each zone from rest (0) to pulled (9),
// that is a force as a function of travel. All zero: off.
[[nodiscard]] TriggerEffect trigger_resistance(
    const std::array<std::uint8_t, kTriggerZones>& strengths) noexcept;

// The contents of one output report. An empty field leaves the pad's setting unchanged.
struct DualSenseOrders {
    std::optional<TriggerEffect> right_trigger = std::nullopt;
    std::optional<TriggerEffect> left_trigger = std::nullopt;
    struct Rumble {
        std::uint8_t strong = 0;  // left, low frequency
        std::uint8_t weak = 0;    // right, high frequency
    };
    std::optional<Rumble> rumble = std::nullopt;
    std::optional<std::array<std::uint8_t, 3>> light = std::nullopt;  // red, green, blue
    bool end_start_up_light =
        false;  // ends the blue fade after plugging in, which otherwise holds the light bar
};
// Output report 2 over USB: 48 bytes with its id.
[[nodiscard]] Report dual_sense_report(const DualSenseOrders& orders) noexcept;
// The same over Bluetooth: report 0x31 of 78 bytes, with a sequence number modulo 16 and a checksum.
[[nodiscard]] Report by_radio(const Report& over_usb, unsigned sequence) noexcept;

// The byte that precedes a Bluetooth report in the computation of its checksum.
constexpr std::uint8_t kInputSeed = 0xa1;
constexpr std::uint8_t kOutputSeed = 0xa2;
// CRC-32 of Ethernet and zlib (polynomial 0xedb88320, reflected) over the seed and then the bytes.
[[nodiscard]] std::uint32_t radio_checksum(std::uint8_t seed, std::span<const std::uint8_t> bytes) noexcept;

}  // namespace onggi::haptics::hid
