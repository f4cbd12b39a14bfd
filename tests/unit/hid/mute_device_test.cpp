// A device that falls silent, failed or held still: its session, the tool and the safety chain together, on
// virtual time.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>

#include "engine/haptics/hid/dual_sense_driver.h"
#include "engine/haptics/hid/hid_session.h"
#include "engine/haptics/hid/pid_driver.h"
#include "engine/haptics/hid/simple_drivers.h"
#include "engine/haptics/hid/tool_tracker.h"
#include "engine/haptics/safety_chain.h"
#include "tests/support/pid_descriptors.h"
#include "tests/support/scripted_hid.h"

namespace onggi::haptics::hid {
namespace {

using testing::as_hex;
using testing::hex;
using testing::ScriptedBus;
using testing::ScriptedHid;

// An OpenFFBoard's stick, X as told; Y in the middle.
std::string stick_at(int x) {
    const auto low = static_cast<std::uint8_t>(x & 0xff);
    const auto high = static_cast<std::uint8_t>(x >> 8);
    return "01 00 00 00 00 00 00 00 00 " + as_hex(std::array<std::uint8_t, 2>{low, high}) +
           " 00 00 00 00 00 00 00 00 00 00 00 00 00 00";
}

// The tick at 1 kHz and the I/O thread's round every 4 ms, about a stick that the clay pushes with 1 N.
class StickInTheClay : public ::testing::Test {
  protected:
    StickInTheClay() {
        script->info = {.path = "/dev/hidraw9", .may_open = true};
        script->info.kind = HidKind::kForceJoystick;
        script->info.report_descriptor = testing::open_ffboard_descriptor();
        for (const char* answer : {"12 01 01 00 01", "12 02 01 00 01", "12 03 01 00 01", "12 04 01 00 01"})
            script->features[0x12].push_back(hex(answer));
        limits_.device_period_s = 0.01;
    }

    void run_ms(int milliseconds) {
        for (int k = 0; k < milliseconds; ++k) {
            if (time_ms_ % 4 == 0) (void)session_.round(time_ms_ * kMs);
            ++time_ms_;
            const HandSample tool = tracker_.moved(link_.input.latest(), kStep);
            const dvec3 wanted(0.0, pushes ? 1.0 : 0.0, 0.0);
            force_n = apply_safety_chain(wanted,
                                         {.position_mm = tool.position_mm,
                                          .dt_s = kStep,
                                          .position_is_new = tracker_.was_refreshed(),
                                          .hand_is_there = tracker_.input_is_live()},
                                         limits_, safety_);
            link_.force.put({.force_n = {force_n.x, force_n.y},
                             .tool_mm = {tool.position_mm.x, tool.position_mm.y},
                             .ticks = ++ticks_});
        }
    }
    // Reports every 4 ms for `milliseconds`, with a stick that trembles by `tremble` counts.
    void hold_ms(int milliseconds, int tremble) {
        for (int k = 0; k < milliseconds; k += 4) {
            script->report(stick_at(1000 + tremble * (k / 4 % 2)));
            run_ms(4);
        }
    }
    [[nodiscard]] int silent_ms_until_loose(int most_ms) {
        for (int k = 0; k < most_ms; ++k) {
            if (force_n == dvec3(0.0)) return k;
            run_ms(1);
        }
        return most_ms;
    }

    std::shared_ptr<ScriptedHid> script = std::make_shared<ScriptedHid>();
    bool pushes = false;
    dvec3 force_n{0.0};

  private:
    static constexpr double kStep = 0.001;

    HidLink link_;
    HidSession session_{link_, std::make_unique<ScriptedBus>(script), std::make_unique<PidDriver>(),
                        HidSessionOptions{.kind = HidKind::kForceJoystick, .force = {}}};
    ToolTracker tracker_;
    SafetyLimits limits_;
    SafetyState safety_;
    std::int64_t time_ms_ = 1000;
    std::uint64_t ticks_ = 0;
};

TEST_F(StickInTheClay, ThatReportsContinuouslyLosesItsForceOnceSilent) {
    hold_ms(40, 0);
    pushes = true;
    hold_ms(1500, 0);
    ASSERT_EQ(force_n.y, 1.0) << "held to the last bit, and heard";
    // Two of its periods, then 5 ms; the I/O thread's round may be 4 ms old.
    EXPECT_LE(silent_ms_until_loose(2000), 20 + 5 + 4 + 2);
}

TEST_F(StickInTheClay, ThatReportsChangesOnlyKeepsItsForceWhileItIsHeldStillAndLosesItWithinASecond) {
    hold_ms(40, 1);
    pushes = true;
    hold_ms(1500, 1);
    ASSERT_EQ(force_n.y, 1.0);
    run_ms(900);
    EXPECT_EQ(force_n.y, 1.0) << "it has nothing to say";
    hold_ms(100, 1);
    run_ms(900);
    EXPECT_EQ(force_n.y, 1.0) << "and again";
    EXPECT_LE(silent_ms_until_loose(2000), 110) << "no hand holds a 16-bit sensor for a second";
}

TEST_F(StickInTheClay, ThatRestsAfterALastWordIsTakenForMuteOnceAndNeverAgain) {
    hold_ms(40, 0);
    run_ms(200);
    EXPECT_EQ(force_n, dvec3(0.0));
    hold_ms(40, 0);
    pushes = true;
    hold_ms(1500, 0);
    ASSERT_EQ(force_n.y, 1.0);
    run_ms(900);
    EXPECT_EQ(force_n.y, 1.0);
}

TEST(ReportHabit, DoesNotMistakeADelayedThreadForASilentDevice) {
    ReportHabit habit;
    const auto report = hex("01 02 03");
    habit.take(report);
    EXPECT_FALSE(habit.reports_all_the_time());
    habit.take(hex("01 02 04"));
    habit.take(hex("01 02"));
    EXPECT_FALSE(habit.reports_all_the_time()) << "never the same";
    habit.take(report);
    habit.take(report);
    EXPECT_TRUE(habit.reports_all_the_time());
    // However long it took: the device was not read meanwhile.
    habit.round();
    habit.take(report);
    EXPECT_TRUE(habit.reports_all_the_time());
    for (int round = 0; round < 30; ++round)
        habit.round();
    EXPECT_TRUE(habit.reports_all_the_time()) << "mute";
    habit.take(report);
    EXPECT_FALSE(habit.reports_all_the_time()) << "no, it only rested";
}

TEST(DriversWithoutForce, KnowWhetherSilenceMeansNoChange) {
    VecPedalDriver pedal;
    EXPECT_TRUE(pedal.input(3600'000 * kMs).is_fresh);
    SpaceMouseDriver mouse;
    EXPECT_TRUE(mouse.input(3600'000 * kMs).is_fresh) << "at rest it is silent";
    mouse.take_report(hex("01 5e 01 00 00 00 00"), 8 * kMs);
    EXPECT_TRUE(mouse.input(8 * kMs).is_fresh);
    EXPECT_FALSE(mouse.input(12 * kMs).is_fresh) << "pushed, it reports all the time";
    DualSenseDriver pad;
    EXPECT_FALSE(pad.input(0).is_fresh);
    std::vector<std::uint8_t> report(64);
    report[0] = 0x01;
    pad.take_report(report, 4 * kMs);
    EXPECT_TRUE(pad.input(4 * kMs).is_fresh);
    EXPECT_FALSE(pad.input(8 * kMs).is_fresh);
}

}  // namespace
}  // namespace onggi::haptics::hid
