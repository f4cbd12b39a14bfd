// The visitor's finger, before it reaches the haptic loop.
#include "game/app/kiosk/finger/kiosk_finger.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/tool/tool.h"
#include "tests/support/millimetre_pot.h"

namespace onggi::app {
namespace {

// A pot of a hundred rings, a millimetre each: solid to floor_mm, a wall above.
pot::Pot pot(double height_mm, double outer_mm, double wall_mm, double floor_mm) {
    return test::millimetre_pot(height_mm, outer_mm, floor_mm, outer_mm - wall_mm);
}

// Frames of a sixtieth of a second.
tool::ToolState after(KioskFinger& finger, const pot::Pot& shape, double seconds) {
    tool::ToolState tool = finger.request({}, shape, 1.0 / 60.0);
    for (double gone_s = 1.0 / 60.0; gone_s < seconds - 1e-9; gone_s += 1.0 / 60.0)
        tool = finger.request({}, shape, 1.0 / 60.0);
    return tool;
}
tool::ToolState next(KioskFinger& finger, const pot::Pot& shape) {
    return after(finger, shape, 1.0 / 60.0);
}

class KioskFingerTest : public ::testing::Test {
  protected:
    const pot::Pot shape_ = pot(100, 60, 8, 10);
    const pot::Pot lump_ = pot(50, 62, 8, 50);
    KioskFinger finger_;
};

TEST_F(KioskFingerTest, IsAFingerThatDoesNotPressWhileItOnlyHoversOrRests) {
    EXPECT_FALSE(next(finger_, shape_).pressing) << "no visitor yet";
    finger_.hover({20.0, 50.0});
    const auto tool = next(finger_, shape_);
    EXPECT_TRUE(tool.guided);
    EXPECT_FALSE(tool.pressing);
    EXPECT_EQ(tool.position_mm, dvec3(20.0, 50.0, 0.0));
    EXPECT_FALSE(finger_.works());
}

TEST_F(KioskFingerTest, PressesWhereTheFingerIsAndEndsWithItAtOnce) {
    finger_.press({80.0, 50.0});
    auto tool = next(finger_, shape_);
    EXPECT_TRUE(tool.guided && tool.pressing);
    EXPECT_EQ(tool.position_mm, dvec3(80.0, 50.0, 0.0));
    EXPECT_EQ(tool.assist_gap_mm, 0.0) << "the clay knows of the other hand";
    EXPECT_EQ(tool.side, tool::Side::kFree);
    finger_.drag({70.0, 60.0});
    EXPECT_EQ(next(finger_, shape_).position_mm, dvec3(70.0, 60.0, 0.0));
    finger_.release();
    tool = next(finger_, shape_);
    EXPECT_FALSE(tool.pressing);
    EXPECT_EQ(tool.position_mm, dvec3(70.0, 60.0, 0.0));
    EXPECT_FALSE(finger_.works());
}

TEST_F(KioskFingerTest, GivesASecondFingerAsTheOtherHand) {
    finger_.press({80.0, 50.0});
    EXPECT_FALSE(next(finger_, shape_).second.present);
    finger_.press_second({30.0, 55.0});
    auto tool = next(finger_, shape_);
    EXPECT_TRUE(tool.second.present);
    EXPECT_EQ(tool.second.position_mm, dvec3(30.0, 55.0, 0.0));
    EXPECT_EQ(tool.position_mm, dvec3(80.0, 50.0, 0.0)) << "the first stays the first";
    finger_.drag_second({35.0, 60.0});
    finger_.drag({82.0, 58.0});
    tool = next(finger_, shape_);
    EXPECT_EQ(tool.second.position_mm, dvec3(35.0, 60.0, 0.0));
    EXPECT_EQ(tool.position_mm, dvec3(82.0, 58.0, 0.0));
    EXPECT_TRUE(finger_.request({.tool = tool::Tool::kRib}, shape_, 1.0 / 60.0).pressing);
    EXPECT_FALSE(finger_.request({.tool = tool::Tool::kRib}, shape_, 1.0 / 60.0).second.present)
        << "one hand holds the tool";
    finger_.drag_second({35.0, 400.0});
    tool = next(finger_, shape_);
    EXPECT_FALSE(tool.second.present) << "it leapt, and the first goes on";
    EXPECT_TRUE(tool.pressing);
}

TEST_F(KioskFingerTest, GoesOnWithTheOtherFingerWhereEitherLifts) {
    finger_.press({80.0, 50.0});
    finger_.press_second({-80.0, 55.0});
    static_cast<void>(next(finger_, shape_));
    finger_.lift_second();
    auto tool = next(finger_, shape_);
    EXPECT_TRUE(tool.pressing && !tool.second.present);
    EXPECT_EQ(tool.position_mm.x, 80.0);

    finger_.press_second({-80.0, 55.0});
    static_cast<void>(next(finger_, shape_));
    finger_.lift();
    EXPECT_FALSE(next(finger_, shape_).pressing) << "a frame between two touches, so that no hand jumps";
    tool = next(finger_, shape_);
    EXPECT_TRUE(tool.pressing && !tool.second.present);
    EXPECT_EQ(tool.position_mm, dvec3(-80.0, 55.0, 0.0));
    finger_.drag_second({-75.0, 60.0});
    finger_.press({80.0, 40.0});
    tool = next(finger_, shape_);
    EXPECT_EQ(tool.position_mm, dvec3(-75.0, 60.0, 0.0)) << "who is there first leads";
    EXPECT_EQ(tool.second.position_mm, dvec3(80.0, 40.0, 0.0));
    finger_.lift_second();
    finger_.drag({82.0, 42.0});
    static_cast<void>(next(finger_, shape_));
    tool = next(finger_, shape_);
    EXPECT_EQ(tool.position_mm, dvec3(82.0, 42.0, 0.0));
    EXPECT_TRUE(tool.pressing && !tool.second.present);
    finger_.lift();
    EXPECT_FALSE(next(finger_, shape_).pressing);
    finger_.drag_second({0.0, 50.0});
    EXPECT_FALSE(next(finger_, shape_).pressing) << "it has been lifted long ago";
}

TEST_F(KioskFingerTest, PushesAsHardAsAPenAndNotAtAllWhileThatRests) {
    EXPECT_EQ(next(finger_, shape_).position_mm.z, 0.0);
    finger_.press({80.0, 50.0});
    finger_.push(0.03);
    auto tool = next(finger_, shape_);
    EXPECT_FALSE(tool.pressing) << "it rests on the glass";
    EXPECT_EQ(tool.position_mm, dvec3(80.0, 50.0, 0.0)) << "and the drawn hand hovers there";
    finger_.push(0.35);
    tool = next(finger_, shape_);
    EXPECT_TRUE(tool.pressing);
    EXPECT_NEAR(tool::push_of(tool), 1.0, 1e-9) << "as in writing: a finger's push";
    double before = 0.0;
    for (double pressure = 0.06; pressure <= 1.0; pressure += 0.01) {
        finger_.push(pressure);
        tool = next(finger_, shape_);
        EXPECT_TRUE(tool.pressing);
        EXPECT_GE(tool::push_of(tool), before);
        before = tool::push_of(tool);
    }
    EXPECT_NEAR(before, 1.6, 1e-9);
    finger_.push(0.0);
    EXPECT_FALSE(next(finger_, shape_).pressing);
    finger_.push(0.06);
    EXPECT_FALSE(next(finger_, shape_).pressing) << "a hand that trembles at the edge does not tap";
    finger_.push(std::nullopt);
    tool = next(finger_, shape_);
    EXPECT_TRUE(tool.pressing);
    EXPECT_EQ(tool.position_mm.z, 0.0) << "a mouse has the push that it always had";
    finger_.push(0.5);
    finger_.push(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(next(finger_, shape_).position_mm.z, 0.0);
}

TEST_F(KioskFingerTest, MovesAsideAfterALongIdleTime) {
    finger_.press({80.0, 50.0});
    EXPECT_EQ(after(finger_, shape_, 10.0).position_mm.x, 80.0) << "a finger that presses stays";
    finger_.release();
    EXPECT_EQ(after(finger_, shape_, 2.0).position_mm.x, 80.0);
    const auto rests = after(finger_, shape_, 3.0);
    EXPECT_EQ(rests.position_mm, resting_finger().position_mm);
    EXPECT_FALSE(rests.pressing);
    finger_.hover({10.0, 40.0});
    EXPECT_EQ(next(finger_, shape_).position_mm.x, 10.0);
}

TEST_F(KioskFingerTest, LetsGoOfAFingerThatLeapsOrIsNoNumber) {
    finger_.press({80.0, 50.0});
    for (int step = 1; step <= 10; ++step) {
        finger_.drag({80.0 - 15.0 * step, 50.0});
        EXPECT_TRUE(next(finger_, shape_).pressing) << "as fast as a hand is";
    }
    finger_.drag({-10.0, 50.0});
    finger_.drag({60.0, 50.0});
    EXPECT_FALSE(next(finger_, shape_).pressing);
    finger_.drag({55.0, 50.0});
    EXPECT_FALSE(next(finger_, shape_).pressing) << "until it presses again";
    finger_.press({55.0, 50.0});
    EXPECT_TRUE(next(finger_, shape_).pressing);
    constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    finger_.drag({kNoNumber, 50.0});
    EXPECT_FALSE(next(finger_, shape_).pressing);
    finger_.press({kNoNumber, kNoNumber});
    finger_.hover({kNoNumber, 1.0});
    finger_.steer({kNoNumber, 1.0}, false, shape_, 1.0);
    const auto tool = next(finger_, shape_);
    EXPECT_FALSE(tool.pressing);
    EXPECT_TRUE(std::isfinite(tool.position_mm.x) && std::isfinite(tool.position_mm.y));
}

// On a busy machine a frame may hold a whole touch.
TEST_F(KioskFingerTest, PressesForATouchThatCameAndWentBetweenTwoFrames) {
    finger_.press({80.0, 50.0});
    finger_.lift();
    auto tool = next(finger_, shape_);
    EXPECT_TRUE(tool.pressing);
    EXPECT_EQ(tool.position_mm, dvec3(80.0, 50.0, 0.0));
    EXPECT_FALSE(next(finger_, shape_).pressing);
    EXPECT_FALSE(finger_.works());
    finger_.press({80.0, 50.0});
    finger_.drag({60.0, 50.0});
    finger_.drag({40.0, 70.0});
    finger_.lift();
    finger_.drag({0.0, 0.0});
    tool = next(finger_, shape_);
    EXPECT_TRUE(tool.pressing);
    EXPECT_EQ(tool.position_mm, dvec3(80.0, 50.0, 0.0)) << "where the touch began";
    tool = next(finger_, shape_);
    EXPECT_TRUE(tool.pressing);
    EXPECT_EQ(tool.position_mm, dvec3(40.0, 70.0, 0.0)) << "where it ended";
    EXPECT_FALSE(next(finger_, shape_).pressing);
    finger_.press({80.0, 50.0});
    static_cast<void>(next(finger_, shape_));
    finger_.lift();
    EXPECT_FALSE(next(finger_, shape_).pressing) << "one that was seen ends at once";
    finger_.press({80.0, 50.0});
    finger_.lift();
    finger_.release();
    EXPECT_FALSE(next(finger_, shape_).pressing) << "as when the screen changes";
}

TEST_F(KioskFingerTest, BeginsATouchWhereItBeganHoweverFarItHasComeByTheFrame) {
    finger_.press({90.0, 20.0});
    for (int step = 1; step <= 20; ++step)
        finger_.drag({90.0 - 4.0 * step, 20.0});
    EXPECT_EQ(next(finger_, shape_).position_mm, dvec3(90.0, 20.0, 0.0));
    EXPECT_EQ(next(finger_, shape_).position_mm, dvec3(10.0, 20.0, 0.0));
}

TEST_F(KioskFingerTest, FollowsALongWayThatASlowFrameHolds) {
    finger_.press({90.0, 20.0});
    static_cast<void>(next(finger_, shape_));
    for (int step = 1; step <= 30; ++step)
        finger_.drag({90.0, 20.0 + 6.0 * step});
    const auto tool = finger_.request({}, shape_, 0.1);
    EXPECT_TRUE(tool.pressing) << "180 mm in a tenth of a second or more";
    EXPECT_EQ(tool.position_mm, dvec3(90.0, 200.0, 0.0));
    finger_.drag({90.0, 70.0});
    EXPECT_FALSE(finger_.request({}, shape_, 0.1).pressing) << "no finger leaps so far from report to report";
}

TEST_F(KioskFingerTest, StaysWithinReachAndAboveTheWheelHead) {
    finger_.press({9000.0, -50.0});
    const auto tool = next(finger_, shape_);
    EXPECT_EQ(tool.position_mm.x, 260.0);
    EXPECT_EQ(tool.position_mm.y, 0.0);
}

TEST_F(KioskFingerTest, TakesItsSettingsFromTheLedge) {
    const auto least = finger_.request({.size = 1, .water = 1, .speed = 1}, shape_, 0.016);
    const auto most = finger_.request({.size = 3, .water = 5, .speed = 5}, shape_, 0.016);
    EXPECT_LT(least.radius_mm, most.radius_mm);
    EXPECT_EQ(least.water, 0.0);
    EXPECT_EQ(most.water, 1.0);
    EXPECT_LT(least.wheel_speed_rev_min, most.wheel_speed_rev_min);
    EXPECT_TRUE(most.wheel_button);
}

TEST_F(KioskFingerTest, PlaysAStepOfTheLessonAndStops) {
    finger_.show(kiosk::ShownStep::kPress, lump_, 1.0);
    auto tool = next(finger_, lump_);
    EXPECT_TRUE(finger_.shows());
    EXPECT_FALSE(tool.pressing) << "the hands are seen to come";
    EXPECT_GT(tool.position_mm.x, 62.0);
    tool = after(finger_, lump_, 1.2);
    EXPECT_TRUE(tool.pressing);
    int frames = 0;
    while (finger_.shows() && ++frames < 360)
        tool = next(finger_, lump_);
    EXPECT_LT(frames, 360) << "six seconds at most";
    EXPECT_FALSE(next(finger_, lump_).pressing);
    EXPECT_NEAR(tool.position_mm.x, 54.0, 0.5);
}

TEST_F(KioskFingerTest, YieldsToAnyInputOfTheVisitor) {
    const std::vector<std::function<void()>> ways{[&] {
                                                      finger_.press({0.0, 60.0});
                                                  },
                                                  [&] { finger_.key(FingerKey::kUp, 1.0); },
                                                  [&] { finger_.button(FingerKey::kLeft, 1.0); },
                                                  [&] {
                                                      finger_.steer({1.0, 0.0}, false, lump_, 1.0);
                                                  },
                                                  [&] { finger_.stop_showing(); },
                                                  [&] { finger_.release(); }};
    for (std::size_t way = 0; way < ways.size(); ++way) {
        finger_.leave_clay();
        finger_.show(kiosk::ShownStep::kRaise, lump_, 1.0);
        ASSERT_TRUE(after(finger_, lump_, 1.5).pressing);
        ways[way]();
        EXPECT_FALSE(finger_.shows()) << way;
        EXPECT_FALSE(next(finger_, lump_).pressing) << "between two touches there is none: " << way;
    }
    finger_.release();
    finger_.show(kiosk::ShownStep::kRaise, lump_, 1.0);
    after(finger_, lump_, 1.5);
    finger_.hover({0.0, 0.0});
    EXPECT_TRUE(finger_.shows()) << "a trembling mouse is not a visitor";
    finger_.press({0.0, 60.0});
    next(finger_, lump_);
    const auto tool = next(finger_, lump_);
    EXPECT_TRUE(tool.pressing);
    EXPECT_EQ(tool.position_mm, dvec3(0.0, 60.0, 0.0));
}

TEST_F(KioskFingerTest, MakesATouchOfEveryKeyAndKeepsThemApart) {
    EXPECT_FALSE(finger_.marker_mm());
    finger_.key(FingerKey::kLeft, 1.0);
    finger_.key(FingerKey::kLeft, 1.0);
    int touches = 0;
    bool pressed = false;
    for (int frame = 0; frame < 120; ++frame) {
        const bool presses = next(finger_, shape_).pressing;
        touches += presses && !pressed ? 1 : 0;
        pressed = presses;
    }
    EXPECT_EQ(touches, 2);
    ASSERT_TRUE(finger_.marker_mm());
    EXPECT_EQ(*finger_.marker_mm(), dvec2(60.0, 30.0)) << "low on that side";
    for (int more = 0; more < 50; ++more)
        finger_.key(FingerKey::kLeft, 1.0);
    EXPECT_FALSE(after(finger_, shape_, 2.5).pressing) << "a key that was held does not work on for long";
    finger_.press({10.0, 20.0});
    next(finger_, shape_);
    EXPECT_FALSE(finger_.marker_mm()) << "a finger needs none";
    finger_.key(FingerKey::kLeft, 1.0);
    EXPECT_EQ(next(finger_, shape_).position_mm.x, 10.0) << "and has the finger for itself";
}

TEST_F(KioskFingerTest, ForgetsItsKeysWithTheClay) {
    finger_.key(FingerKey::kUp, 1.0);
    next(finger_, shape_);
    EXPECT_TRUE(finger_.marker_mm());
    finger_.key(FingerKey::kLeft, 1.0);
    finger_.leave_clay();
    EXPECT_FALSE(after(finger_, shape_, 0.2).pressing);
    EXPECT_FALSE(finger_.marker_mm());
}

TEST_F(KioskFingerTest, IsSteeredByAGamepadAndPressedByItsButton) {
    finger_.steer({-1.0, 0.0}, false, lump_, 1.0);
    auto tool = next(finger_, lump_);
    EXPECT_FALSE(tool.pressing);
    EXPECT_NEAR(tool.position_mm.x, 76.0, 1e-9) << "beside the clay";
    EXPECT_LT(tool.position_mm.y, 25.0) << "low down";
    finger_.steer({-2.0, 1.0}, true, lump_, 1.0);
    tool = next(finger_, lump_);
    EXPECT_TRUE(tool.pressing);
    EXPECT_NEAR(tool.position_mm.x, 74.0, 1e-9);
    finger_.steer({0.0, 0.0}, true, lump_, 1.0);
    EXPECT_TRUE(next(finger_, lump_).pressing) << "held";
    finger_.release();  // the clay gave way
    finger_.steer({0.0, 0.0}, true, lump_, 1.0);
    EXPECT_FALSE(next(finger_, lump_).pressing) << "until the button is let go and pressed again";
    finger_.steer({0.0, 0.0}, false, lump_, 1.0);
    finger_.steer({0.0, 0.0}, true, lump_, 1.0);
    EXPECT_TRUE(next(finger_, lump_).pressing);
    finger_.press({0.0, 60.0});
    finger_.steer({50.0, 0.0}, false, lump_, 1.0);
    next(finger_, lump_);
    tool = next(finger_, lump_);
    EXPECT_TRUE(tool.pressing) << "a finger on the screen comes first";
    EXPECT_EQ(tool.position_mm.x, 0.0);
}

TEST(KioskPot, WarnsEarlyAndRelaxesLate) {
    haptic::LoadReport load{.index = 0.8,
                            .height_mm = 50.0,
                            .cause = clay::studio::Cause::kSpin,
                            .strength_kpa = 13.0,
                            .failure = {}};
    EXPECT_EQ(warning_of(load, kiosk::Warning::kNone), kiosk::Warning::kNone);
    load.index = 0.9;
    EXPECT_EQ(warning_of(load, kiosk::Warning::kNone), kiosk::Warning::kFast);
    load.index = 0.75;
    EXPECT_EQ(warning_of(load, kiosk::Warning::kFast), kiosk::Warning::kFast);
    load.index = 0.6;
    EXPECT_EQ(warning_of(load, kiosk::Warning::kFast), kiosk::Warning::kNone);
}

TEST(KioskPot, BlamesWaterForATwistOnlyWhereTheClayIsSoft) {
    using clay::studio::Cause;
    EXPECT_EQ(warning_for(Cause::kTwist, 3.0), kiosk::Warning::kWet);
    EXPECT_EQ(warning_for(Cause::kTwist, 13.0), kiosk::Warning::kThin) << "a narrow neck of good clay";
    EXPECT_EQ(warning_for(Cause::kSpin, 3.0), kiosk::Warning::kFast);
    EXPECT_EQ(warning_for(Cause::kWeight, 3.0), kiosk::Warning::kThin);
}

TEST(KioskPot, FindsTheThinnestPlaceOfAWall) {
    pot::Pot shape = pot(100, 60, 8, 10);
    shape.inner_mm[70] = 57.5F;
    EXPECT_NEAR(thinnest_wall_mm(shape), 2.5, 1e-4);
    EXPECT_EQ(thinnest_wall_mm(pot(80, 60, 8, 80)), 0.0);
}

// Runs frames with that tool in the hand.
tool::ToolState holding(KioskFinger& finger, tool::Tool held, const pot::Pot& shape) {
    return finger.request({.tool = held}, shape, 1.0 / 60.0);
}

TEST_F(KioskFingerTest, HoldsAndPressesItsTool) {
    EXPECT_EQ(holding(finger_, tool::Tool::kRib, shape_).tool, tool::Tool::kRib);
    finger_.press({70.0, 50.0});
    const auto tool = holding(finger_, tool::Tool::kSponge, shape_);
    EXPECT_EQ(tool.tool, tool::Tool::kSponge);
    EXPECT_TRUE(tool.guided && tool.pressing);
    EXPECT_EQ(holding(finger_, tool::Tool::kHand, shape_).tool, tool::Tool::kHand);
}

TEST_F(KioskFingerTest, HoldsTheWireBelowTheRimAndMovesItWithoutATouch) {
    EXPECT_FALSE(finger_.wire_mm());
    EXPECT_EQ(holding(finger_, tool::Tool::kWire, shape_).wire, tool::Wire::kNone);
    EXPECT_EQ(finger_.wire_mm(), 94.0);
    finger_.key(FingerKey::kDown, 1.0);
    finger_.key(FingerKey::kDown, 1.0);
    finger_.button(FingerKey::kUp, 1.0);
    holding(finger_, tool::Tool::kWire, shape_);
    EXPECT_EQ(finger_.wire_mm(), 93.0);
    finger_.press({65.0, 80.0});
    EXPECT_FALSE(holding(finger_, tool::Tool::kWire, shape_).pressing) << "nothing is cut by a finger";
    EXPECT_EQ(finger_.wire_mm(), 80.0);
    finger_.drag({65.0, 20.0});
    holding(finger_, tool::Tool::kWire, shape_);
    EXPECT_EQ(finger_.wire_mm(), 50.0) << "never below half the height";
}

TEST_F(KioskFingerTest, PullsTheWireThroughOnce) {
    finger_.cut_rim();
    EXPECT_EQ(holding(finger_, tool::Tool::kHand, shape_).wire, tool::Wire::kNone) << "it is not held";
    holding(finger_, tool::Tool::kWire, shape_);
    finger_.cut_rim();
    const auto tool = holding(finger_, tool::Tool::kHand, shape_);
    EXPECT_EQ(tool.wire, tool::Wire::kCutRim);
    EXPECT_EQ(tool.wire_height_mm, 94.0);
    EXPECT_EQ(holding(finger_, tool::Tool::kHand, shape_).wire, tool::Wire::kNone);
    EXPECT_FALSE(finger_.wire_mm());
}

}  // namespace
}  // namespace onggi::app
