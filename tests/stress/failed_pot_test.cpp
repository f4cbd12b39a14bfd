// A visitor spins a wide wet bowl until it collapses: the failure screen, and each way on from there.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/stress/unseen_kiosk.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

using kiosk::Button;
using kiosk::Screen;

// It is stable at a visit's initial speed but not at the highest.
clay::StudioClay wet_bowl() {
    clay::StudioClay clay({.mass_g = 1500.0, .rings = 1000});
    clay.set_liquidity(1.0);
    clay.set_wall(80.0, 5.0, 8.0, 140.0, 800);
    return clay;
}

class FailedPot : public testing::Test {
  protected:
    void begin() {
        kiosk.touch();
        ASSERT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kChoose; }));
        ASSERT_TRUE(kiosk.press(Button::kFree));
        ASSERT_TRUE(stays_on_the_wheel(60)) << "it stands as it is";
    }
    // The clay moves in real time; the visit's clock must not run ahead to the attract timeout.
    void spin_it_apart() {
        for (int step = 0; step < 2; ++step)
            ASSERT_TRUE(kiosk.press(Button::kSpeedMore));
        ASSERT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kFailure; }, kSlowly))
            << "at " << kiosk.snapshot().wheel_speed_rad_s << " rad/s, load " << kiosk.snapshot().load.index
            << ", height " << kiosk.snapshot().pot->height_mm;
    }
    double widest_mm() {
        const auto& outer = kiosk.snapshot().pot->outer_mm;
        return 2.0 * double{*std::max_element(outer.begin(), outer.end())};
    }
    // Checks it for that many frames.
    bool stays_on_the_wheel(int frames) {
        for (int frame = 0; frame < frames; ++frame) {
            kiosk.frame();
            if (kiosk.screen() != Screen::kThrow) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return true;
    }

    test::TemporaryFolder folder;
    UnseenKiosk kiosk{folder.path(), {.lump = wet_bowl(), .forgiving = false}};
};

TEST_F(FailedPot, GoesBackToJustBeforeAndStandsBecauseTheWheelIsSlower) {
    begin();
    const double standing_mm = widest_mm();
    spin_it_apart();
    EXPECT_GT(widest_mm(), standing_mm + 15.0);
    EXPECT_GT(kiosk.snapshot().pot->height_mm, 120.0) << "of 140: it spins wide before it sinks";
    ASSERT_TRUE(kiosk.press(Button::kBeforeCollapse));
    EXPECT_TRUE(stays_on_the_wheel(20)) << "what had given way was taken for this";
    EXPECT_EQ(kiosk.state().throwing.speed, 3) << "the wheel is faster than any visitor";
    // It is computed beside the frame, which takes longer on a busy machine.
    ASSERT_TRUE(kiosk.until([&] { return widest_mm() < standing_mm + 3.0; }, kSlowly)) << "it never came";
    EXPECT_TRUE(stays_on_the_wheel(200));
    EXPECT_LT(widest_mm(), standing_mm + 3.0);
    EXPECT_GT(kiosk.snapshot().pot->height_mm, 137.0);
    EXPECT_EQ(kiosk.snapshot().load.failure.cause, clay::studio::Cause::kNone);
}

TEST_F(FailedPot, GivesWayToNewClay) {
    begin();
    spin_it_apart();
    ASSERT_TRUE(kiosk.press(Button::kNewClay));
    EXPECT_TRUE(stays_on_the_wheel(60)) << "the old clay was taken for the new";
}

TEST_F(FailedPot, IsFiredAndKeptUnchanged) {
    begin();
    spin_it_apart();
    ASSERT_TRUE(kiosk.press(Button::kKeepSlump));
    ASSERT_TRUE(kiosk.fires_it(false));
    ASSERT_TRUE(kiosk.press(Button::kTakeGlaze));
    ASSERT_TRUE(kiosk.press(Button::kKeep));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.state().keeping.outcome == kiosk::Keeping::Outcome::kKept; },
                            kSlowly));
    ASSERT_TRUE(kiosk.press(Button::kAnother));
    ASSERT_TRUE(kiosk.press(Button::kFree));
    EXPECT_TRUE(stays_on_the_wheel(60)) << "the sunken pot was taken for the new clay";
}

}  // namespace
}  // namespace onggi::app
