// The joystick's driver, report by report, against a scripted OpenFFBoard (and others where they differ).
#include "engine/haptics/hid/pid_driver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/haptics/hid/hid_device.h"
#include "tests/support/pid_descriptors.h"
#include "tests/support/public_devices.h"
#include "tests/support/scripted_hid.h"

namespace onggi::haptics::hid {
namespace {

using testing::hex;
using testing::ScriptedBus;
using testing::ScriptedHid;
using testing::ScriptedPort;
using Log = std::vector<std::string>;

// A stick measured at 10 N full scale over a travel of 100 mm, so that the numbers can be followed by hand.
PidMapping measured_stick() {
    PidMapping mapping;
    mapping.reach = {
        .least_radius_mm = 0.0, .most_radius_mm = 100.0, .least_height_mm = 0.0, .most_height_mm = 200.0};
    mapping.full_scale_n = 10.0;
    mapping.stiffness_n_per_mm = 0.1;
    return mapping;
}

class PidDriverTest : public ::testing::Test {
  protected:
    PidDriverTest() : driver(measured_stick()) {
        info.report_descriptor = testing::open_ffboard_descriptor();
        for (const char* answer : {"12 01 01 00 01", "12 02 01 00 01", "12 03 01 00 01", "12 04 01 00 01"})
            script->features[0x12].push_back(hex(answer));
    }

    void start() {
        const auto started = driver.start(info, port);
        ASSERT_TRUE(started) << started.error().message;
        script->take_sent();
        driver.take_report(hex(kStickInTheMiddle), 0);
    }
    Log told(const ForceOrder& order, std::int64_t now_ns) {
        EXPECT_TRUE(driver.send(port, order, now_ns));
        return script->take_sent();
    }

    static constexpr std::string_view kStickInTheMiddle =
        "01 | 00 00 00 00 00 00 00 00 | 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00";

    std::shared_ptr<ScriptedHid> script = std::make_shared<ScriptedHid>();
    ScriptedPort port{script};
    HidDeviceInfo info;
    PidDriver driver;
};

TEST_F(PidDriverTest, BeginsASessionByteForByte) {
    ASSERT_TRUE(driver.start(info, port));
    const Log expected{
        "w 0c 08", "w 0c 08",  // reset, twice
        "w 0c 04",             // stop all
        "w 0c 01",             // actuators on, after it
        "w 0d ff",             // device gain
        "s 11 08 00 00", "g 12",
        "w 01 01 08 f4 01 00 00 00 00 00 00 ff 00 04 28 23 00 00 00 00 00 00",  // spring on both axes, 500 ms
        "s 11 01 00 00", "g 12",
        "w 01 02 01 f4 01 00 00 00 00 00 00 ff 00 04 00 00 00 00 00 00 00 00",  // constant on Y, from the
                                                                                // north
        "s 11 09 00 00", "g 12",
        "w 01 03 09 f4 01 00 00 00 00 00 00 ff 00 04 28 23 00 00 00 00 00 00",  // damper
        "s 11 0b 00 00", "g 12",
        "w 01 04 0b f4 01 00 00 00 00 00 00 ff 00 04 28 23 00 00 00 00 00 00",  // friction
        // Each starts with no force; 3.3 N of 10 N are the most a spring may give: 0.33 of 32767 is 0x2a3d.
        "w 03 01 00 00 00 00 00 00 00 3d 2a 3d 2a 00 00", "w 03 01 01 00 00 00 00 00 00 3d 2a 3d 2a 00 00",
        "w 0a 01 01 01", "w 05 02 00 00", "w 0a 02 01 01", "w 03 03 00 00 00 00 00 00 00 8f 0a 8f 0a 00 00",
        "w 03 03 01 00 00 00 00 00 00 8f 0a 8f 0a 00 00", "w 0a 03 01 01",
        "w 03 04 00 00 00 00 00 00 00 00 00 00 00 00 00", "w 03 04 01 00 00 00 00 00 00 00 00 00 00 00 00",
        "w 0a 04 01 01"};
    EXPECT_EQ(script->take_sent(), expected);
}

TEST_F(PidDriverTest, ShowsTheClayAsASpringAtItsContactRadius) {
    start();
    // The tool at 60 mm, pushed outwards by 2 N of a wall of 0.1 N/mm: contact at 80 mm, 0.6 of the half
    // travel beyond the middle: 0x4ccc. Stiffness 0.1 N/mm of 50 mm a unit and 10 N: 0.5, before the contact
    // only.
    Log sent = told({.force_n = {2.0, 0.0}, .tool_mm = {60.0, 100.0}, .ticks = 1}, 0);
    ASSERT_FALSE(sent.empty());
    EXPECT_EQ(sent.front(), "w 03 01 00 cc 4c 00 00 00 40 3d 2a 3d 2a 00 00");
    // From inside the pot: the clay lies at larger radii and pushes inwards. Contact at 40 mm: -0.2.
    sent = told({.force_n = {-2.0, 0.0}, .tool_mm = {60.0, 100.0}, .ticks = 2}, 4 * kMs);
    EXPECT_EQ(sent.front(), "w 03 01 00 67 e6 00 40 00 00 3d 2a 3d 2a 00 00");
}

TEST_F(PidDriverTest, ReportsItsOwnWallAndTheAxesSentOverUsb) {
    EXPECT_FALSE(driver.input(0).shows_wall) << "nothing is plugged in";
    start();
    EXPECT_TRUE(driver.input(0).shows_wall);
    const DeviceCapabilities can = driver.capabilities();
    EXPECT_TRUE(can.has_own_walls);
    EXPECT_EQ(can.max_stiffness_n_per_mm, 0.1);
    EXPECT_EQ(can.wire_rate_hz, 250.0) << "its height is always a constant force";
    EXPECT_GT(can.moving_mass_kg, 0.0);
    // A stick of 10 N over 50 mm to either side cannot be stiffer than 0.2 N/mm, whatever is wanted.
    PidMapping weak = measured_stick();
    weak.stiffness_n_per_mm = 0.5;
    EXPECT_EQ(PidDriver(weak).capabilities().max_stiffness_n_per_mm, 0.2);
}

TEST_F(PidDriverTest, PushesUpByAConstantForceAwayFromTheHand) {
    start();
    const Log sent = told({.force_n = {0.0, 1.0}, .tool_mm = {60.0, 100.0}, .ticks = 1}, 0);
    // 0.1 of full scale, against +Y: -3277.
    EXPECT_EQ(sent.front(), "w 05 02 33 f3");
}

TEST_F(PidDriverTest, NeverAsksForMoreThanThePeak) {
    start();
    const Log sent = told({.force_n = {0.0, 100.0}, .tool_mm = {60.0, 100.0}, .ticks = 1}, 0);
    EXPECT_EQ(sent.front(), "w 05 02 c3 d5");  // -0.33 of 32767
}

TEST_F(PidDriverTest, SendsNoReportTwiceOrTooOften) {
    start();
    const ForceOrder order{.force_n = {2.0, 1.0}, .tangential_n = 0.5, .tool_mm = {60.0, 100.0}, .ticks = 1};
    EXPECT_FALSE(told(order, 0).empty());
    EXPECT_TRUE(told(order, 4 * kMs).empty()) << "nothing has changed";
    ForceOrder next = order;
    next.force_n.y = 0.5;
    EXPECT_TRUE(told(next, 6 * kMs).empty()) << "2 ms after the last";
    EXPECT_EQ(told(next, 8 * kMs).size(), 1U);
}

TEST_F(PidDriverTest, StartsItsEffectsAgainBeforeTheyEnd) {
    start();
    const ForceOrder order{.force_n = {0.0, 1.0}, .tool_mm = {60.0, 100.0}, .ticks = 1};
    std::vector<std::int64_t> restarts_ns;
    for (std::int64_t now_ns = 0; now_ns < 2000 * kMs; now_ns += 4 * kMs) {
        const Log sent = told(order, now_ns);
        if (std::find(sent.begin(), sent.end(), "w 0a 02 01 01") != sent.end()) restarts_ns.push_back(now_ns);
    }
    ASSERT_GE(restarts_ns.size(), 9U);
    EXPECT_LE(restarts_ns.front(), 250 * kMs);
    for (std::size_t at = 1; at < restarts_ns.size(); ++at)
        EXPECT_LE(restarts_ns[at] - restarts_ns[at - 1], 250 * kMs) << "each lives for 500 ms";
}

TEST_F(PidDriverTest, LetsGoOfEverythingWhenTheOrderIsZero) {
    start();
    (void)told({.force_n = {2.0, 1.0}, .tangential_n = 1.0, .tool_mm = {60.0, 100.0}, .ticks = 1}, 0);
    const Log sent = told({.tool_mm = {60.0, 100.0}, .ticks = 2}, 4 * kMs);
    const Log expected{
        "w 03 01 00 00 00 00 00 00 00 3d 2a 3d 2a 00 00", "w 05 02 00 00",
        "w 03 03 00 00 00 00 00 00 00 8f 0a 8f 0a 00 00", "w 03 03 01 00 00 00 00 00 00 8f 0a 8f 0a 00 00",
        "w 03 04 00 00 00 00 00 00 00 00 00 00 00 00 00", "w 03 04 01 00 00 00 00 00 00 00 00 00 00 00 00"};
    EXPECT_EQ(sent, expected);
}

TEST_F(PidDriverTest, GivesNoForceWhileItsEmergencyStopIsPressed) {
    start();
    const ForceOrder order{.force_n = {0.0, 1.0}, .tool_mm = {60.0, 100.0}, .ticks = 1};
    EXPECT_EQ(told(order, 0).front(), "w 05 02 33 f3");
    driver.take_report(hex("02 02"), 1 * kMs);  // actuators on, safety switch off
    EXPECT_EQ(told(order, 4 * kMs).front(), "w 05 02 00 00");
    driver.take_report(hex("02 06"), 5 * kMs);
    EXPECT_EQ(told(order, 8 * kMs).front(), "w 05 02 33 f3");
}

TEST_F(PidDriverTest, StopsAllOnceWhenTheLoopIsDeadAndStartsWhenItIsNot) {
    start();
    told({.force_n = {1.0, 0.0}, .tool_mm = {50.0, 100.0}, .ticks = 1}, 0);
    const ForceOrder dead{.tool_mm = {50.0, 100.0}, .ticks = 1, .is_starved = true};
    EXPECT_EQ(told(dead, 100 * kMs), (Log{"w 03 01 00 00 00 00 00 00 00 3d 2a 3d 2a 00 00",
                                          "w 03 03 00 00 00 00 00 00 00 8f 0a 8f 0a 00 00",
                                          "w 03 03 01 00 00 00 00 00 00 8f 0a 8f 0a 00 00", "w 0c 04"}));
    EXPECT_EQ(told(dead, 1000 * kMs), Log{}) << "and starts nothing again";
    EXPECT_EQ(told({.tool_mm = {50.0, 100.0}, .ticks = 2}, 1100 * kMs),
              (Log{"w 0c 01", "w 0a 01 01 01", "w 0a 02 01 01", "w 0a 03 01 01", "w 0a 04 01 01"}));
}

TEST_F(PidDriverTest, StopsFreesAndSwitchesOffAtTheEndDespiteFailures) {
    start();
    driver.stop(port);
    EXPECT_EQ(script->take_sent(), (Log{"w 0c 04", "w 0b 01", "w 0b 02", "w 0b 03", "w 0b 04", "w 0c 02"}));
    script->write_fails = true;
    driver.stop(port);  // must not hang or throw
}

TEST_F(PidDriverTest, PlacesTheToolWhereTheStickIs) {
    start();
    EXPECT_EQ(driver.input(0).place_mm, dvec2(50.0, 100.0));
    driver.take_report(hex("01 | 00 00 00 00 00 00 00 00 | 01 80 ff 7f 00 00 00 00 00 00 00 00 00 00 00 00"),
                       0);
    EXPECT_EQ(driver.input(0).place_mm, dvec2(0.0, 0.0)) << "left and towards the hand: inwards and down";
    EXPECT_TRUE(driver.input(1000 * kMs).is_live);
    EXPECT_FALSE(driver.input(1001 * kMs).is_live);
    EXPECT_EQ(driver.input(0).motion, DeviceInput::Motion::kPlace);
}

TEST_F(PidDriverTest, TurnsTheWheelByItsFirstButton) {
    start();
    const auto press = hex("01 | 01 00 00 00 00 00 00 00 | 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00");
    driver.take_report(press, 0);
    driver.take_report(press, 0);
    EXPECT_TRUE(driver.input(0).button);
    driver.take_report(hex(kStickInTheMiddle), 0);
    EXPECT_TRUE(driver.input(0).button);
    driver.take_report(press, 0);
    EXPECT_FALSE(driver.input(0).button);
}

TEST_F(PidDriverTest, AsksAgainUntilABlockIsReady) {
    script->features[0x12].push_front(hex("12 00 00 00 00"));
    script->features[0x12].push_front(hex("12 00 00 00 00"));
    script->paused_ms = 0;
    ASSERT_TRUE(driver.start(info, port));
    EXPECT_EQ(script->paused_ms, 3 * 10 + 2 * 5);
}

TEST_F(PidDriverTest, GivesUpOnADeviceThatNeverAnswersAndLeavesItStopped) {
    script->features[0x12] = {hex("12 00 00 00 00")};
    const auto started = driver.start(info, port);
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().message, "force feedback: expected a block for effect 0x40, found no answer");
    const Log sent = script->take_sent();
    EXPECT_EQ(sent[sent.size() - 2], "w 0c 04");
    EXPECT_EQ(sent.back(), "w 0c 02");
    EXPECT_LE(script->paused_ms, 100) << "a main thread waits for this when it closes";
}

TEST_F(PidDriverTest, WorksWithoutEffectsThatDoNotFit) {
    script->features[0x12] = {hex("12 01 01 00 01"), hex("12 02 01 00 00"), hex("12 00 02 00 00")};
    ASSERT_TRUE(driver.start(info, port)) << "spring and constant fit; damper and friction do not";
    script->features[0x12] = {hex("12 00 02 00 00")};
    const auto started = driver.start(info, port);
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().message,
              "force feedback: expected room for an effect, found the device's memory full");
}

TEST_F(PidDriverTest, WorksWithoutRefusedReportsUnlessAForceNeedsThem) {
    for (const char* refused : {"0c 08", "0d"}) {  // reset, gain
        script->refused = refused;
        EXPECT_TRUE(driver.start(info, port)) << refused;
    }
    script->refused.clear();
    script->features[0x12] = {hex("12 01 01 00 01"), hex("12 02 01 00 00"), hex("12 00 03 00 00")};
    EXPECT_TRUE(driver.start(info, port)) << "an error instead of a damper";
    script->features[0x12] = {hex("12 01 01 00 01"), hex("12 02 01 00 01")};
    for (const char* refused : {"0c 04", "0c 01", "01", "0a"}) {  // stop all, enable, set effect, start
        script->refused = refused;
        EXPECT_FALSE(driver.start(info, port)) << refused;
    }
}

TEST_F(PidDriverTest, RejectsAnErrorInsteadOfABlock) {
    script->features[0x12] = {hex("12 00 03 00 00")};
    EXPECT_EQ(driver.start(info, port).error().message,
              "force feedback: expected a block for effect 0x40, found an error");
    script->features[0x12] = {hex("12 00 01 00 00")};
    EXPECT_FALSE(driver.start(info, port)) << "block 0 is none";
}

TEST_F(PidDriverTest, PushesByConstantForcesWhereAFirmwareHasNoOneSidedSpring) {
    info.report_descriptor = testing::sparse_descriptor();
    script->features[0x06] = {hex("06 01 01 00 01"), hex("06 02 01 00 01"), hex("06 03 01 00 01"),
                              hex("06 04 01 00 01")};
    ASSERT_TRUE(driver.start(info, port));
    const Log begun = script->take_sent();
    EXPECT_NE(std::find(begun.begin(), begun.end(), "w 01 01 01 f4 01 00 00 00 00 ff 00 04 bf 00"),
              begun.end())
        << "constant on X, from the west";
    EXPECT_NE(std::find(begun.begin(), begun.end(), "w 01 02 01 f4 01 00 00 00 00 ff 00 04 00 00"),
              begun.end())
        << "constant on Y, from the north";
    driver.take_report(hex("01 00 00 00 00 00"), 0);
    EXPECT_FALSE(driver.input(0).shows_wall);
    // 0.2 of 10000 is 0x07d0, outwards.
    EXPECT_EQ(told({.force_n = {2.0, 0.0}, .tool_mm = {60.0, 100.0}, .ticks = 1}, 0).front(),
              "w 05 01 d0 07");
}

// As the firmwares compute it: a constant force comes from its direction, clockwise from the side away from
// the hand (DirectInput's "Effect Direction"; OpenFFBoard's EffectsCalculator, the Arduino library's
// Joystick.cpp). Returns the push along X and Y, as fractions of full scale.
dvec2 push_of(const PidLayout& layout, const Log& begun, const Log& told) {
    const auto read = [&](std::string_view text, PidUsage report, Element element) {
        const std::vector<std::uint8_t> bytes = hex(text.substr(2));
        if (text[0] != 'w' || bytes[0] != layout.place(report).id) return std::optional<std::int64_t>();
        return read_element(std::span(bytes).subspan(1), element);
    };
    const Element direction =
        layout.descriptor().find(ReportKind::kOutput, usage(PidUsage::kDirection), usage(0x0a, 1));
    std::map<std::int64_t, double> turns;  // of each block
    for (const std::string& text : begun) {
        const auto block = read(text, PidUsage::kSetEffect,
                                layout.element(PidUsage::kSetEffect, usage(PidUsage::kBlockIndex)));
        if (!block) continue;
        turns[*block] = static_cast<double>(*read(text, PidUsage::kSetEffect, direction)) /
                        static_cast<double>(direction.field->logical_max);
        for (const Usage axis : {kUsageX, kUsageY}) {
            const Element enable =
                layout.descriptor().find(ReportKind::kOutput, usage(PidUsage::kAxesEnable), axis);
            EXPECT_EQ(read(text, PidUsage::kSetEffect, enable), 0) << "void beside a direction: " << text;
        }
    }
    const Element magnitude = layout.element(PidUsage::kSetConstantForce, usage(PidUsage::kMagnitude));
    dvec2 push{0.0};
    for (const std::string& text : told) {
        const auto force = read(text, PidUsage::kSetConstantForce, magnitude);
        if (!force) continue;
        const auto block = read(text, PidUsage::kSetConstantForce,
                                layout.element(PidUsage::kSetConstantForce, usage(PidUsage::kBlockIndex)));
        const double angle = 2.0 * std::numbers::pi * turns.at(block.value_or(0));
        push += static_cast<double>(*force) / static_cast<double>(magnitude.field->logical_max) *
                dvec2(-std::sin(angle), std::cos(angle));
    }
    return push;
}

TEST_F(PidDriverTest, PushesTheStickWhereTheForceGoesOnEachFirmware) {
    std::vector<std::vector<std::uint8_t>> descriptors{
        testing::open_ffboard_descriptor(), testing::rhino_descriptor(), testing::sparse_descriptor()};
    for (const char* firmware :
         {"adapt-ffb-joy", "ArduinoJoystickWithFFBLibrary, two axes", "DsHidMini, DualShock 3 as one device"})
        descriptors.push_back(testing::public_device(firmware).info.report_descriptor);
    for (const std::vector<std::uint8_t>& bytes : descriptors) {
        info.report_descriptor = bytes;
        const auto layout = PidLayout::find(ReportDescriptor::parse(bytes).value());
        ASSERT_TRUE(layout) << layout.error().message;
        const std::uint8_t load = layout->place(PidUsage::kBlockLoad).id;
        script->features[load].clear();
        for (std::uint8_t block = 1; block <= 4; ++block)
            script->features[load].push_back({load, block, 1, 0, 1});
        ASSERT_TRUE(driver.start(info, port));
        const Log begun = script->take_sent();
        // 2 N of 10 outwards and 1 N up, which is away from the hand: -Y.
        const dvec2 push =
            push_of(*layout, begun, told({.force_n = {2.0, 1.0}, .tool_mm = {60.0, 100.0}, .ticks = 1}, 0));
        EXPECT_NEAR(push.x, driver.input(0).shows_wall ? 0.0 : 0.2, 0.005) << "a wall is a spring";
        EXPECT_NEAR(push.y, -0.1, 0.005);
    }
}

TEST_F(PidDriverTest, RejectsADeviceWithoutForces) {
    info.report_descriptor = hex("05 01 09 04 a1 01 85 01 09 30 09 31 15 00 26 e8 03 75 10 95 02 81 02 c0");
    EXPECT_FALSE(driver.start(info, port));
    EXPECT_TRUE(script->take_sent().empty()) << "nothing is said to a device that is not understood";
}

TEST_F(PidDriverTest, IsStoppedByLetGoOfAll) {
    info.kind = HidKind::kForceJoystick;
    script->info = info;
    ScriptedBus bus(script);
    const int ports_before = script->open_ports;
    EXPECT_EQ(let_go_of_all(bus), 1);
    const Log sent = script->take_sent();
    ASSERT_GE(sent.size(), 6U);
    EXPECT_EQ(sent.front(), "w 0c 08");                                       // reset
    EXPECT_NE(std::find(sent.end() - 6, sent.end(), "w 0c 04"), sent.end());  // stop all, in the end too
    EXPECT_EQ(sent.back(), "w 0c 02");                                        // actuators off
    EXPECT_EQ(script->open_ports, ports_before);
    script->info.refusal = "no permission";
    EXPECT_EQ(let_go_of_all(bus), 0);
}

}  // namespace
}  // namespace onggi::haptics::hid
