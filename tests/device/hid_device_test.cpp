// HID devices end to end: the real libhidapi-hidraw and libudev, our I/O thread and drivers, and devices that
// umockdev describes. A write that differs from its script ends the program. Never on hardware.
#include "engine/haptics/hid/hid_device.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <utility>

#include "tests/device/mock_devices.h"
#include "tests/device/mock_hid.h"
#include "tests/support/comes_true.h"

namespace onggi::haptics {
namespace {

using test::comes_true;
using testing::HidScript;
using testing::kDualSense;
using testing::kJoystick;
using testing::kPedal;
using testing::kSpaceMouse;
using testing::MockBus;
using testing::MockHid;

std::unique_ptr<HidDevice> opened(HidKind kind) {
    auto device = make_hid_device({.kind = kind});
    EXPECT_TRUE(device->open());
    return device;
}

TEST(HidList, StatesTheAbilityOrRefusalOfEachDevice) {
    MockBus bus;
    MockHid bluetooth = kDualSense;
    bluetooth.node = 9;
    bluetooth.is_bluetooth = true;
    MockHid keyboard = kPedal;
    keyboard.node = 10;
    keyboard.vendor_id = 0x0c45;
    keyboard.product_id = 0x7403;
    for (const MockHid& device : {kSpaceMouse, kPedal, kDualSense, kJoystick, bluetooth, keyboard})
        bus.plug_in(device);
    const auto devices = list_hid_devices();
    ASSERT_TRUE(devices) << devices.error().message;
    ASSERT_EQ(devices->size(), 6U) << "one entry a device, whatever the number of its usages";
    const auto find = [&](const MockHid& wanted) {
        for (const HidDeviceInfo& device : *devices)
            if (device.path == wanted.path()) return device;
        ADD_FAILURE() << wanted.path();
        return HidDeviceInfo{};
    };
    EXPECT_EQ(find(kSpaceMouse).kind, HidKind::kSpaceMouse);
    EXPECT_EQ(find(kSpaceMouse).name, "3Dconnexion SpaceMouse Compact");
    EXPECT_EQ(find(kPedal).kind, HidKind::kVecPedal);
    EXPECT_EQ(find(kDualSense).kind, HidKind::kDualSense);
    EXPECT_EQ(find(kJoystick).kind, HidKind::kForceJoystick);
    EXPECT_EQ(find(kJoystick).report_descriptor, kJoystick.descriptor);
    for (const MockHid& device : {kSpaceMouse, kPedal, kDualSense, kJoystick}) {
        EXPECT_EQ(find(device).refusal, "");
        EXPECT_NE(find(device).can, "");
        EXPECT_TRUE(find(device).may_open);
    }
    EXPECT_EQ(find(bluetooth).bus, HidBusType::kBluetooth);
    EXPECT_EQ(find(bluetooth).refusal, "");
    EXPECT_EQ(find(keyboard).refusal, "no driver here knows it");
}

TEST(HidList, IsEmptyWithoutDevices) {
    MockBus bus;
    const auto devices = list_hid_devices();
    ASSERT_TRUE(devices);
    EXPECT_TRUE(devices->empty());
}

TEST(SpaceMouseOnTheBus, LightsItsLampAndMovesTheToolByCapturedReports) {
    MockBus bus;
    // Captured from a SpaceMouse Compact; the script ends pushed down, X 13, Z 293.
    bus.plug_in(kSpaceMouse, HidScript()
                                 .expects("04 01")
                                 .reports("03 01 00", 20)
                                 .reports("03 00 00", 40)
                                 .reports("02 20 00 00 00 17 00", 40)
                                 .reports("01 12 00 00 00 f8 00", 40)
                                 .reports("02 20 00 00 00 19 00", 40)
                                 .reports("01 12 00 00 00 12 01", 40)
                                 .reports("02 1d 00 00 00 1b 00", 40)
                                 .reports("01 0d 00 00 00 25 01", 40));
    const auto device = opened(HidKind::kSpaceMouse);
    std::uint64_t tick = 0;
    const HandSample start = device->read(tick++, 0.001);
    HandSample tool = start;
    bool wheel_turned = false;
    EXPECT_TRUE(comes_true([&] {
        tool = device->read(tick++, 0.001);
        wheel_turned = wheel_turned || tool.button;
        return wheel_turned && tool.position_mm.y < start.position_mm.y;
    })) << device->status().message;
    EXPECT_TRUE(wheel_turned);
    // Silent while pushed: the axis counts as let go, the wheel stands.
    EXPECT_TRUE(comes_true([&] { return !device->read(tick++, 0.001).button; }));
    const HandSample rest = device->read(tick++, 0.001);
    EXPECT_EQ(device->read(tick++, 0.001).position_mm, rest.position_mm);
    EXPECT_EQ(device->status().state, hid::HidStatus::State::kReady);
    EXPECT_EQ(device->status().name, "3Dconnexion SpaceMouse Compact");
}

TEST(PedalOnTheBus, IsReadWithoutReportNumbers) {
    MockBus bus;
    bus.plug_in(kPedal, HidScript().reports("02 00", 20).reports("00 00", 400));
    const auto device = opened(HidKind::kVecPedal);
    std::uint64_t tick = 0;
    EXPECT_TRUE(comes_true([&] { return device->read(tick++, 0.0).button; }));
    EXPECT_TRUE(comes_true([&] { return !device->read(tick++, 0.0).button; }));
}

TEST(DualSenseOnTheBus, IsToldToBeStillAndRead) {
    MockBus bus;
    const std::string loose = "05 00 00 00 00 00 00 00 00 00 00";
    std::string middle = "01 80 80 80 80 00 ff 00 08";
    for (int byte = 9; byte < 64; ++byte)
        middle += " 00";
    HidScript script;
    script.expects("02 0f 04 00 00 00 00 00 00 00 00 " + loose + " " + loose +
                   " 00 00 00 00 00 00 02 00 00 02 00 00 00 10 40");
    script.expects("02 07 04 00 00 00 00 00 00 00 00 " + loose +
                   " 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 10 40");
    for (int count = 0; count < 50; ++count)
        script.reports(middle, 4);
    bus.plug_in(kDualSense, script);
    const auto device = opened(HidKind::kDualSense);
    std::uint64_t tick = 0;
    const double start_mm = device->read(tick++, 0.001).position_mm.x;
    // The trigger fully pulled: pressed in by up to 20 mm.
    EXPECT_TRUE(comes_true([&] { return device->read(tick++, 0.001).position_mm.x < start_mm - 5.0; }));
}

// The first reports to an OpenFFBoard (the driver's unit test explains each), with the answers to feature
// requests.
HidScript joystick_script() {
    HidScript script = testing::joystick_features();
    for (const char* report : {"0c 08", "0c 08", "0c 04", "0c 01", "0d ff",
                               "01 01 08 f4 01 00 00 00 00 00 00 ff 00 04 28 23 00 00 00 00 00 00",
                               "01 02 01 f4 01 00 00 00 00 00 00 ff 00 04 00 00 00 00 00 00 00 00",
                               "01 03 09 f4 01 00 00 00 00 00 00 ff 00 04 28 23 00 00 00 00 00 00",
                               "01 04 0b f4 01 00 00 00 00 00 00 ff 00 04 28 23 00 00 00 00 00 00"})
        script.expects(report);
    // No force yet; 3.3 N of an unmeasured stick's 50 N are 0.066 of 32767: 0x0873; the damper's quarter
    // 0x021d.
    for (const char* report :
         {"03 01 00 00 00 00 00 00 00 73 08 73 08 00 00", "03 01 01 00 00 00 00 00 00 73 08 73 08 00 00",
          "0a 01 01 01", "05 02 00 00", "0a 02 01 01", "03 03 00 00 00 00 00 00 00 1d 02 1d 02 00 00",
          "03 03 01 00 00 00 00 00 00 1d 02 1d 02 00 00", "0a 03 01 01",
          "03 04 00 00 00 00 00 00 00 00 00 00 00 00 00", "03 04 01 00 00 00 00 00 00 00 00 00 00 00 00",
          "0a 04 01 01"})
        script.expects(report);
    return script.reports("01 | 00 00 00 00 00 00 00 00 | 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00",
                          10);
}

TEST(JoystickOnTheBus, HoldsItsSessionByteForByteThenPlacesTheTool) {
    MockBus bus;
    bus.plug_in(kJoystick, joystick_script());
    const auto device = opened(HidKind::kForceJoystick);
    std::uint64_t tick = 0;
    // The report comes only after all expected writes; a centred stick is the middle of the reach.
    EXPECT_TRUE(comes_true([&] {
        return device->read(tick++, 0.001).position_mm == dvec3(75.0, 125.0, 0.0);
    })) << device->status().message;
    EXPECT_EQ(device->status().state, hid::HidStatus::State::kReady);
}

TEST(JoystickOnTheBus, OfTheOtherLayoutHoldsItsSessionByteForByteToo) {
    MockBus bus;
    HidScript script;
    // Its controls are array values: 4 reset, 3 stop, 2 enable. Gains up to 4096, directions up to 255, the
    // start delay last.
    for (const char* report :
         {"70 04", "70 04", "70 03", "70 02", "71 00 10",
          "65 01 08 f4 01 00 00 00 00 00 10 00 04 40 00 00 00",
          "65 02 01 f4 01 00 00 00 00 00 10 00 04 00 00 00 00",
          "65 03 09 f4 01 00 00 00 00 00 10 00 04 40 00 00 00",
          "65 04 0b f4 01 00 00 00 00 00 10 00 04 40 00 00 00",
          // 0.066 of 4096: 0x010e; the damper's quarter 0x0044.
          "67 01 00 00 00 00 00 00 00 0e 01 0e 01 00 00", "67 01 01 00 00 00 00 00 00 0e 01 0e 01 00 00",
          "6e 01 01 01", "69 02 00 00", "6e 02 01 01", "67 03 00 00 00 00 00 00 00 44 00 44 00 00 00",
          "67 03 01 00 00 00 00 00 00 44 00 44 00 00 00", "6e 03 01 01",
          "67 04 00 00 00 00 00 00 00 00 00 00 00 00 00", "67 04 01 00 00 00 00 00 00 00 00 00 00 00 00",
          "6e 04 01 01"})
        script.expects(report);
    script.sets_feature("05 08 00 00").answers_feature("06 01 01 00 00");
    script.sets_feature("05 01 00 00").answers_feature("06 02 01 00 00");
    script.sets_feature("05 09 00 00").answers_feature("06 03 01 00 00");
    script.sets_feature("05 0b 00 00").answers_feature("06 04 01 00 00");
    // X 2048 of 4096: three quarters of 150 mm; Y 1024 towards the hand: three eighths of 250 mm.
    script.reports("01 00 08 00 04 00 00", 10);
    bus.plug_in(testing::kRhino, script);
    const auto device = opened(HidKind::kForceJoystick);
    std::uint64_t tick = 0;
    EXPECT_TRUE(comes_true([&] {
        return device->read(tick++, 0.001).position_mm == dvec3(112.5, 93.75, 0.0);
    })) << device->status().message;
    EXPECT_EQ(device->status().state, hid::HidStatus::State::kReady);
}

TEST(JoystickOnTheBus, IsStoppedATenthOfASecondAfterTheLastOrderAndStartedByTheNext) {
    using Clock = std::chrono::steady_clock;
    MockBus bus;
    bus.plug_in(kJoystick, testing::joystick_features());
    const testing::LiveHid stick = bus.at(kJoystick);
    const auto device = opened(HidKind::kForceJoystick);
    ASSERT_TRUE(comes_true([&] { return device->status().state == hid::HidStatus::State::kReady; }))
        << device->status().message;
    stick.take_written();
    std::uint64_t tick = 0;
    Clock::time_point last_order = Clock::now();
    Clock::time_point order_before;
    std::string written;
    const auto tick_once = [&] {
        (void)device->read(tick++, 0.001);
        order_before = std::exchange(last_order, Clock::now());
        device->write({});
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        written += stick.take_written();
    };
    const auto is_told = [&](std::string_view report) {
        written += stick.take_written();
        return written.find(report) != std::string::npos;
    };
    const auto ms_since = [](Clock::time_point order) {
        return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - order).count();
    };
    constexpr std::string_view kStopAll = "0c04";
    // A busy machine may delay the orders themselves by a tenth of a second; then a stop is correct.
    for (int count = 0; count < 300; ++count) {
        tick_once();
        if (is_told(kStopAll)) {
            EXPECT_GE(ms_since(order_before), 100) << "while orders come: " << written;
        }
        written.clear();
    }
    ASSERT_TRUE(comes_true([&] {
        written.clear();
        tick_once();
        return !is_told(kStopAll);
    })) << "each order came too late";
    ASSERT_TRUE(comes_true([&] { return is_told(kStopAll); })) << written;
    EXPECT_GE(ms_since(order_before), 100);
    EXPECT_LE(ms_since(last_order), 1000 * test::slowness())
        << "a tenth of a second, on a machine that is busy with other things";
    written.clear();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_EQ(stick.take_written(), "") << "stopped once, nothing is started again";
    // Actuators first, then each effect.
    EXPECT_TRUE(comes_true([&] {
        tick_once();
        return is_told("0c010a0101010a0201010a0301010a040101");
    })) << written;
}

TEST(JoystickOnTheBus, IsReportedWhenItDoesNotAnswer) {
    MockBus bus;
    bus.plug_in(kJoystick);  // no feature answers
    const auto device = opened(HidKind::kForceJoystick);
    EXPECT_TRUE(comes_true([&] { return device->status().state == hid::HidStatus::State::kFailed; }));
    EXPECT_NE(device->status().message.find("/dev/hidraw8: expected to set a feature of the device"),
              std::string::npos)
        << device->status().message;
}

TEST(AnyDeviceOnTheBus, IsLostWhenPulledOutAndFoundWhenPluggedInAgain) {
    MockBus bus;
    bus.plug_in(kPedal);
    const auto device = opened(HidKind::kVecPedal);
    const auto is = [&](hid::HidStatus::State state) {
        return [&device, state] { return device->status().state == state; };
    };
    ASSERT_TRUE(comes_true(is(hid::HidStatus::State::kReady)));
    bus.pull_out(kPedal);
    EXPECT_TRUE(comes_true(is(hid::HidStatus::State::kAbsent)));
    MockHid again = kPedal;
    again.node = 12;  // the kernel may give it a new number
    bus.plug_in(again);
    EXPECT_TRUE(comes_true(is(hid::HidStatus::State::kReady)));
    EXPECT_EQ(device->status().path, "/dev/hidraw12");
    EXPECT_EQ(device->status().times_found, 2U);
}

}  // namespace
}  // namespace onggi::haptics
