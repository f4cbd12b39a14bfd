// Devices whose controls do not come to rest: from their reports, through driver and tracker, to the signs of
// life that they give. Virtual time.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "engine/haptics/hid/dual_sense_driver.h"
#include "engine/haptics/hid/simple_drivers.h"
#include "engine/haptics/hid/tool_tracker.h"

namespace onggi::haptics::hid {
namespace {

constexpr double kReportS = 0.01;
constexpr double kMinuteS = 60.0;

// What the haptic thread sees of a hand, in the steps of the reports.
class Wheel {
  public:
    // Each input of input(step) for so long.
    template <typename Input>
    void passes(double seconds, const Input& input) {
        signs = moves = 0;
        for (int step = 0; step < static_cast<int>(seconds / kReportS + 0.5); ++step) {
            DeviceInput now = input(step);
            now.is_live = true;
            now.heartbeat = ++heartbeat_;
            tool = tracker.moved(now, kReportS);
            signs += tracker.hand_lives() ? 1 : 0;
            moves += tracker.hand_moves() ? 1 : 0;
        }
    }
    void takes_space_mouse(double seconds, const std::array<std::int16_t, 6>& axes) {
        std::vector<std::uint8_t> report{0x01};
        for (const std::int16_t axis : axes) {
            report.push_back(static_cast<std::uint8_t>(static_cast<std::uint16_t>(axis) & 0xffU));
            report.push_back(static_cast<std::uint8_t>(static_cast<std::uint16_t>(axis) >> 8U));
        }
        passes(seconds, [&](int) {
            space_mouse_.take_report(report, 0);
            return space_mouse_.input(0);
        });
    }

    ToolTracker tracker;
    HandSample tool;
    int signs = 0;
    int moves = 0;

  private:
    std::uint64_t heartbeat_ = 0;
    SpaceMouseDriver space_mouse_;
};

TEST(ASpaceMouse, ThatLeansOnAllAxesGivesNoSignOfLifeAndTheToolAfterAMinute) {
    Wheel wheel;
    wheel.takes_space_mouse(1.0, {});
    wheel.takes_space_mouse(10.0 * kMinuteS - 1.0, {60, -40, 50, 40, -40, 30});
    EXPECT_LE(wheel.signs, 1) << "it was a sign of life for ever";
    EXPECT_LE(wheel.moves, 6001) << "it had the tool for ever";
    EXPECT_FALSE(wheel.tracker.never_rests());
    wheel.takes_space_mouse(2.0, {60, -40, 50, 40, -40, 30});
    EXPECT_TRUE(wheel.tracker.never_rests());
    EXPECT_EQ(wheel.moves, 0);
    wheel.takes_space_mouse(1.0, {300, 0, 50, 0, 0, 0});
    EXPECT_GT(wheel.signs, 0) << "a person";
    EXPECT_EQ(wheel.moves, 100);
    wheel.takes_space_mouse(1.0, {});
    EXPECT_FALSE(wheel.tracker.never_rests());
}

TEST(ASpaceMouse, ThatDriftsGivesNoSignOfLife) {
    Wheel wheel;
    int signs = 0;
    for (std::int16_t count = 0; count < 350; ++count) {
        const auto less = static_cast<std::int16_t>(-count);
        wheel.takes_space_mouse(2.0, {count, less, count, less, count, less});
        signs += wheel.signs;
    }
    EXPECT_EQ(signs, 0) << "from the middle to the end in twelve minutes";
}

TEST(ASpaceMouse, ThatIsPushedLightlyGivesASign) {
    Wheel wheel;
    wheel.takes_space_mouse(1.0, {});
    wheel.takes_space_mouse(1.0, {0, 0, 40, 0, 0, 0});
    EXPECT_EQ(wheel.signs, 1);
    EXPECT_EQ(wheel.moves, 100) << "a hand that holds it still has the tool";
}

TEST(APedal, ThatIsDownForEverIsOneSignOfLife) {
    VecPedalDriver pedal;
    const auto says = [&](std::uint8_t bits) {
        return [&pedal, bits](int) {
            pedal.take_report(std::vector<std::uint8_t>{bits, 0}, 0);
            return pedal.input(0);
        };
    };
    Wheel wheel;
    wheel.passes(1.0, says(0));
    wheel.passes(11.0 * kMinuteS, says(2));
    EXPECT_EQ(wheel.signs, 1) << "it was one for ever";
    EXPECT_TRUE(wheel.tool.button) << "the wheel turns on";
    EXPECT_TRUE(wheel.tracker.never_rests());
    wheel.passes(1.0, says(0));
    EXPECT_EQ(wheel.signs, 1);
    EXPECT_FALSE(wheel.tracker.never_rests());
}

TEST(ADualSense, WithAStickThatLeansAndATriggerThatDoesNotComeBackGivesNoSign) {
    DualSenseDriver pad;
    std::vector<std::uint8_t> report(64, 0);
    report[0] = 0x01;
    report[2] = report[3] = report[4] = 0x80;
    report[1] = 0x80 + 20;  // the left stick at 0.16
    report[8] = 0x08;
    std::mt19937 chance(46);
    const auto says = [&](std::uint8_t trigger) {
        return [&, trigger](int) {
            report[6] = trigger;
            if (trigger > 0)
                report[6] = static_cast<std::uint8_t>(trigger + std::uniform_int_distribution(-3, 3)(chance));
            pad.take_report(report, 0);
            return pad.input(0);
        };
    };
    Wheel wheel;
    wheel.passes(kMinuteS, says(13));  // 0.05
    EXPECT_EQ(wheel.signs, 0);
    wheel.passes(10.0 * kMinuteS, says(13));
    EXPECT_EQ(wheel.signs + wheel.moves, 0) << "the stick had the tool, and was a sign of life, for ever";
    EXPECT_TRUE(wheel.tracker.never_rests());
    wheel.passes(1.0, says(128));
    EXPECT_GT(wheel.signs, 0) << "a person pulls it";
}

// A force-feedback joystick: where it stands says nothing of whether somebody holds it.
TEST(AJoystick, WhoseSensorNeverStopsIsNoSignOfLifeAfterTenMinutesUntilAHandMovesIt) {
    std::mt19937 chance(46);
    double middle_mm = 75.0;
    const auto noisy = [&](int) {
        std::uniform_real_distribution noise_mm(-3.0, 3.0);
        return DeviceInput{.motion = DeviceInput::Motion::kPlace,
                           .place_mm = {middle_mm + noise_mm(chance), 60.0 + noise_mm(chance)}};
    };
    Wheel wheel;
    wheel.passes(9.9 * kMinuteS, noisy);
    EXPECT_GT(wheel.signs, 1000);
    wheel.passes(0.2 * kMinuteS, noisy);
    EXPECT_TRUE(wheel.tracker.never_rests());
    wheel.passes(10.0 * kMinuteS, noisy);
    EXPECT_EQ(wheel.signs + wheel.moves, 0);
    middle_mm = 95.0;
    wheel.passes(1.0, noisy);
    EXPECT_GT(wheel.signs, 10);
    EXPECT_GT(wheel.moves, 10) << "and it takes the tool";
}

TEST(AJoystick, ThatStandsAnywhereRests) {
    Wheel wheel;
    wheel.passes(20.0 * kMinuteS, [](int) {
        return DeviceInput{.motion = DeviceInput::Motion::kPlace, .place_mm = {30.0, 60.0}, .buttons = 4};
    });
    EXPECT_EQ(wheel.signs, 0) << "with a switch that is on";
    EXPECT_FALSE(wheel.tracker.never_rests());
}

}  // namespace
}  // namespace onggi::haptics::hid
