// `onggi live` with devices that are plugged in, removed and hold the tool: the real program, hidapi and
// libudev, on devices that umockdev describes. Never on hardware.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>  // NOLINT: SIGTERM, kill

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <thread>
#include <utility>

#include "engine/haptics/hid/report_descriptor.h"
#include "tests/cli/cli_expectations.h"
#include "tests/device/mock_devices.h"
#include "tests/device/mock_hid.h"
#include "tests/support/comes_true.h"
#include "tests/support/public_devices.h"

namespace onggi {
namespace {

using test::comes_true;
using test::RunningOnggi;
using testing::HidScript;
using testing::joystick_features;
using testing::kDualSense;
using testing::kJoystick;
using testing::kPedal;
using testing::kSpaceMouse;
using testing::LiveHid;
using testing::MockBus;
using testing::MockHid;

// A hand that holds the tool away from the clay for longer than any test.
constexpr std::string_view kAwayFromTheClay = "0,140,100,0,0,10\n300,140,100,0,0,10\n";

std::string solid(std::initializer_list<std::string_view> reports) {
    std::string text;
    for (const std::string_view report : reports)
        text += report;
    std::erase(text, ' ');
    return text;
}

// The joystick's input report: the stick's X and Y as fractions of 32767.
std::string stick(double x, double y) {
    const auto field = [](double fraction) {
        const auto value = static_cast<std::uint16_t>(static_cast<std::int16_t>(fraction * 32767.0));
        return fmt::format("{:02x} {:02x} ", value & 0xffU, value >> 8U);
    };
    std::string text = "01 00 00 00 00 00 00 00 00 " + field(x) + field(y);
    for (int axis = 0; axis < 6; ++axis)
        text += "00 00 ";
    return text;
}
// The stick's report for a tool position: 0 to 150 mm of radius and 0 to 250 mm of height.
std::string stick_at(double radius_mm, double height_mm) {
    return stick(radius_mm / 75.0 - 1.0, 1.0 - height_mm / 125.0);
}

void expect_left_in_peace(const std::string& written) {
    EXPECT_TRUE(written.ends_with(solid({"0c 04", "0b 01", "0b 02", "0b 03", "0b 04", "0c 02"})))
        << "stop all, free all four, actuators off; found: " << written;
}

// Returns 0 if it has none or several.
int only_child_of(int process) {
    std::ifstream in(fmt::format("/proc/{0}/task/{0}/children", process));
    int child = 0;
    int another = 0;
    in >> child;
    return in >> another ? 0 : child;
}

class LiveAmongDevices : public ::testing::Test {
  protected:
    LiveAmongDevices() {
        test::put_file(folder_ / "away.csv", test::kGestureHeaderLine + std::string(kAwayFromTheClay));
    }

    RunningOnggi start(const std::string& device = "auto", const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{"live",       "away.csv", "--clay", "paper",  "--device", device,
                                       "--headless", "--size",   "64x36",  "--rate", "1000"};
        words.insert(words.end(), more.begin(), more.end());
        return RunningOnggi(words, {.folder = folder_.path()});
    }
    // Plugs the joystick in and moves its stick: beside the clay for the ramp, then 2 mm deep. If a busy
    // machine delays the loop meanwhile, the force stays off until the tool has left the clay, so the test
    // tries again, for longer. Returns the reports sent to the joystick since.
    std::string press_into_the_clay(const LiveHid& joystick) {
        int trembles = 0;
        const auto stay_beside_the_clay = [&](int reports) {
            for (int report = 0; report < reports; ++report) {
                joystick.report(stick_at(90.0 + 2.0 * (++trembles % 2), 100.0));
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            }
            joystick.take_written();
        };
        std::string written;
        // A one-sided spring on X: block 1, the centre where the clay's face is, and stiff on one side only.
        const auto feels_a_wall = [&] {
            joystick.report(stick_at(68.0, 100.0 + 0.1 * (++trembles % 2)));
            written += joystick.take_written();
            for (std::size_t at = written.find("030100"); at != std::string::npos;
                 at = written.find("030100", at + 2)) {
                if (written.size() >= at + 30 && written.substr(at + 10, 4) == "0000" &&
                    written.substr(at + 14, 4) != "0000")
                    return true;
            }
            return false;
        };
        constexpr int kTries = 8;
        bool is_felt = false;
        for (int tries = 1; tries <= kTries && !is_felt; ++tries) {
            stay_beside_the_clay(150 * tries);
            written.clear();
            is_felt = comes_true(feels_a_wall, std::chrono::seconds(2 * tries));
        }
        EXPECT_TRUE(is_felt) << written;
        return written;
    }
    static bool says(RunningOnggi& program, std::string_view line) {
        return comes_true([&] { return program.printed().find(line) != std::string::npos; });
    }

    test::TemporaryFolder folder_;
    MockBus bus_;
};

TEST_F(LiveAmongDevices, AForceJoystickFeelsTheClayAndIsLeftInPeaceBySigterm) {
    bus_.plug_in(kJoystick, joystick_features());
    const LiveHid joystick = bus_.at(kJoystick);
    RunningOnggi onggi = start();
    ASSERT_TRUE(says(onggi, "device: Testing FFB stick is here (/dev/hidraw8)")) << onggi.printed();

    std::string written = joystick.take_written();
    EXPECT_TRUE(
        written.starts_with(solid({"0c 08", "0c 08", "0c 04", "0c 01", "0d ff",
                                   "01 01 08 f4 01 00 00 00 00 00 00 ff 00 04 28 23 00 00 00 00 00 00",
                                   "01 02 01 f4 01 00 00 00 00 00 00 ff 00 04 00 00 00 00 00 00 00 00",
                                   "01 03 09 f4 01 00 00 00 00 00 00 ff 00 04 28 23 00 00 00 00 00 00",
                                   "01 04 0b f4 01 00 00 00 00 00 00 ff 00 04 28 23 00 00 00 00 00 00",
                                   "03 01 00 00 00 00 00 00 00 73 08 73 08 00 00",
                                   "03 01 01 00 00 00 00 00 00 73 08 73 08 00 00", "0a 01 01 01"})))
        << written;

    (void)press_into_the_clay(joystick);
    joystick.take_written();
    onggi.signal(SIGTERM);
    EXPECT_EQ(onggi.exit_code(), 0) << onggi.printed();
    expect_left_in_peace(joystick.take_written());
}

TEST_F(LiveAmongDevices, AForceJoystickIsLeftInPeaceWhenTheProgramEndsByItself) {
    bus_.plug_in(kJoystick, joystick_features());
    const LiveHid joystick = bus_.at(kJoystick);
    RunningOnggi onggi = start("auto", {"--seconds", "3"});
    ASSERT_TRUE(says(onggi, "device: Testing FFB stick is here")) << onggi.printed();
    EXPECT_EQ(onggi.exit_code(), 0) << onggi.printed();
    expect_left_in_peace(joystick.take_written());
}

// As by the kernel's out-of-memory killer: the child dies at once, while its effects still run.
TEST_F(LiveAmongDevices, AForceJoystickIsLetGoByTheSupervisorWhenTheProgramIsKilled) {
    bus_.plug_in(kJoystick, joystick_features());
    const LiveHid joystick = bus_.at(kJoystick);
    RunningOnggi onggi = start();
    ASSERT_TRUE(says(onggi, "device: Testing FFB stick is here")) << onggi.printed();
    (void)press_into_the_clay(joystick);
    const int child = only_child_of(onggi.process());
    ASSERT_GT(child, 0) << "the supervisor has one child, the program";
    joystick.take_written();
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    EXPECT_EQ(onggi.exit_code(), 1);
    EXPECT_NE(onggi.printed().find("the program died of signal 9; 1 device was silenced"), std::string::npos)
        << onggi.printed();
    const std::string written = joystick.take_written();
    EXPECT_NE(written.find(solid({"0c 08", "0c 08", "0c 04", "0c 01"})), std::string::npos)
        << "reset and stopped; found: " << written;
    expect_left_in_peace(written);
}

TEST_F(LiveAmongDevices, ADeviceMayComeAndGoWhileTheWheelTurns) {
    RunningOnggi onggi = start();
    bus_.plug_in(kPedal);
    ASSERT_TRUE(says(onggi, "device: VEC Footpedal is here")) << onggi.printed();
    bus_.plug_in(kSpaceMouse);
    const auto plugged_in = std::chrono::steady_clock::now();
    ASSERT_TRUE(says(onggi, "device: 3Dconnexion SpaceMouse Compact is here (/dev/hidraw5)\n"))
        << onggi.printed();
    EXPECT_LT(std::chrono::steady_clock::now() - plugged_in, test::scaled(std::chrono::seconds(10)));
    EXPECT_EQ(bus_.at(kSpaceMouse).take_written(), "0401") << "its lamp burns";
    bus_.pull_out(kSpaceMouse);
    ASSERT_TRUE(says(onggi, "device: 3Dconnexion SpaceMouse Compact is gone\n")) << onggi.printed();
    MockHid again = kSpaceMouse;
    again.node = 11;
    bus_.plug_in(again);
    ASSERT_TRUE(says(onggi, "device: 3Dconnexion SpaceMouse Compact is here (/dev/hidraw11)\n"))
        << onggi.printed();
    onggi.signal(SIGINT);
    EXPECT_EQ(onggi.exit_code(), 0) << onggi.printed();
    EXPECT_EQ(bus_.at(again).take_written(), "04010400") << "and is put out at the end";
}

TEST_F(LiveAmongDevices, OneDeviceMayBeNamedAndAllOthersStayUntouched) {
    bus_.plug_in(kSpaceMouse);
    bus_.plug_in(kDualSense);
    RunningOnggi onggi = start("256f:c635");
    ASSERT_TRUE(says(onggi, "SpaceMouse Compact is here")) << onggi.printed();
    onggi.signal(SIGTERM);
    EXPECT_EQ(onggi.exit_code(), 0);
    EXPECT_EQ(bus_.at(kDualSense).take_written(), "");
}

TEST_F(LiveAmongDevices, AMissingNamedDeviceIsReported) {
    bus_.plug_in(kPedal);
    const auto refused = [&](const std::string& device, int exit_code, const std::string& reason) {
        test::expect_one_line(
            test::run_onggi({"live", "away.csv", "--device", device, "--headless", "--size", "64x36"},
                            {.folder = folder_.path()}),
            exit_code, reason);
    };
    refused("/dev/hidraw3", 3,
            "--device /dev/hidraw3: expected it to be plugged in, found /dev/hidraw6 05f3:00ff");
    refused("256f:c635", 3, "--device 256f:c635: expected it to be plugged in, found /dev/hidraw6 05f3:00ff");
    refused("spoon", 2,
            "--device: expected auto, gesture, spacemouse, dualsense, joystick, inverse3, /dev/hidrawN or "
            "VENDOR:PRODUCT, found "
            "'spoon'");
    refused("/dev/sda", 2, "--device: expected auto, gesture");
}

// A public firmware with its own descriptor, reports and layout.
struct ForceFirmware {
    std::string_view name;                // begins its row in tests/support/public_devices.tsv
    std::vector<std::string_view> begin;  // the writes until its effects run, without force
    std::vector<std::string_view> end;    // and the last ones
    HidScript features;
    std::string (*stick)(double x, double y, bool is_pressed);  // its input report; axes from -1 to 1
    bool (*pushes_outwards)(std::span<const std::uint8_t> report);
};

std::string two_bytes(double value) {
    const auto bits = static_cast<std::uint16_t>(static_cast<std::int16_t>(value));
    return fmt::format("{:02x} {:02x} ", bits & 0xffU, bits >> 8U);
}
int number_at(std::span<const std::uint8_t> report, std::size_t at) {
    return static_cast<std::int16_t>(report[at] | report[at + 1] << 8U);
}

// Blocks 1 to 4 for effects of these types.
HidScript four_blocks(std::string_view create, std::string_view load, std::initializer_list<int> types) {
    HidScript script;
    int block = 0;
    for (const int type : types) {
        script.sets_feature(fmt::format("{} {:02x} 00 00", create, type));
        script.answers_feature(fmt::format("{} {:02x} 01 00 01", load, ++block));
    }
    return script;
}

// A SideWinder Force Feedback Pro behind an adapter. It has no one-sided spring: constant forces up to 255 on
// both axes, from the west and the north, in units of two degrees.
const ForceFirmware kAdaptFfbJoy{
    .name = "adapt-ffb-joy",
    .begin = {"0c 04", "0c 04", "0c 03", "0c 01", "0d ff", "01 01 01 f4 01 00 00 00 00 ff 00 04 87 00",
              "01 02 01 f4 01 00 00 00 00 ff 00 04 00 00", "01 03 09 f4 01 00 00 00 00 ff 00 04 2d 00",
              "01 04 0b f4 01 00 00 00 00 ff 00 04 2d 00", "05 01 00 00", "0a 01 01 01", "05 02 00 00",
              "0a 02 01 01", "03 03 00 00 00", "03 03 01 00 00", "0a 03 01 01", "03 04 00 00 00",
              "03 04 01 00 00", "0a 04 01 01"},
    .end = {"0c 03", "0b 01", "0b 02", "0b 03", "0b 04", "0c 02"},
    .features = four_blocks("05", "06", {1, 1, 9, 11}),
    .stick =
        [](double x, double y, bool is_pressed) {
            return "01 " + two_bytes(x * 511.0) + two_bytes(y * 511.0) + "00 00 00 00 00 00 00 " +
                   (is_pressed ? "01" : "00") + " 00 08";
        },
    .pushes_outwards =
        [](std::span<const std::uint8_t> report) {
            return report[0] == 0x05 && report[1] == 1 && number_at(report, 2) > 0;
        }};

// The clay's face is a spring that is stiff only towards the axis: no coefficient beyond its centre, one
// before it.
bool is_wall(std::span<const std::uint8_t> report, std::uint8_t id) {
    return report[0] == id && report[1] == 1 && report[2] == 0 && number_at(report, 5) == 0 &&
           number_at(report, 7) > 0;
}

// Ranges up to 10000; 3.3 of 50 N are 660.
const ForceFirmware kArduino{
    .name = "ArduinoJoystickWithFFBLibrary, two axes",
    .begin = {"0c 04", "0c 04", "0c 03", "0c 01", "0d ff",
              "01 01 08 f4 01 00 00 00 00 00 00 ff 00 04 40 00 00 00 00 00",
              "01 02 01 f4 01 00 00 00 00 00 00 ff 00 04 00 00 00 00 00 00",
              "01 03 09 f4 01 00 00 00 00 00 00 ff 00 04 40 00 00 00 00 00",
              "01 04 0b f4 01 00 00 00 00 00 00 ff 00 04 40 00 00 00 00 00",
              "03 01 00 00 00 00 00 00 00 94 02 94 02 00 00", "03 01 01 00 00 00 00 00 00 94 02 94 02 00 00",
              "0a 01 01 01", "05 02 00 00", "0a 02 01 01"},
    .end = {"0c 03", "0b 01", "0b 02", "0b 03", "0b 04", "0c 02"},
    .features = four_blocks("05", "06", {8, 1, 9, 11}),
    .stick =
        [](double x, double y, bool is_pressed) {
            return (is_pressed ? "01 01 " : "01 00 ") + two_bytes(x * 32767.0) + two_bytes(y * 32767.0);
        },
    .pushes_outwards = [](std::span<const std::uint8_t> report) { return is_wall(report, 0x03); }};

// A DualShock 3: eight bits for an axis, report numbers from 16 on, gains up to 10000.
const ForceFirmware kDsHidMini{
    .name = "DsHidMini, DualShock 3 as one device",
    .begin = {"19 04", "19 04", "19 03", "19 01", "1b 10 27",
              "10 01 08 f4 01 00 00 00 00 10 27 00 04 28 23 00 00 00 00",
              "10 02 01 f4 01 00 00 00 00 10 27 00 04 00 00 00 00 00 00",
              "10 03 09 f4 01 00 00 00 00 10 27 00 04 28 23 00 00 00 00",
              "10 04 0b f4 01 00 00 00 00 10 27 00 04 28 23 00 00 00 00",
              "12 01 00 00 00 00 00 00 00 94 02 94 02 00 00", "12 01 01 00 00 00 00 00 00 94 02 94 02 00 00",
              "18 01 01 01", "14 02 00 00", "18 02 01 01"},
    .end = {"19 03", "1a 01", "1a 02", "1a 03", "1a 04", "19 02"},
    .features = four_blocks("20", "21", {8, 1, 9, 11}),
    .stick =
        [](double x, double y, bool is_pressed) {
            const auto axis = [](double fraction) { return static_cast<int>((fraction + 1.0) * 127.5); };
            std::string text =
                fmt::format("01 {:02x} {:02x} 80 80 {} 00 00", axis(x), axis(y), is_pressed ? "18" : "08");
            for (int byte = 0; byte < 31; ++byte)
                text += " 00";
            return text;
        },
    .pushes_outwards = [](std::span<const std::uint8_t> report) { return is_wall(report, 0x12); }};

class AForceFirmware : public LiveAmongDevices, public ::testing::WithParamInterface<ForceFirmware> {
  protected:
    // Runs on the studio's clay, with the pot's measures at the end.
    static std::vector<std::string> words(const std::string& device, const std::vector<std::string>& more) {
        std::vector<std::string> words{"live",  "away.csv", "--device", device,    "--headless", "--size",
                                       "64x36", "--rate",   "1000",     "--stats", "pot.json"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    nlohmann::json pot() { return nlohmann::json::parse(std::ifstream(folder_.path() / "pot.json")); }

    // Puts the stick there for as many reports, at a hundred a second, with a hand's trembling.
    void hold(double radius_mm, double height_mm, int reports, bool is_pressed = false) {
        for (int report = 0; report < reports; ++report) {
            const double x_mm = radius_mm + 1.3 * (++trembles_ % 2);
            stick_->report(GetParam().stick(x_mm / 75.0 - 1.0, 1.0 - height_mm / 125.0, is_pressed));
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            written_ += stick_->take_written();
        }
    }
    // What was written since the last call: whether a whole report among it pushes outwards.
    bool pushed_outwards(const std::vector<std::uint8_t>& report_descriptor) {
        const auto descriptor = haptics::hid::ReportDescriptor::parse(report_descriptor);
        const std::vector<std::uint8_t> bytes = testing::hex(std::exchange(written_, {}));
        for (std::size_t at = 0; at < bytes.size();) {
            const std::size_t size = descriptor->report_bytes(haptics::hid::ReportKind::kOutput, bytes[at]);
            if (size == 0 || at + size > bytes.size()) break;
            if (GetParam().pushes_outwards(std::span(bytes).subspan(at, size))) return true;
            at += size;
        }
        return false;
    }

    std::optional<LiveHid> stick_;
    std::string written_;
    int trembles_ = 0;
};

TEST_P(AForceFirmware, MakesAPotAndIsToldItsForcesInItsOwnLayout) {
    const auto left_alone =
        test::run_onggi(words("gesture", {"--seconds", "0.1"}), {.folder = folder_.path()});
    ASSERT_EQ(left_alone.exit_code, 0) << left_alone.err;
    const nlohmann::json lump = pot();

    const testing::PublicDevice row = testing::public_device(GetParam().name);
    const MockHid device{.node = 14,
                         .vendor_id = row.info.vendor_id,
                         .product_id = row.info.product_id,
                         .maker = "Testing",
                         .product = "firmware",
                         .descriptor = row.info.report_descriptor};
    bus_.plug_in(device, GetParam().features);
    stick_.emplace(bus_.at(device));
    RunningOnggi onggi(words("joystick", {}), {.folder = folder_.path()});
    ASSERT_TRUE(says(onggi, "device: Testing firmware is here (/dev/hidraw14)")) << onggi.printed();
    std::string begin;
    for (const std::string_view report : GetParam().begin)
        begin += solid({report});
    EXPECT_TRUE(comes_true([&] {
        written_ += stick_->take_written();
        return written_.starts_with(begin);
    })) << written_;

    // The hand starts the wheel beside the lump, waits there for its forces, and presses the lump in. As in
    // press_into_the_clay, a loop that a busy machine delays gives no force until the tool is outside again.
    hold(140.0, 30.0, 5);
    hold(140.0, 30.0, 5, true);
    bool is_pushed = false;
    for (int tries = 1; tries <= 8 && !is_pushed; ++tries) {
        hold(140.0, 30.0, 150 * tries);
        written_.clear();
        for (double radius_mm = 90.0; radius_mm > 40.0; radius_mm -= 1.0)
            hold(radius_mm, 30.0, 2);
        hold(40.0, 30.0, 50);
        is_pushed = pushed_outwards(row.info.report_descriptor);
    }
    EXPECT_TRUE(is_pushed) << "out of the clay, at its device's own numbers";
    hold(140.0, 30.0, 20);
    onggi.signal(SIGTERM);
    EXPECT_EQ(onggi.exit_code(), 0) << onggi.printed();
    std::string end;
    for (const std::string_view report : GetParam().end)
        end += solid({report});
    EXPECT_TRUE(stick_->take_written().ends_with(end));
    EXPECT_GT(pot().at("height_mm"), lump.at("height_mm").get<double>() + 5.0) << "squeezed, clay rises";
}

INSTANTIATE_TEST_SUITE_P(Public, AForceFirmware, ::testing::Values(kAdaptFfbJoy, kArduino, kDsHidMini),
                         [](const auto& tested) {
                             const std::string name(tested.param.name);
                             return name.substr(0, name.find_first_of("-, "));
                         });

}  // namespace
}  // namespace onggi
