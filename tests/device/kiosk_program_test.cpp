// The kiosk with devices: the real program in a real window under Xvfb, the real hidapi, and devices that
// umockdev describes. Runs under a display of its own (tests/window/with_display.sh). Never on hardware.
#include <gtest/gtest.h>
#include <signal.h>  // NOLINT: SIGTERM

#include <chrono>

#include "tests/cli/cli_expectations.h"
#include "tests/device/mock_devices.h"
#include "tests/device/mock_hid.h"
#include "tests/support/comes_true.h"

namespace onggi {
namespace {

using test::RunningOnggi;
using testing::kPedal;
using testing::kSpaceMouse;
using testing::MockBus;

// Three minutes, because a software driver under a sanitizer takes ten seconds to its first frame, and the
// machine may be busy.
bool says(RunningOnggi& program, std::string_view line) {
    const auto has_said = [&] { return program.printed().find(line) != std::string::npos; };
    test::comes_true([&] { return has_said() || !program.at_work(); }, std::chrono::minutes(3));
    return has_said();
}

TEST(KioskAmongDevices, TakesThemAsTheyComeAndLeavesThemInPeaceWhenItIsEnded) {
    const test::TemporaryFolder folder;
    MockBus bus;
    bus.plug_in(kPedal);
    RunningOnggi onggi({"kiosk", "--size", "320x180", "--volume", "0", "--gallery", folder.path().string()},
                       {.folder = folder.path()});
    ASSERT_TRUE(says(onggi, "device: VEC Footpedal is here (/dev/hidraw6)\n")) << onggi.printed();
    bus.plug_in(kSpaceMouse);
    ASSERT_TRUE(says(onggi, "device: 3Dconnexion SpaceMouse Compact is here (/dev/hidraw5)\n"))
        << onggi.printed();
    EXPECT_EQ(bus.at(kSpaceMouse).take_written(), "0401");
    bus.pull_out(kPedal);
    ASSERT_TRUE(says(onggi, "device: VEC Footpedal is gone\n")) << onggi.printed();
    onggi.signal(SIGTERM);
    EXPECT_EQ(onggi.exit_code(), 0) << onggi.printed();
    EXPECT_EQ(bus.at(kSpaceMouse).take_written(), "0400") << "its lamp is put out";
}

TEST(KioskAmongDevices, TouchesNoOtherToolThanTheOneThatIsNamed) {
    const test::TemporaryFolder folder;
    MockBus bus;
    bus.plug_in(kSpaceMouse);
    bus.plug_in(kPedal);
    RunningOnggi onggi({"kiosk", "--size", "320x180", "--volume", "0", "--device", "joystick", "--gallery",
                        folder.path().string()},
                       {.folder = folder.path()});
    ASSERT_TRUE(says(onggi, "device: VEC Footpedal is here (/dev/hidraw6)\n")) << onggi.printed();
    onggi.signal(SIGTERM);
    EXPECT_EQ(onggi.exit_code(), 0) << onggi.printed();
    EXPECT_EQ(onggi.printed().find("SpaceMouse"), std::string::npos) << onggi.printed();
    EXPECT_EQ(bus.at(kSpaceMouse).take_written(), "");
}

}  // namespace
}  // namespace onggi
