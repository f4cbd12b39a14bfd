// The program with HID devices: the real `onggi`, hidapi and libudev, on devices that umockdev describes.
// Never on hardware.
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/cli/run_program.h"
#include "tests/device/mock_devices.h"
#include "tests/device/mock_hid.h"
#include "tests/support/hostile_system.h"

namespace onggi {
namespace {

using testing::kDualSense;
using testing::kJoystick;
using testing::kPedal;
using testing::kSpaceMouse;
using testing::MockBus;
using testing::MockHid;

// In the child before exec: a network of its own, so that no other process can listen at the port of an
// Inverse3's service. If the system refuses that, the machine's network is used.
void alone_on_the_network() {
    static_cast<void>(test::enter_own_network());
}

TEST(DevicesCommand, StatesTheAbilityOfEachDevice) {
    MockBus bus;
    MockHid keyboard = kPedal;
    keyboard.node = 10;
    keyboard.vendor_id = 0x0c45;
    keyboard.product_id = 0x7403;
    keyboard.product = "Keyboard";
    for (const MockHid& device : {kSpaceMouse, kPedal, kDualSense, kJoystick, keyboard})
        bus.plug_in(device);
    const test::ProgramRun run = test::run_onggi({"devices"}, {.in_child = alone_on_the_network});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    for (const char* line :
         {"good     device  simulated tool: mouse or touch, always available; the tool lags behind\n",
          "good     device  /dev/hidraw5 256f:c635 3Dconnexion SpaceMouse Compact: SpaceMouse; moves the "
          "tool in "
          "radius and height; no force; button 1 starts and stops the wheel, a twist changes its speed\n",
          "good     device  /dev/hidraw6 05f3:00ff VEC Footpedal: foot pedal; turns the wheel while a pedal "
          "is "
          "down, faster by the right one, slower by the left\n",
          "good     device  /dev/hidraw7 054c:0ce6 Sony DualSense Wireless Controller: DualSense; moves the "
          "tool by stick, touch pad or tilt; "
          "its right trigger presses into the work and pushes back\n",
          "good     device  /dev/hidraw8 1209:ffb0 Testing FFB stick: force-feedback joystick; moves the "
          "tool in "
          "radius and height and pushes back in both\n",
          "note     device  Haply Inverse3: looked for at 127.0.0.1:10001 while the wheel runs;",
          "note     device  /dev/hidraw10 0c45:7403 VEC Keyboard: no driver here knows it\n"}) {
        EXPECT_NE(run.out.find(line), std::string::npos) << line << "found:\n" << run.out;
    }
}

// In the child before exec: a listening socket on the Inverse3 service's port. The program inherits the
// socket, and the kernel queues connections there.
void listen_as_the_inverse_service() {
    alone_on_the_network();
    const int listening = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(10001);
    const int yes = 1;
    ::setsockopt(listening, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    if (::bind(listening, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        ::listen(listening, 4) != 0)
        ::_exit(126);
}

TEST(DevicesCommand, SaysWhetherTheServiceOfAnInverseListens) {
    const MockBus bus;
    {
        const test::ProgramRun run =
            test::run_onggi({"devices"}, {.in_child = listen_as_the_inverse_service});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        EXPECT_NE(
            run.out.find("good     device  Haply Inverse3: its service is found at 127.0.0.1:10001; moves "
                         "the tool in three axes and pushes back in all of them once the device is "
                         "plugged in\n"),
            std::string::npos)
            << run.out;
    }
    const test::ProgramRun run = test::run_onggi({"devices"}, {.in_child = alone_on_the_network});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(
        run.out.find("note     device  Haply Inverse3: looked for at 127.0.0.1:10001 while the wheel runs; "
                     "not found now: nothing listens at 127.0.0.1:10001; its maker's service must be "
                     "installed and run\n"),
        std::string::npos)
        << run.out;
}

TEST(DevicesCommand, PrintsTheUdevRuleForADeviceThatMayNotBeOpened) {
    MockBus bus;
    bus.plug_in(kSpaceMouse);
    bus.forbid(kSpaceMouse);
    const test::ProgramRun run =
        test::run_onggi({"devices"}, {.in_child = test::bind_permissions_across_exec});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const std::string expected =
        "lacking  device  /dev/hidraw5 256f:c635 3Dconnexion SpaceMouse Compact: SpaceMouse; may not be "
        "opened by "
        "this user\n"
        "                 costs: it is not used; it moves the tool in radius and height; no force; button 1 "
        "starts "
        "and stops the wheel, a twist changes its speed\n"
        "                 mend: put this line into /etc/udev/rules.d/70-onggi.rules and plug it in again: "
        "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"256f\", ATTRS{idProduct}==\"c635\", MODE=\"0660\", "
        "GROUP=\"plugdev\", TAG+=\"uaccess\"\n";
    EXPECT_NE(run.out.find(expected), std::string::npos) << "expected:\n"
                                                         << expected << "found:\n"
                                                         << run.out;
}

TEST(Doctor, ListsTheDevicesToo) {
    MockBus bus;
    bus.plug_in(kJoystick);
    MockHid bluetooth = kDualSense;
    bluetooth.is_bluetooth = true;
    bus.plug_in(bluetooth);
    const test::ProgramRun run = test::run_onggi({"doctor"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("Testing FFB stick: force-feedback joystick; moves the tool"), std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("Sony DualSense Wireless Controller: DualSense; moves the tool"),
              std::string::npos)
        << run.out;
}

}  // namespace
}  // namespace onggi
