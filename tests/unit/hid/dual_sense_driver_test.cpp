// The DualSense's driver: what the hand does to the tool, and the clay to the trigger.
#include "engine/haptics/hid/dual_sense_driver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scripted_hid.h"

namespace onggi::haptics::hid {
namespace {

using testing::as_hex;
using testing::hex;
using testing::ScriptedHid;
using testing::ScriptedPort;

std::vector<std::uint8_t> report_with(std::initializer_list<std::pair<std::size_t, std::uint8_t>> bytes) {
    std::vector<std::uint8_t> report(64, 0);
    report[0] = 0x01;
    report[1] = report[2] = report[3] = report[4] = 0x80;
    report[8] = 0x08;
    for (const auto& [at, value] : bytes)
        report[at] = value;
    return report;
}

class DualSenseDriverTest : public ::testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(driver.start({}, port));
        driver.take_report(report_with({}), 0);
    }
    std::vector<std::uint8_t> told(const ForceOrder& order, std::int64_t now_ns) {
        script->take_sent();
        EXPECT_TRUE(driver.send(port, order, now_ns));
        return script->sent.empty() ? std::vector<std::uint8_t>{} : hex(script->sent.front().substr(2));
    }

    std::shared_ptr<ScriptedHid> script = std::make_shared<ScriptedHid>();
    ScriptedPort port{script};
    DualSenseDriver driver;
};

TEST_F(DualSenseDriverTest, BeginsWithLooseTriggersAndAStillPad) {
    ASSERT_EQ(script->sent.size(), 1U);
    EXPECT_EQ(script->sent.front().substr(0, 13), "w 02 0f 04 00");
    const auto bytes = hex(script->sent.front().substr(2));
    EXPECT_EQ(bytes.size(), 48U);
    EXPECT_EQ(bytes[11], 0x05);
    EXPECT_EQ(bytes[22], 0x05);
}

TEST_F(DualSenseDriverTest, MovesTheToolWithTheLeftStickAndPressesItInWithTheTrigger) {
    EXPECT_EQ(driver.input(0).rate_mm_s, dvec2(0.0));
    driver.take_report(report_with({{1, 255}, {2, 255}, {6, 255}}), 0);
    const DualSenseMapping mapping;
    EXPECT_NEAR(driver.input(0).rate_mm_s.x, mapping.fastest_mm_s, 1e-9) << "right is outwards";
    EXPECT_NEAR(driver.input(0).rate_mm_s.y, -mapping.fastest_mm_s, 1e-9) << "down is down";
    EXPECT_NEAR(driver.input(0).press_mm, mapping.press_mm, 1e-9);
    driver.take_report(report_with({{1, 0x84}, {2, 0x7c}}), 0);
    EXPECT_EQ(driver.input(0).rate_mm_s, dvec2(0.0)) << "a worn stick rests beside its middle";
}

TEST_F(DualSenseDriverTest, TurnsTheWheelByCrossOrWhileL2IsPulled) {
    driver.take_report(report_with({{8, 0x28}}), 0);
    driver.take_report(report_with({}), 0);
    EXPECT_TRUE(driver.input(0).button);
    driver.take_report(report_with({{8, 0x28}}), 0);
    EXPECT_FALSE(driver.input(0).button);
    driver.take_report(report_with({{8, 0x28}, {5, 0xff}}), 0);
    EXPECT_TRUE(driver.input(0).button);
}

TEST_F(DualSenseDriverTest, IsStaleAfterATenthOfASecond) {
    EXPECT_TRUE(driver.input(100 * kMs).is_live);
    EXPECT_FALSE(driver.input(101 * kMs).is_live);
}

TEST_F(DualSenseDriverTest, ShowsTheClaysStiffnessAlongTheTrigger) {
    // Trigger half pulled (128 of 255: 10.04 mm of 20). The tool at 60 mm, pushed out by 1 N of 0.5 N/mm:
    // contact 2 mm before it, at 8.04 mm of travel. Zones are 2 mm wide: the centre of zone 4, at 9 mm, gets
    // 0.48 N of 3.3 N, one of eight; zone 5 at 11 mm 1.48 N, four; then 2.48 N, six; then all eight.
    driver.take_report(report_with({{6, 128}}), 0);
    const auto report = told({.force_n = {1.0, 0.0}, .tool_mm = {60.0, 50.0}, .ticks = 1}, 20 * kMs);
    ASSERT_EQ(report.size(), 48U);
    const std::array<std::uint8_t, kTriggerZones> zones{0, 0, 0, 0, 1, 4, 6, 8, 8, 8};
    EXPECT_EQ(as_hex(std::span(report).subspan(11, 11)), as_hex(trigger_resistance(zones).bytes));
    EXPECT_EQ(report[1], 0x07) << "right trigger and rumble; the left trigger stays as it is";
}

TEST_F(DualSenseDriverTest, LeavesTheTriggerLooseWhereItCannotPushBack) {
    for (const double force_n : {0.0, -2.0}) {
        const ForceOrder order{.force_n = {force_n, 3.0}, .tool_mm = {60.0, 50.0}, .ticks = 1};
        EXPECT_EQ(trigger_for_wall(order, 10.0, {}), trigger_off()) << force_n;
    }
}

TEST_F(DualSenseDriverTest, TremblesWithTheWallThatSlidesBy) {
    const auto report =
        told({.tangential_n = -1.65, .tool_mm = {60.0, 50.0}, .turns = true, .ticks = 1}, 20 * kMs);
    ASSERT_EQ(report.size(), 48U);
    EXPECT_EQ(report[3], 0x30) << "half of the most";
    EXPECT_EQ(report[4], 0x00);
    EXPECT_EQ(as_hex(std::span(report).subspan(45, 3)), "18 50 08") << "the wheel turns, the clay is at ease";
}

TEST_F(DualSenseDriverTest, ShinesTheRedderTheNearerTheClayIsToGivingWay) {
    const auto light = [](double load) { return as_hex(light_for({.turns = true, .work = {.load = load}})); };
    EXPECT_EQ(as_hex(light_for({.work = {.load = 0.9}})), "00 10 40") << "a standing wheel is blue";
    EXPECT_EQ(light(0.0), "18 50 08");
    EXPECT_EQ(light(0.5), "60 28 00");
    EXPECT_EQ(light(1.0), "80 04 00");
    EXPECT_EQ(light(7.0), "80 04 00");
    EXPECT_EQ(light(0.51), light(0.6)) << "in coarse steps: not a report for every breath";
    EXPECT_EQ(light(std::nan("")), light(0.0));
}

TEST_F(DualSenseDriverTest, IsAsStiffAsTheClayAndNoStrongerThanAThinWall) {
    const auto zones = [](const WorkFelt& work) {
        const ForceOrder order{.force_n = {1.0, 0.0}, .tool_mm = {60.0, 50.0}, .work = work};
        return as_hex(trigger_for_wall(order, 10.0, {}).bytes);
    };
    // Contact where 1 N is reached at 10 mm of travel: 2 N/mm begins 0.5 mm before it, 0.1 N/mm 10 mm.
    EXPECT_EQ(zones({.stiffness_n_per_mm = 2.0}),
              as_hex(trigger_resistance({0, 0, 0, 0, 0, 7, 8, 8, 8, 8}).bytes));
    EXPECT_EQ(zones({.stiffness_n_per_mm = 0.1}),
              as_hex(trigger_resistance({0, 1, 1, 2, 2, 3, 3, 4, 4, 5}).bytes));
    EXPECT_EQ(zones({.stiffness_n_per_mm = 2.0, .wall_mm = 3.0, .most_force_n = 0.75}),
              as_hex(trigger_resistance({0, 0, 0, 0, 0, 2, 2, 2, 2, 2}).bytes))
        << "a wall of 3 mm bends aside at 0.75 N: two of eight";
}

// Bytes 33 to 36: a finger's number with bit 7 for none, then x and y in 12 bits each.
std::vector<std::uint8_t> with_finger(std::uint8_t id, unsigned x, unsigned y) {
    return report_with({{33, id},
                        {34, static_cast<std::uint8_t>(x & 0xffU)},
                        {35, static_cast<std::uint8_t>((x >> 8U) | ((y & 0x0fU) << 4U))},
                        {36, static_cast<std::uint8_t>(y >> 4U)}});
}

TEST_F(DualSenseDriverTest, DrawsTheToolByAFingerOnTheTouchPad) {
    driver.take_report(with_finger(1, 400, 500), 0);
    EXPECT_EQ(driver.input(0).travelled_mm, dvec2(0.0)) << "a finger put down draws nothing";
    driver.take_report(with_finger(1, 400 + 192, 500 - 96), 0);
    EXPECT_NEAR(driver.input(0).travelled_mm.x, 160.0 * 192.0 / 1919.0, 1e-9);
    EXPECT_NEAR(driver.input(0).travelled_mm.y, 160.0 * 96.0 / 1919.0, 1e-9) << "away from the hand is up";
    const dvec2 drawn = driver.input(0).travelled_mm;
    driver.take_report(with_finger(0x80 | 1, 900, 900), 0);
    driver.take_report(with_finger(2, 100, 100), 0);
    EXPECT_EQ(driver.input(0).travelled_mm, drawn) << "lifted and put down elsewhere";
    driver.take_report(with_finger(3, 1500, 800), 0);
    EXPECT_EQ(driver.input(0).travelled_mm, drawn) << "another finger";
}

TEST_F(DualSenseDriverTest, LeadsTheToolByTiltWhileL1IsHeld) {
    // Gyro at 16 to 19: pitch and yaw, 1/16 degree/s a step; sensor time at 28 to 31, 3 a us.
    const auto tilted = [](std::uint8_t l1, std::int16_t pitch, std::int16_t yaw, std::uint32_t time) {
        const auto low = [](auto value) { return static_cast<std::uint8_t>(value & 0xff); };
        const auto high = [](auto value) { return static_cast<std::uint8_t>((value >> 8) & 0xff); };
        return report_with({{9, l1},
                            {16, low(pitch)},
                            {17, high(pitch)},
                            {18, low(yaw)},
                            {19, high(yaw)},
                            {28, low(time)},
                            {29, high(time)},
                            {30, low(time >> 16U)}});
    };
    driver.take_report(tilted(0, 1600, 0, 0), 0);
    driver.take_report(tilted(0, 1600, 0, 12'000), 0);
    EXPECT_EQ(driver.input(0).travelled_mm, dvec2(0.0)) << "without L1 the pad may be waved about";
    driver.take_report(tilted(1, 1600, -1600, 24'000), 0);
    // 100 degrees/s for 4 ms at 1.5 mm a degree.
    EXPECT_NEAR(driver.input(0).travelled_mm.x, 0.6, 1e-9);
    EXPECT_NEAR(driver.input(0).travelled_mm.y, 0.6, 1e-9);
    driver.take_report(tilted(1, 30, -30, 36'000), 0);
    EXPECT_NEAR(driver.input(0).travelled_mm.x, 0.6, 1e-9) << "a hand at rest";
    driver.take_report(tilted(1, 1600, 0, 12'000'000), 0);
    EXPECT_LT(driver.input(0).travelled_mm.y, 8.2) << "reports that stayed away are no leap";
}

TEST_F(DualSenseDriverTest, TurnsTheWheelTheFasterTheFurtherL2IsPulled) {
    driver.take_report(report_with({{5, 0x80}}), 0);
    EXPECT_NEAR(driver.input(0).rev_min, 240.0 * 128.0 / 255.0, 1e-9);
    driver.take_report(report_with({{5, 0x20}}), 0);
    EXPECT_EQ(driver.input(0).rev_min, 0.0);
}

TEST_F(DualSenseDriverTest, SendsNoReportTwiceOrTooOften) {
    ForceOrder order{.force_n = {1.0, 0.0}, .tool_mm = {60.0, 50.0}, .ticks = 1};
    EXPECT_FALSE(told(order, 20 * kMs).empty());
    EXPECT_TRUE(told(order, 40 * kMs).empty());
    order.force_n.x = 2.5;
    EXPECT_FALSE(told(order, 60 * kMs).empty());
    order.force_n.x = 0.5;
    EXPECT_TRUE(told(order, 65 * kMs).empty()) << "5 ms after the last";
    EXPECT_FALSE(told(order, 70 * kMs).empty());
}

TEST_F(DualSenseDriverTest, MovesTheToolAlthoughThePadRefusesToBeTold) {
    script->write_fails = true;
    ASSERT_TRUE(driver.start({}, port));
    driver.take_report(report_with({{1, 255}}), 0);
    EXPECT_TRUE(driver.send(port, {.force_n = {1.0, 0.0}, .tool_mm = {60.0, 50.0}, .ticks = 1}, 20 * kMs));
    EXPECT_GT(driver.input(0).rate_mm_s.x, 0.0);
    script->write_fails = false;
    EXPECT_FALSE(told({.force_n = {1.0, 0.0}, .tool_mm = {60.0, 50.0}, .ticks = 2}, 40 * kMs).empty());
    script->is_plugged_in = false;
    script->write_fails = true;
    EXPECT_FALSE(driver.send(port, {.force_n = {2.0, 0.0}, .tool_mm = {60.0, 50.0}, .ticks = 3}, 60 * kMs));
}

TEST_F(DualSenseDriverTest, LeavesThePadLooseStillAndDark) {
    script->take_sent();
    driver.stop(port);
    ASSERT_EQ(script->sent.size(), 1U);
    EXPECT_EQ(as_hex(hex(script->sent.front().substr(2))),
              as_hex(dual_sense_report({.right_trigger = trigger_off(),
                                        .left_trigger = trigger_off(),
                                        .rumble = DualSenseOrders::Rumble{},
                                        .light = std::array<std::uint8_t, 3>{}})
                         .view()));
}

TEST(DualSenseDriverByRadio, AsksForTheLongReportsAndTellsInThem) {
    const auto script = std::make_shared<ScriptedHid>();
    ScriptedPort port(script);
    DualSenseDriver driver;
    const HidDeviceInfo by_radio{.bus = HidBusType::kBluetooth};
    EXPECT_FALSE(driver.start(by_radio, port)) << "one that does not answer cannot be heard";
    EXPECT_EQ(script->take_sent(), std::vector<std::string>{"g 05"});
    script->features[0x05].push_back(std::vector<std::uint8_t>(41, 0));
    ASSERT_TRUE(driver.start(by_radio, port));
    const auto begun = script->take_sent();
    ASSERT_EQ(begun.size(), 2U);
    EXPECT_EQ(begun[0], "g 05");
    const auto first = hex(begun[1].substr(2));
    ASSERT_EQ(first.size(), 78U);
    EXPECT_EQ(as_hex(std::span(first).first(6)), "31 00 10 0f 04 00");
    EXPECT_EQ(first[13], 0x05) << "the right trigger is loose";
    driver.stop(port);
    const auto last = hex(script->take_sent().at(0).substr(2));
    EXPECT_EQ(last[1], 0x10) << "the next number";
    EXPECT_EQ(last.size(), 78U);
}

}  // namespace
}  // namespace onggi::haptics::hid
