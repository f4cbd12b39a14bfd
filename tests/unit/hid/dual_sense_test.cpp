// The DualSense's reports over USB, byte for byte against the public tables and vectors.
#include "engine/haptics/hid/dual_sense.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "tests/support/hex.h"

namespace onggi::haptics::hid {
namespace {

using testing::as_hex;
using testing::hex;

std::string bytes_of(const TriggerEffect& effect) {
    return as_hex(effect.bytes);
}

std::array<std::uint8_t, kTriggerZones> from_zone(std::size_t first, std::uint8_t strength) {
    std::array<std::uint8_t, kTriggerZones> strengths{};
    std::fill(strengths.begin() + static_cast<std::ptrdiff_t>(first), strengths.end(), strength);
    return strengths;
}

// A report at rest, with bytes replaced from an offset on.
std::vector<std::uint8_t> resting_report(
    std::initializer_list<std::pair<std::size_t, std::string_view>> patches = {}) {
    std::vector<std::uint8_t> report(64, 0);
    report[0] = 0x01;
    for (const std::size_t stick : {1U, 2U, 3U, 4U})
        report[stick] = 0x80;
    report[8] = 0x08;
    report[33] = report[37] = 0x80;
    for (const auto& [at, bytes] : patches) {
        const auto values = hex(bytes);
        std::copy(values.begin(), values.end(), report.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return report;
}

TEST(DualSenseTriggers, AreToldTheBytesOfTheVectors) {
    EXPECT_EQ(bytes_of(trigger_resistance(from_zone(0, 8))), "21 ff 03 ff ff ff 3f 00 00 00 00");
    EXPECT_EQ(bytes_of(trigger_resistance(from_zone(3, 5))), "21 f8 03 00 48 92 24 00 00 00 00");
    EXPECT_EQ(bytes_of(trigger_resistance({0, 1, 2, 3, 4, 5, 6, 7, 8, 8})),
              "21 fe 03 40 34 d6 3f 00 00 00 00");
    EXPECT_EQ(bytes_of(trigger_off()), "05 00 00 00 00 00 00 00 00 00 00");
}

TEST(DualSenseTriggers, AreNeverToldMoreThanTheMakersRange) {
    EXPECT_EQ(trigger_resistance(from_zone(0, 200)), trigger_resistance(from_zone(0, 8)));
    EXPECT_EQ(trigger_resistance(from_zone(0, 0)), trigger_off());
}

TEST(DualSenseOrders, SetBothTriggersAsInTheVector) {
    const TriggerEffect effect = trigger_resistance(from_zone(3, 5));
    EXPECT_EQ(as_hex(dual_sense_report({.right_trigger = effect, .left_trigger = effect}).view()),
              as_hex(hex("02 0c 00 00 00 00 00 00 00 00 00 | 21 f8 03 00 48 92 24 00 00 00 00 |"
                         "21 f8 03 00 48 92 24 00 00 00 00 | 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00")));
}

TEST(DualSenseOrders, LieWhereTheKernelsOwnReportsHaveThem) {
    // Linux's driver sends two reports when it binds: the end of the start-up light, all zero but for bytes
    // 39 and 42; and blue 0x80 at byte 47 with bit 2 of byte 2 (there together with the player lamps of bit
    // 4).
    const Report first = dual_sense_report({.end_start_up_light = true});
    for (std::size_t at = 0; at < first.size; ++at)
        EXPECT_EQ(first.bytes[at], at == 0 || at == 39 || at == 42 ? 0x02 : 0x00) << at;
    const Report second = dual_sense_report({.light = std::array<std::uint8_t, 3>{0x00, 0x00, 0x80}});
    for (std::size_t at = 0; at < second.size; ++at)
        EXPECT_EQ(second.bytes[at], at == 0 ? 0x02 : at == 2 ? 0x04 : at == 47 ? 0x80 : 0x00) << at;
    EXPECT_EQ(second.size, 48U);
}

TEST(DualSenseOrders, RumbleWithTheStrongMotorOnTheLeft) {
    const Report report =
        dual_sense_report({.rumble = DualSenseOrders::Rumble{.strong = 0x11, .weak = 0x22}});
    EXPECT_EQ(as_hex(std::span(report.bytes).first(6)), "02 03 00 22 11 00");
    const Report nothing = dual_sense_report({});
    EXPECT_EQ(as_hex(std::span(nothing.bytes).first(6)), "02 00 00 00 00 00")
        << "nothing is valid, nothing changes";
}

TEST(DualSense, ReadsSticksTriggersAndButtons) {
    const auto state = dual_sense_state(resting_report({{1, "00 ff"}, {5, "10 f0"}, {8, "22 01 80"}}));
    ASSERT_TRUE(state);
    EXPECT_EQ(state->left_stick, (std::array<std::uint8_t, 2>{0x00, 0xff}));
    EXPECT_EQ(state->right_stick, (std::array<std::uint8_t, 2>{0x80, 0x80}));
    EXPECT_EQ(state->left_trigger, 0x10);
    EXPECT_EQ(state->right_trigger, 0xf0);
    EXPECT_EQ(state->hat, 2);
    EXPECT_EQ(state->buttons,
              std::uint32_t{DualSenseState::kCross} | DualSenseState::kL1 | DualSenseState::kRightPaddle);
    EXPECT_EQ(dual_sense_state(resting_report())->hat, DualSenseState::kNoHat);
    EXPECT_EQ(dual_sense_state(resting_report())->buttons, 0U);
}

TEST(DualSense, ReadsTheSensorsOfAPublicSample) {
    // Field values of a ViGEm DualSense sample, put where the table has them.
    const auto state = dual_sense_state(resting_report({{16, "6b 00 07 00 04 00"},
                                                        {22, "39 01 bc 25 57 eb"},  // 313, 9660, -5289
                                                        {28, "84 ff 6b 01"},
                                                        {42, "09 09"},
                                                        {53, "29 08"}}));
    ASSERT_TRUE(state);
    EXPECT_EQ(state->gyro, (std::array<std::int16_t, 3>{0x6b, 0x07, 0x04}));
    EXPECT_EQ(state->accel, (std::array<std::int16_t, 3>{313, 9660, -5289}));
    EXPECT_EQ(state->sensor_time, 0x016bff84U);
    EXPECT_EQ(state->right_trigger_zone, 9);
    EXPECT_FALSE(state->right_trigger_loaded);
    EXPECT_EQ(state->battery_percent, 90);
    EXPECT_EQ(state->charging, 2);
}

TEST(DualSense, ReadsTouchesAndTriggerStates) {
    // Finger 5 at 0x123, 0x345.
    const auto state = dual_sense_state(resting_report({{33, "05 23 51 34"}, {42, "13 02"}, {48, "31"}}));
    ASSERT_TRUE(state);
    EXPECT_TRUE(state->touches[0].touching);
    EXPECT_EQ(state->touches[0].x, 0x123);
    EXPECT_EQ(state->touches[0].y, 0x345);
    EXPECT_FALSE(state->touches[1].touching);
    EXPECT_TRUE(state->right_trigger_loaded);
    EXPECT_EQ(state->right_trigger_zone, 3);
    EXPECT_FALSE(state->left_trigger_loaded);
    EXPECT_EQ(state->right_effect, 1);
    EXPECT_EQ(state->left_effect, 3);
}

TEST(DualSense, RejectsReportsOfAnotherKind) {
    auto report = resting_report();
    report.pop_back();
    EXPECT_FALSE(dual_sense_state(report));
    report = resting_report();
    report[0] = 0x31;  // over Bluetooth they are longer
    EXPECT_FALSE(dual_sense_state(report));
    EXPECT_FALSE(dual_sense_state({}));
}

// The Bluetooth form of the USB report.
std::vector<std::uint8_t> radio_report(const std::vector<std::uint8_t>& report) {
    std::vector<std::uint8_t> bytes(78, 0);
    bytes[0] = 0x31;
    bytes[1] = 0x01;
    std::copy(report.begin() + 1, report.end(), bytes.begin() + 2);
    const std::uint32_t checksum = radio_checksum(kInputSeed, std::span(bytes).first(74));
    for (std::size_t byte = 0; byte < 4; ++byte)
        bytes[74 + byte] = static_cast<std::uint8_t>(checksum >> (8 * byte));
    return bytes;
}

TEST(DualSenseByRadio, HasTheChecksumOfZlibAndOfACapture) {
    // "123456789", and what was captured of a DualShock 4, whose scheme is the same: seed 53, then 08 02 and
    // 42 zeros.
    const auto nine = hex("32 33 34 35 36 37 38 39");
    EXPECT_EQ(radio_checksum('1', nine), 0xcbf43926U);
    std::vector<std::uint8_t> captured(44, 0);
    captured[0] = 0x08;
    captured[1] = 0x02;
    EXPECT_EQ(radio_checksum(0x53, captured), 0x23a2efe0U);
}

TEST(DualSenseByRadio, IsToldTheBytesOfTheVectors) {
    const Report nothing = by_radio(dual_sense_report({}), 0);
    ASSERT_EQ(nothing.size, 78U);
    EXPECT_EQ(as_hex(nothing.view().first(4)), "31 00 10 00");
    EXPECT_EQ(as_hex(nothing.view().last(4)), "b5 01 15 23");
    const TriggerEffect effect = trigger_resistance(from_zone(3, 5));
    const Report both = by_radio(dual_sense_report({.right_trigger = effect, .left_trigger = effect}), 1);
    EXPECT_EQ(as_hex(both.view().first(13 + 11)),
              "31 10 10 0c 00 00 00 00 00 00 00 00 00 21 f8 03 00 48 92 24 00 00 00 00");
    EXPECT_EQ(as_hex(both.view().last(4)), "40 8c a6 e2");
    EXPECT_EQ(by_radio(dual_sense_report({}), 17).bytes[1], 0x10) << "numbers go round";
}

TEST(DualSenseByRadio, SaysTheSameAsByCable) {
    const auto report =
        resting_report({{1, "12"}, {6, "fe"}, {16, "6b"}, {28, "84"}, {33, "05 23"}, {53, "29"}});
    const auto cable = dual_sense_state(report);
    const auto radio = dual_sense_state(radio_report(report));
    ASSERT_TRUE(cable);
    ASSERT_TRUE(radio);
    EXPECT_EQ(radio->left_stick, cable->left_stick);
    EXPECT_EQ(radio->right_trigger, 0xfe);
    EXPECT_EQ(radio->gyro, cable->gyro);
    EXPECT_EQ(radio->sensor_time, 0x84U);
    EXPECT_TRUE(radio->touches[0].touching);
    EXPECT_EQ(radio->touches[0].x, cable->touches[0].x);
    EXPECT_EQ(radio->battery_percent, 90);
    EXPECT_EQ(radio->charging, 2);
}

TEST(DualSenseByRadio, RejectsAReportWithAWrongChecksum) {
    const auto whole = radio_report(resting_report());
    ASSERT_TRUE(dual_sense_state(whole));
    for (std::size_t byte = 0; byte < whole.size(); ++byte) {
        auto broken = whole;
        broken[byte] ^= 0x10;
        EXPECT_FALSE(dual_sense_state(broken)) << byte;
    }
    EXPECT_FALSE(dual_sense_state(std::span(whole).first(77)));
    EXPECT_FALSE(dual_sense_state(hex("01 80 80 80 80 08 00 00 00 00")))
        << "the short report before it is asked";
}

}  // namespace
}  // namespace onggi::haptics::hid
