// Force-feedback joysticks: every report byte for byte against the public tables of two makers, whose layouts
// differ in numbers, ranges, widths and order.
#include "engine/haptics/hid/pid_reports.h"

#include <gtest/gtest.h>

#include "tests/support/hex.h"
#include "tests/support/pid_descriptors.h"

namespace onggi::haptics::hid {
namespace {

using testing::as_hex;
using testing::hex;

Result<PidLayout> found(const std::vector<std::uint8_t>& bytes) {
    auto descriptor = ReportDescriptor::parse(bytes);
    if (!descriptor) return descriptor.error();
    return PidLayout::find(std::move(descriptor).value());
}

PidLayout layout_of(const std::vector<std::uint8_t>& bytes) {
    auto layout = found(bytes);
    if (!layout) throw std::runtime_error(layout.error().message);
    return std::move(layout).value();
}

const PidLayout kBoard = layout_of(testing::open_ffboard_descriptor());
const PidLayout kRhino = layout_of(testing::rhino_descriptor());
const PidLayout kSparse = layout_of(testing::sparse_descriptor());

std::string bytes_of(const Report& report) {
    return as_hex(report.view());
}

constexpr PidEffect kFromEast{.block = 3,
                              .type = PidUsage::kConstantForceType,
                              .duration_ms = 500,
                              .acts_on_x = true,
                              .direction_turns = 0.25};
constexpr PidEffect kSpring{.block = 4,
                            .type = PidUsage::kSpringType,
                            .duration_ms = 500,
                            .gain = 0.5,
                            .acts_on_x = true,
                            .acts_on_y = true,
                            .direction_turns = 0.5};

TEST(PidLayout, FindsTheReportLengthsOfTheTables) {
    EXPECT_EQ(kBoard.place(PidUsage::kSetEffect).bytes, 22U);
    EXPECT_EQ(kBoard.place(PidUsage::kSetCondition).bytes, 15U);
    EXPECT_EQ(kBoard.place(PidUsage::kSetConstantForce).bytes, 4U);
    EXPECT_EQ(kBoard.place(PidUsage::kEffectOperation).bytes, 4U);
    EXPECT_EQ(kBoard.place(PidUsage::kBlockLoad).bytes, 5U);
    EXPECT_EQ(kBoard.place(PidUsage::kCreateEffect).bytes, 4U);
    EXPECT_EQ(kBoard.place(PidUsage::kState).bytes, 2U);
    EXPECT_EQ(kBoard.descriptor().report_bytes(ReportKind::kInput, 1), 25U);
    EXPECT_EQ(kRhino.place(PidUsage::kSetEffect).bytes, 17U);
    EXPECT_EQ(kRhino.place(PidUsage::kSetEffect).id, 101);
    EXPECT_TRUE(kBoard.has_effect(PidUsage::kSpringType));
    EXPECT_TRUE(kBoard.has_effect(PidUsage::kFrictionType));
}

TEST(PidReports, CreateEffectsByTheirPlaceInTheDevicesList) {
    EXPECT_EQ(bytes_of(create_effect(kBoard, PidUsage::kConstantForceType)), "11 01 00 00");
    EXPECT_EQ(bytes_of(create_effect(kBoard, PidUsage::kSpringType)), "11 08 00 00");
    EXPECT_EQ(bytes_of(create_effect(kRhino, PidUsage::kDamperType)), "05 09 00 00");
    EXPECT_EQ(bytes_of(block_load_request(kBoard)), "12 00 00 00 00");
}

TEST(PidReports, ReadTheBlockTheDeviceGave) {
    const auto good = block_load(kBoard, hex("12 03 01 f4 01"));
    ASSERT_TRUE(good);
    EXPECT_EQ(good->block, 3);
    EXPECT_EQ(good->status, BlockLoad::Status::kOk);
    EXPECT_EQ(block_load(kBoard, hex("12 00 02 00 00"))->status, BlockLoad::Status::kFull);
    EXPECT_EQ(block_load(kBoard, hex("12 00 03 00 00"))->status, BlockLoad::Status::kError);
    EXPECT_EQ(block_load(kBoard, hex("12 00 00 00 00"))->status, BlockLoad::Status::kUnknown);
    EXPECT_EQ(block_load(kRhino, hex("06 05 01 00 00"))->block, 5);
    EXPECT_FALSE(block_load(kBoard, hex("12")));
    EXPECT_FALSE(block_load(kBoard, hex("12 03")));
    EXPECT_FALSE(block_load(kBoard, hex("13 03 01 f4 01")));
    EXPECT_FALSE(block_load(kBoard, {}));
}

TEST(PidReports, SetAnEffectInTheBoardsLayout) {
    // id block type duration repeat sample delay gain button axes direction 1 and 2, type-specific 1 and 2
    EXPECT_EQ(bytes_of(set_effect(kBoard, kFromEast)),
              "01 03 01 f4 01 00 00 00 00 00 00 ff 00 04 28 23 00 00 00 00 00 00");
    EXPECT_EQ(bytes_of(set_effect(kBoard, kSpring)),
              "01 04 08 f4 01 00 00 00 00 00 00 80 00 04 50 46 00 00 00 00 00 00");
}

TEST(PidReports, SetAnEffectInTheRhinosLayout) {
    // id block type duration repeat sample gain button axes directions delay
    EXPECT_EQ(bytes_of(set_effect(kRhino, kFromEast)), "65 03 01 f4 01 00 00 00 00 00 10 00 04 40 00 00 00");
    EXPECT_EQ(bytes_of(set_effect(kRhino, kSpring)), "65 04 08 f4 01 00 00 00 00 00 08 00 04 80 00 00 00");
}

TEST(PidReports, SetAConditionForEachAxis) {
    const PidCondition wall{
        .centre = 0.5, .positive_coefficient = 0.0, .negative_coefficient = 1.0, .saturation = 0.25};
    // id block axis centre +coefficient -coefficient +saturation -saturation dead band
    EXPECT_EQ(bytes_of(set_condition(kBoard, 4, Axis::kX, wall)),
              "03 04 00 00 40 00 00 ff 7f 00 20 00 20 00 00");
    EXPECT_EQ(bytes_of(set_condition(kBoard, 4, Axis::kY, wall)),
              "03 04 01 00 40 00 00 ff 7f 00 20 00 20 00 00");
    EXPECT_EQ(bytes_of(set_condition(kRhino, 4, Axis::kY, wall)),
              "67 04 01 00 08 00 00 00 10 00 04 00 04 00 00");
    const PidCondition left{.centre = -1.0, .positive_coefficient = -0.5};
    EXPECT_EQ(bytes_of(set_condition(kBoard, 4, Axis::kX, left)),
              "03 04 00 01 80 00 c0 00 00 ff 7f ff 7f 00 00");
}

TEST(PidReports, SetAConstantForceAndNeverOneBeyondFullScale) {
    EXPECT_EQ(bytes_of(set_constant_force(kBoard, 3, 0.0)), "05 03 00 00");
    EXPECT_EQ(bytes_of(set_constant_force(kBoard, 3, 1.0)), "05 03 ff 7f");
    EXPECT_EQ(bytes_of(set_constant_force(kBoard, 3, -1.0)), "05 03 01 80");
    EXPECT_EQ(bytes_of(set_constant_force(kBoard, 3, -7.0)), "05 03 01 80");
    EXPECT_EQ(bytes_of(set_constant_force(kRhino, 3, 0.5)), "69 03 00 08");
    EXPECT_EQ(bytes_of(set_constant_force(kRhino, 3, -1.0)), "69 03 00 f0");
}

TEST(PidReports, StartStopAndFreeAnEffect) {
    EXPECT_EQ(bytes_of(effect_operation(kBoard, 3, PidUsage::kStart, 1)), "0a 03 01 01");
    EXPECT_EQ(bytes_of(effect_operation(kBoard, 3, PidUsage::kStart, kLoopForever)), "0a 03 01 ff");
    EXPECT_EQ(bytes_of(effect_operation(kBoard, 3, PidUsage::kStop, 0)), "0a 03 03 00");
    EXPECT_EQ(bytes_of(effect_operation(kRhino, 3, PidUsage::kStart, 1)), "6e 03 01 01");
    EXPECT_EQ(bytes_of(block_free(kBoard, 3)), "0b 03");
    EXPECT_EQ(bytes_of(block_free(kRhino, 3)), "6f 03");
}

TEST(PidReports, ControlTheDeviceByABitOrByAPlaceInAList) {
    EXPECT_EQ(bytes_of(device_control(kBoard, PidUsage::kEnableActuators)), "0c 01");
    EXPECT_EQ(bytes_of(device_control(kBoard, PidUsage::kDisableActuators)), "0c 02");
    EXPECT_EQ(bytes_of(device_control(kBoard, PidUsage::kStopAll)), "0c 04");
    EXPECT_EQ(bytes_of(device_control(kBoard, PidUsage::kReset)), "0c 08");
    // The Rhino's list begins with "disable".
    EXPECT_EQ(bytes_of(device_control(kRhino, PidUsage::kDisableActuators)), "70 01");
    EXPECT_EQ(bytes_of(device_control(kRhino, PidUsage::kEnableActuators)), "70 02");
    EXPECT_EQ(bytes_of(device_control(kRhino, PidUsage::kStopAll)), "70 03");
    EXPECT_EQ(bytes_of(device_control(kRhino, PidUsage::kReset)), "70 04");
    EXPECT_EQ(bytes_of(device_gain(kBoard, 1.0)), "0d ff");
    EXPECT_EQ(bytes_of(device_gain(kRhino, 0.5)), "71 00 08");
}

TEST(PidReports, OmitFieldsThatAFirmwareLacks) {
    EXPECT_EQ(bytes_of(set_condition(kSparse, 2, Axis::kX, {.centre = 1.0, .positive_coefficient = 1.0})),
              "03 02 10 27 10 27 10 27");
    EXPECT_EQ(set_condition(kSparse, 2, Axis::kY, {}).size, 0U) << "it cannot tell the axes apart";
    EXPECT_EQ(bytes_of(set_effect(kSparse, kFromEast)), "01 03 01 f4 01 00 00 00 00 ff 00 04 40 00");
    EXPECT_FALSE(kSparse.place(PidUsage::kState));
    EXPECT_FALSE(pid_device_state(kSparse, hex("02 1f")));
}

TEST(PidStick, ReadsTheBoardsPlaceAndButtons) {
    StickState state;
    ASSERT_TRUE(take_stick_report(
        kBoard, hex("01 | 05 00 00 80 00 00 00 00 | ff 7f 01 80 00 00 00 00 00 00 00 00 00 00 00 00"),
        state));
    EXPECT_EQ(state.deflection, dvec2(1.0, -1.0));
    EXPECT_EQ(state.buttons, 0x80000005U);
    ASSERT_TRUE(take_stick_report(kRhino, hex("01 00 08 00 f8 00 00"), state));
    EXPECT_EQ(state.deflection, dvec2(0.5, -0.5));
    EXPECT_EQ(state.buttons, 0U);
}

TEST(PidStick, RejectsReportsThatAreCutOrAnother) {
    StickState state{.deflection = {0.25, 0.25}};
    EXPECT_FALSE(take_stick_report(kBoard, {}, state));
    EXPECT_FALSE(take_stick_report(kBoard, hex("02 1f"), state));
    EXPECT_FALSE(take_stick_report(kBoard, hex("01 00 00 00 00 00 00 00 00 ff 7f 01"), state));
    EXPECT_EQ(state.deflection, dvec2(0.25));
}

TEST(PidStick, HearsTheSafetySwitch) {
    ASSERT_TRUE(pid_device_state(kBoard, hex("02 06")));
    EXPECT_TRUE(pid_device_state(kBoard, hex("02 06"))->safety_switch_on);
    EXPECT_TRUE(pid_device_state(kBoard, hex("02 06"))->actuators_enabled);
    EXPECT_FALSE(pid_device_state(kBoard, hex("02 02"))->safety_switch_on);
    EXPECT_FALSE(pid_device_state(kBoard, hex("02 04"))->actuators_enabled);
    EXPECT_FALSE(pid_device_state(kBoard, hex("01 06")));
}

TEST(PidLayout, RejectsAJoystickThatTakesNoForces) {
    // A SpaceMouse's beginning: six axes, no page 0x0F.
    const auto layout = found(hex("05 01 09 08 a1 01 85 01 09 30 09 31 15 00 26 e8 03 75 10 95 02 81 02 c0"));
    ASSERT_FALSE(layout);
    EXPECT_EQ(layout.error().message,
              "force feedback (USB PID 1.0): expected the effect type of Create New Effect, found none");
    EXPECT_FALSE(found(hex("05 01 09 30 15 00 26 e8 03 75 10 95 01 81 02")));
}

// The descriptor with each local usage `id` made one that means nothing (HID 1.11, 6.2.2.2: short items).
std::vector<std::uint8_t> without(std::vector<std::uint8_t> bytes, std::uint8_t id) {
    constexpr std::uint8_t kOneByteUsage = 0x09;
    constexpr std::uint8_t kUnknown = 0xef;
    for (std::size_t at = 0; at + 1 < bytes.size();) {
        if (bytes[at] == kOneByteUsage && bytes[at + 1] == id) bytes[at + 1] = kUnknown;
        const std::size_t size = bytes[at] & 3U;
        at += 1 + (size == 3 ? 4 : size);
    }
    return bytes;
}

TEST(PidLayout, RequiresOnlyTheFieldsOfAForce) {
    for (const auto& whole :
         {testing::open_ffboard_descriptor(), testing::rhino_descriptor(), testing::sparse_descriptor()}) {
        for (const int needed :
             {0xab, 0x26, 0x89, 0x22, 0x8c, 0x21, 0x50, 0x73, 0x70, 0x77, 0x79, 0x7b, 0x99, 0x30, 0x31})
            EXPECT_FALSE(found(without(whole, static_cast<std::uint8_t>(needed)))) << std::hex << needed;
        // Block Free, pool, gain, state; trigger, sample period, start delay, direction enable, direction and
        // axes; condition and its parts; the other control words; names of the lists.
        for (const int optional :
             {0x90, 0x7f, 0x7d, 0x7e, 0x92, 0x53, 0x54, 0x51, 0xa7, 0x56, 0x57, 0x55, 0x58,
              0x5f, 0x60, 0x61, 0x62, 0x63, 0x64, 0x65, 0x23, 0x97, 0x98, 0x9a, 0x9b, 0x9c,
              0x7a, 0x7c, 0x52, 0x25, 0x78, 0x8b, 0x8d, 0x8e, 0xac, 0x40, 0x41, 0x43}) {
            const auto layout = found(without(whole, static_cast<std::uint8_t>(optional)));
            EXPECT_TRUE(layout) << std::hex << optional << ": " << layout.error().message;
        }
    }
}

// The report may be named by its own usage, by its list's alone (Linux's hid-pidff looks for that one) or by
// both.
TEST(PidLayout, FindsDeviceControlByEitherName) {
    EXPECT_EQ(bytes_of(device_control(kSparse, PidUsage::kStopAll)), "0c 03");
    const auto whole = testing::open_ffboard_descriptor();
    for (const auto& bytes : {whole, without(whole, 0x95), without(whole, 0x96)})
        EXPECT_EQ(bytes_of(device_control(layout_of(bytes), PidUsage::kStopAll)), "0c 04");
    const auto layout = found(without(without(whole, 0x95), 0x96));
    ASSERT_FALSE(layout);
    EXPECT_EQ(layout.error().message,
              "force feedback (USB PID 1.0): expected the stop-all of Device Control, found none");
}

TEST(PidLayout, RejectsADescriptorCutAnywhere) {
    const std::vector<std::uint8_t> whole = testing::open_ffboard_descriptor();
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_FALSE(found({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)})) << length;
}

}  // namespace
}  // namespace onggi::haptics::hid
