// The visitor's hand, before it reaches the haptic loop.
#include "game/app/kiosk_hand.h"

#include <gtest/gtest.h>

#include "game/app/kiosk_pot.h"

namespace onggi::app {
namespace {

// A pot of a hundred rings, a millimetre each: solid to floor_mm, a wall above.
haptic::PotShape pot(double height_mm, double outer_mm, double wall_mm, double floor_mm) {
    haptic::PotShape shape;
    shape.rings = static_cast<int>(height_mm);
    shape.height_mm = height_mm;
    shape.floor_mm = floor_mm;
    shape.is_hollow = true;
    for (int i = 0; i < shape.rings; ++i) {
        shape.outer_mm_.push_back(static_cast<float>(outer_mm));
        shape.inner_mm_.push_back(i < floor_mm ? 0.0F : static_cast<float>(outer_mm - wall_mm));
        shape.top_mm_.push_back(static_cast<float>(i + 1));
    }
    return shape;
}

TEST(KioskHand, WaitsInFrontOfTheClayWhileItOnlyHovers) {
    KioskHand hand;
    hand.hover({20.0, 50.0, 0.0}, {0.0, 0.0, 1.0});
    const auto tool = hand.wish({}, pot(100, 60, 8, 10), 0.016);
    EXPECT_FALSE(hand.works());
    EXPECT_GT(tool.position_mm.z, 100.0);
    EXPECT_EQ(tool.assist_gap_mm, 0.0);
}

TEST(KioskHand, WorksWhereItIsPressedFromOutside) {
    KioskHand hand;
    hand.press({80.0, 50.0, 0.0}, pot(100, 60, 8, 10));
    const auto tool = hand.wish({}, pot(100, 60, 8, 10), 0.016);
    EXPECT_EQ(tool.position_mm, dvec3(80.0, 50.0, 0.0));
    EXPECT_EQ(tool.side, haptics::SideHint::kByTheWayItCame);
    EXPECT_GT(tool.assist_gap_mm, 0.0) << "the other hand holds the wall";
    EXPECT_TRUE(tool.wheel_button);
}

TEST(KioskHand, GoesInFromAboveWhenItLandsInTheMouth) {
    KioskHand hand;
    const haptic::PotShape shape = pot(100, 60, 8, 10);
    hand.press({20.0, 60.0, 0.0}, shape);
    auto tool = hand.wish({}, shape, 0.016);
    EXPECT_EQ(tool.side, haptics::SideHint::kInside);
    EXPECT_GT(tool.position_mm.y, 100.0) << "above the rim first";
    tool = hand.wish({}, shape, 0.5);
    EXPECT_EQ(tool.position_mm.y, 60.0);
    hand.release();
    EXPECT_FALSE(hand.works());
}

TEST(KioskHand, PressesSolidClayFromOutsideWhereverItLands) {
    KioskHand hand;
    hand.press({10.0, 60.0, 0.0}, pot(80, 60, 8, 80));
    EXPECT_EQ(hand.wish({}, pot(80, 60, 8, 80), 0.016).side, haptics::SideHint::kByTheWayItCame);
}

TEST(KioskHand, WorksForAMomentAfterEachNudge) {
    KioskHand hand;
    const haptic::PotShape shape = pot(100, 60, 8, 10);
    hand.nudge({-5.0, 0.0, 0.0}, shape, 1.0);
    EXPECT_TRUE(hand.works());
    static_cast<void>(hand.wish({}, shape, 1.0));
    EXPECT_TRUE(hand.works());
    static_cast<void>(hand.wish({}, shape, 1.0));
    EXPECT_FALSE(hand.works());
}

TEST(KioskHand, ComesToTheClayWithTheFirstNudge) {
    const haptic::PotShape shape = pot(100, 60, 8, 80);
    for (const double side : {1.0, -1.0}) {
        KioskHand hand;
        hand.nudge({-5.0 * side, 0.0, 0.0}, shape, side);
        const auto tool = hand.wish({}, shape, 0.016);
        EXPECT_LT(side * tool.position_mm.x, 60.0 + tool.radius_mm) << "it presses the clay in";
        EXPECT_GT(side * tool.position_mm.x, 60.0);
        EXPECT_LT(tool.position_mm.y, 50.0) << "low down";
        hand.nudge({0.0, 5.0, 0.0}, shape, side);
        EXPECT_EQ(hand.wish({}, shape, 0.016).position_mm.x, tool.position_mm.x) << "from there on in steps";
        static_cast<void>(hand.wish({}, shape, 5.0));
        hand.nudge({0.0, 80.0, 0.0}, shape, side);
        EXPECT_GT(hand.wish({}, shape, 0.016).position_mm.y, 100.0) << "also after a rest";
        hand.leave_clay();
        static_cast<void>(hand.wish({}, shape, 5.0));
        hand.nudge({0.0, 0.0, 0.0}, shape, side);
        EXPECT_LT(hand.wish({}, shape, 0.016).position_mm.y, 50.0) << "new clay";
    }
}

TEST(KioskHand, TakesItsSettingsFromTheLedge) {
    KioskHand hand;
    const haptic::PotShape shape = pot(100, 60, 8, 10);
    const auto least = hand.wish({.tool = 1, .water = 1, .speed = 1}, shape, 0.016);
    const auto most = hand.wish({.tool = 3, .water = 5, .speed = 5}, shape, 0.016);
    EXPECT_LT(least.radius_mm, most.radius_mm);
    EXPECT_EQ(least.water, 0.0);
    EXPECT_EQ(most.water, 1.0);
    EXPECT_LT(least.wheel_speed_rev_min, most.wheel_speed_rev_min);
}

TEST(KioskHand, StaysWithinReachAndAboveTheWheelHead) {
    KioskHand hand;
    const haptic::PotShape shape = pot(100, 60, 8, 10);
    hand.press({9000.0, -50.0, 0.0}, shape);
    const auto tool = hand.wish({}, shape, 0.016);
    EXPECT_LE(tool.position_mm.x, 260.0);
    EXPECT_GE(tool.position_mm.y, tool.radius_mm);
}

TEST(KioskPot, TeachesByWhatTheClayShows) {
    Lesson lesson;
    EXPECT_EQ(lesson.steps_done(pot(80, 60, 8, 80)), 0);
    EXPECT_EQ(lesson.steps_done(pot(80, 55, 8, 80)), 1) << "pressed in";
    EXPECT_EQ(lesson.steps_done(pot(84, 55, 8, 60)), 2) << "opened by more than a thumb";
    EXPECT_EQ(lesson.steps_done(pot(86, 55, 8, 30)), 2);
    EXPECT_EQ(lesson.steps_done(pot(110, 50, 8, 30)), 3) << "raised";
    EXPECT_EQ(lesson.steps_done(pot(60, 60, 8, 60)), 3) << "never back";
    lesson.begin();
    EXPECT_EQ(lesson.steps_done(pot(80, 60, 8, 80)), 0);
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
    haptic::PotShape shape = pot(100, 60, 8, 10);
    shape.inner_mm_[70] = 57.5F;
    EXPECT_NEAR(thinnest_wall_mm(shape), 2.5, 1e-4);
    EXPECT_EQ(thinnest_wall_mm(pot(80, 60, 8, 80)), 0.0);
}

}  // namespace
}  // namespace onggi::app
