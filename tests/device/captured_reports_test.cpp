// Reports captured from real devices, decoded through the real hidapi.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "engine/haptics/hid/dual_sense.h"
#include "engine/haptics/hid/hidapi_bus.h"
#include "engine/haptics/hid/simple_drivers.h"
#include "tests/device/mock_devices.h"
#include "tests/device/mock_hid.h"
#include "tests/support/patience.h"

namespace onggi::haptics::hid {
namespace {

using testing::HidScript;
using testing::kDualSense;
using testing::kPedal;
using testing::kSpaceMouse;
using testing::MockBus;
using testing::MockHid;

// A mock's reports are one stream of bytes (findings/umockdev-joins-hidraw-reports-and-never-hangs-up.sh):
// two pending reports would be read as one, and reports sent before the device is opened are repeated. So
// each report waits until it is requested.
constexpr std::array<std::uint8_t, 1> kAsked{0xff};

void add_report(HidScript& script, const std::string& report) {
    script.expects("ff").reports(report, 5);
}

// Opens the only device on the bus and reads its reports one by one.
class Heard {
  public:
    Heard(const MockHid& device, const HidScript& script) {
        bus_.plug_in(device, script);
        const auto real = make_hidapi_bus();
        const auto devices = real->list();
        if (!devices || devices->size() != 1) {
            ADD_FAILURE() << "one device was expected";
            return;
        }
        auto port = real->open(devices->front());
        EXPECT_TRUE(port) << port.error().message;
        if (port) port_ = std::move(port).value();
    }

    // Waits up to ten seconds, longer on a slow machine; empty after a timeout.
    [[nodiscard]] std::span<const std::uint8_t> next() {
        if (!port_) return {};
        EXPECT_TRUE(port_->write(kAsked));
        const auto size =
            port_->read(bytes_, static_cast<int>(test::scaled(std::chrono::seconds(10)).count()));
        EXPECT_TRUE(size);
        return std::span(bytes_).first(size ? *size : 0);
    }

  private:
    MockBus bus_;
    std::unique_ptr<HidPort> port_;
    std::array<std::uint8_t, kMaxReportBytes> bytes_{};
};

using Axes = std::array<std::int16_t, 3>;

struct Pushed {
    std::string report;
    Axes translation;
    Axes rotation;
    std::uint32_t buttons = 0;
};

void expect_pushes(const MockHid& device, const std::vector<Pushed>& pushes) {
    HidScript script;
    for (const Pushed& push : pushes)
        add_report(script, push.report);
    Heard heard(device, script);
    SpaceMouseState state;
    for (const Pushed& push : pushes) {
        EXPECT_TRUE(take_space_mouse_report(heard.next(), state)) << push.report;
        EXPECT_EQ(state.translation, push.translation) << push.report;
        EXPECT_EQ(state.rotation, push.rotation) << push.report;
        EXPECT_EQ(state.buttons, push.buttons) << push.report;
    }
}

TEST(CapturedReports, OfASpaceMouseCompactSayHowItWasPushed) {
    expect_pushes(kSpaceMouse, {{"02 20 00 00 00 17 00", {0, 0, 0}, {32, 0, 23}},
                                {"01 12 00 00 00 f8 00", {18, 0, 248}, {32, 0, 23}},
                                {"02 20 00 00 00 19 00", {18, 0, 248}, {32, 0, 25}},
                                {"01 12 00 00 00 12 01", {18, 0, 274}, {32, 0, 25}},
                                {"02 1d 00 00 00 1b 00", {18, 0, 274}, {29, 0, 27}},
                                {"01 0d 00 00 00 25 01", {13, 0, 293}, {29, 0, 27}}});
}

TEST(CapturedReports, OfASpaceNavigatorSayHowItWasTurnedAndPressed) {
    MockHid navigator = kSpaceMouse;
    navigator.vendor_id = 0x046d;
    navigator.product_id = 0xc626;
    expect_pushes(navigator, {{"01 00 00 00 00 00 00", {0, 0, 0}, {0, 0, 0}},
                              {"02 00 00 e2 ff 00 00", {0, 0, 0}, {0, -30, 0}},
                              {"03 01 00", {0, 0, 0}, {0, -30, 0}, 1},
                              {"03 02 00", {0, 0, 0}, {0, -30, 0}, 2},
                              {"03 03 00", {0, 0, 0}, {0, -30, 0}, 3},
                              {"03 00 00", {0, 0, 0}, {0, -30, 0}, 0}});
}

// Not a capture: the layout of a SpaceMouse Wireless with the numbers of the one above.
TEST(CapturedReports, OfAWirelessSpaceMouseHoldBothInOne) {
    MockHid wireless = kSpaceMouse;
    wireless.product_id = 0xc62e;
    expect_pushes(wireless, {{"01 12 00 00 00 12 01 20 00 00 00 19 00", {18, 0, 274}, {32, 0, 25}}});
}

TEST(CapturedReports, OfAFootPedalSayWhichAreDown) {
    struct Trodden {
        std::string report;
        bool left, middle, right;
    };
    const std::vector<Trodden> pedals{{"01 00", true, false, false}, {"02 00", false, true, false},
                                      {"03 00", true, true, false},  {"04 00", false, false, true},
                                      {"07 00", true, true, true},   {"00 00", false, false, false}};
    HidScript script;
    for (const Trodden& pedal : pedals)
        add_report(script, pedal.report);
    Heard heard(kPedal, script);
    for (const Trodden& pedal : pedals) {
        const auto state = vec_pedal_state(heard.next());
        ASSERT_TRUE(state) << pedal.report;
        EXPECT_EQ(state->left, pedal.left) << pedal.report;
        EXPECT_EQ(state->middle, pedal.middle) << pedal.report;
        EXPECT_EQ(state->right, pedal.right) << pedal.report;
    }
}

// Field values of a ViGEm DualSense sample, at the offsets of the table.
TEST(CapturedReports, OfADualSenseContainItsSensors) {
    const std::string zeros = " 00 00 00 00";
    const std::string report = "01 80 80 80 80 00 ff 00 08 00 00 00" + zeros +           // to byte 15
                               " 6b 00 07 00 04 00 39 01 bc 25 57 eb 84 ff 6b 01 07" +   // to 32
                               " 80 00 00 00 80 00 00 00 00 09 09" + zeros + " 00 00" +  // to 49
                               " 00 00 00 29 08" + zeros + zeros + " 00";
    HidScript script;
    add_report(script, report);
    Heard heard(kDualSense, script);
    const auto state = dual_sense_state(heard.next());
    ASSERT_TRUE(state);
    EXPECT_EQ(state->gyro, (Axes{0x6b, 0x07, 0x04}));
    EXPECT_EQ(state->accel, (Axes{313, 9660, -5289}));
    EXPECT_EQ(state->sensor_time, 0x016bff84U);
    EXPECT_EQ(state->right_trigger, 0xff);
    EXPECT_EQ(state->right_trigger_zone, 9);
    EXPECT_EQ(state->left_trigger_zone, 9);
    EXPECT_FALSE(state->touches[0].touching);
    EXPECT_EQ(state->battery_percent, 90);
    EXPECT_EQ(state->charging, 2);
}

}  // namespace
}  // namespace onggi::haptics::hid
