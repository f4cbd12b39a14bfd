// The driver of a device, and the message about a device without one.
#include "engine/haptics/hid/hid_kind.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/hex.h"
#include "tests/support/pid_descriptors.h"
#include "tests/support/places.h"

namespace onggi::haptics::hid {
namespace {

HidDeviceInfo recognised(HidDeviceInfo device) {
    recognise(device);
    return device;
}
HidDeviceInfo device(std::uint16_t vendor_id, std::uint16_t product_id) {
    return {.vendor_id = vendor_id, .product_id = product_id, .may_open = true, .bus = HidBusType::kUsb};
}

TEST(HidKind, KnowsDevicesByTheirNumbers) {
    EXPECT_EQ(recognised(device(0x256f, 0xc635)).kind, HidKind::kSpaceMouse);
    EXPECT_EQ(recognised(device(0x046d, 0xc626)).kind, HidKind::kSpaceMouse);
    EXPECT_EQ(recognised(device(0x054c, 0x0ce6)).kind, HidKind::kDualSense);
    EXPECT_EQ(recognised(device(0x054c, 0x0df2)).kind, HidKind::kDualSense);
    EXPECT_EQ(recognised(device(0x05f3, 0x00ff)).kind, HidKind::kVecPedal);
    for (const auto& known : {device(0x256f, 0xc635), device(0x054c, 0x0ce6), device(0x05f3, 0x00ff)}) {
        EXPECT_EQ(recognised(known).refusal, "");
        EXPECT_NE(recognised(known).can, "");
    }
}

TEST(HidKind, KnowsForceJoysticksOfAnyMakerByTheirDescriptor) {
    HidDeviceInfo stick = device(0x1234, 0x5678);
    stick.report_descriptor = testing::open_ffboard_descriptor();
    EXPECT_EQ(recognised(stick).kind, HidKind::kForceJoystick);
    EXPECT_EQ(recognised(stick).refusal, "");
    stick.report_descriptor = testing::rhino_descriptor();
    EXPECT_EQ(recognised(stick).kind, HidKind::kForceJoystick);
}

TEST(HidKind, RecognisesANewerSpaceMouseByItsDescriptor) {
    HidDeviceInfo mouse = device(0x256f, 0xc6ff);
    mouse.report_descriptor = testing::hex("05 01 09 08 a1 01 c0");
    EXPECT_EQ(recognised(mouse).kind, HidKind::kSpaceMouse);
    mouse.product_id = 0xc650;  // a CadMouse
    EXPECT_EQ(recognised(mouse).kind, HidKind::kUnknown);
    mouse = device(0x046d, 0xc077);  // an ordinary mouse of the vendor that sold the first SpaceMice
    mouse.report_descriptor = testing::hex("05 01 09 02 a1 01 c0");
    EXPECT_EQ(recognised(mouse).kind, HidKind::kUnknown);
    EXPECT_EQ(recognised(mouse).refusal, "no driver here knows it");
    EXPECT_EQ(recognised(mouse).can, "");
}

// A receiver shows several interfaces under one pair of numbers: a mouse's, a keyboard's and the one with the
// axes.
TEST(HidKind, TakesOfSeveralInterfacesTheOneThatHasTheAxes) {
    const auto mouse = testing::hex(
        "05 01 09 02 a1 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 75 01 95 03 81 02 75 05 95 01 "
        "81 01 05 01 09 30 09 31 15 81 25 7f 75 08 95 02 81 06 c0 c0");
    const auto keyboard =
        testing::hex("05 01 09 06 a1 01 05 07 19 e0 29 e7 15 00 25 01 75 01 95 08 81 02 c0");
    const auto axes = testing::hex(
        "05 01 09 08 a1 01 a1 00 85 01 16 a2 fe 26 5e 01 09 30 09 31 09 32 75 10 95 03 81 06 c0 c0");
    const auto unnamed_axes =
        testing::hex("05 01 09 04 a1 01 85 01 16 a2 fe 26 5e 01 09 30 09 31 09 32 75 10 95 03 81 06 c0");
    for (HidDeviceInfo receiver : {device(0x256f, 0xc652), device(0x046d, 0xc626), device(0x256f, 0xc62f)}) {
        for (const auto& other : {mouse, keyboard}) {
            receiver.report_descriptor = other;
            EXPECT_EQ(recognised(receiver).kind, HidKind::kUnknown);
        }
        for (const auto& right : {axes, unnamed_axes, std::vector<std::uint8_t>()}) {
            receiver.report_descriptor = right;
            EXPECT_EQ(recognised(receiver).kind, HidKind::kSpaceMouse);
        }
    }
    for (HidDeviceInfo other : {device(0x054c, 0x0ce6), device(0x346e, 0x1000)}) {
        other.report_descriptor = keyboard;
        EXPECT_EQ(recognised(other).kind, HidKind::kUnknown);
    }
}

TEST(HidKind, StatesTheReasonAndRemedyOfARefusal) {
    HidDeviceInfo mouse = device(0x256f, 0xc635);
    mouse.may_open = false;
    EXPECT_EQ(recognised(mouse).refusal, "may not be opened by this user");
    EXPECT_EQ(recognised(mouse).remedy,
              "put this line into /etc/udev/rules.d/70-onggi.rules and plug it in again: "
              "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"256f\", ATTRS{idProduct}==\"c635\", "
              "MODE=\"0660\", GROUP=\"plugdev\", TAG+=\"uaccess\"");
    HidDeviceInfo pad = device(0x054c, 0x0ce6);
    pad.bus = HidBusType::kBluetooth;
    EXPECT_EQ(recognised(pad).refusal, "");
    pad.may_open = false;
    EXPECT_EQ(recognised(pad).remedy,
              "put this line into /etc/udev/rules.d/70-onggi.rules and connect it again: "
              "KERNEL==\"hidraw*\", KERNELS==\"0005:054C:0CE6.*\", MODE=\"0660\", GROUP=\"plugdev\", "
              "TAG+=\"uaccess\"");
    HidDeviceInfo broken = device(0x1209, 0xffb0);
    broken.report_descriptor = testing::hex("05 0f 26 ff");
    EXPECT_EQ(recognised(broken).kind, HidKind::kForceJoystick);
    EXPECT_EQ(recognised(broken).refusal, "report descriptor: byte 2: expected a whole item, found the end");
    HidDeviceInfo wheel_only = device(0x1209, 0xffb0);
    wheel_only.report_descriptor = testing::hex("05 01 09 04 a1 01 85 01 c0");
    EXPECT_EQ(recognised(wheel_only).refusal,
              "force feedback (USB PID 1.0): expected the effect type of Create New Effect, found none");
}

TEST(UdevRules, OpenEveryKnownDeviceAndNoWholeVendor) {
    std::ifstream file(test::in_checkout("assets/udev/70-onggi.rules"));
    ASSERT_TRUE(file) << "assets/udev/70-onggi.rules";
    std::vector<std::string> rules;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("KERNEL==\"hidraw*\"")) rules.push_back(line);
    }
    const auto has = [&](const std::string& rule) {
        return std::find(rules.begin(), rules.end(), rule) != rules.end();
    };
    std::size_t by_radio = 0;
    for (const KnownDevice& known : known_devices()) {
        EXPECT_TRUE(has(udev_rule(known.vendor_id, known.product_id)))
            << udev_rule(known.vendor_id, known.product_id);
        if (known.kind != HidKind::kDualSense) continue;
        ++by_radio;
        EXPECT_TRUE(has(bluetooth_rule(known.vendor_id, known.product_id)))
            << bluetooth_rule(known.vendor_id, known.product_id);
    }
    EXPECT_EQ(rules.size(), known_devices().size() + by_radio);
}

}  // namespace
}  // namespace onggi::haptics::hid
