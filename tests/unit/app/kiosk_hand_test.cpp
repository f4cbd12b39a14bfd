// The visitor's hand, before it reaches the haptic loop.
#include "game/app/kiosk/hand/kiosk_hand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/haptic/tools.h"
#include "tests/support/millimetre_pot.h"

namespace onggi::app {
namespace {

// A pot of a hundred rings, a millimetre each: solid to floor_mm, a wall above.
pot::Pot pot(double height_mm, double outer_mm, double wall_mm, double floor_mm) {
    return test::millimetre_pot(height_mm, outer_mm, floor_mm, outer_mm - wall_mm);
}

// Frames of a sixtieth of a second.
haptics::ToolState after(KioskHand& hand, const pot::Pot& shape, double seconds) {
    haptics::ToolState tool = hand.request({}, shape, 1.0 / 60.0);
    for (double gone_s = 1.0 / 60.0; gone_s < seconds - 1e-9; gone_s += 1.0 / 60.0)
        tool = hand.request({}, shape, 1.0 / 60.0);
    return tool;
}
haptics::ToolState next(KioskHand& hand, const pot::Pot& shape) {
    return after(hand, shape, 1.0 / 60.0);
}

class KioskHandTest : public ::testing::Test {
  protected:
    const pot::Pot shape_ = pot(100, 60, 8, 10);
    const pot::Pot lump_ = pot(50, 62, 8, 50);
    KioskHand hand_;
};

TEST_F(KioskHandTest, IsAFingerThatDoesNotPressWhileItOnlyHoversOrRests) {
    EXPECT_FALSE(next(hand_, shape_).pressing) << "no visitor yet";
    hand_.hover({20.0, 50.0});
    const auto tool = next(hand_, shape_);
    EXPECT_TRUE(tool.guided);
    EXPECT_FALSE(tool.pressing);
    EXPECT_EQ(tool.position_mm, dvec3(20.0, 50.0, 0.0));
    EXPECT_FALSE(hand_.works());
}

TEST_F(KioskHandTest, PressesWhereTheFingerIsAndEndsWithItAtOnce) {
    hand_.press({80.0, 50.0});
    auto tool = next(hand_, shape_);
    EXPECT_TRUE(tool.guided && tool.pressing);
    EXPECT_EQ(tool.position_mm, dvec3(80.0, 50.0, 0.0));
    EXPECT_EQ(tool.assist_gap_mm, 0.0) << "the clay knows of the other hand";
    EXPECT_EQ(tool.side, haptics::SideHint::kByTheWayItCame);
    hand_.drag({70.0, 60.0});
    EXPECT_EQ(next(hand_, shape_).position_mm, dvec3(70.0, 60.0, 0.0));
    hand_.release();
    tool = next(hand_, shape_);
    EXPECT_FALSE(tool.pressing);
    EXPECT_EQ(tool.position_mm, dvec3(70.0, 60.0, 0.0));
    EXPECT_FALSE(hand_.works());
}

TEST_F(KioskHandTest, LiesAsideWhenItHasLongDoneNothing) {
    hand_.press({80.0, 50.0});
    EXPECT_EQ(after(hand_, shape_, 10.0).position_mm.x, 80.0) << "a finger that presses stays";
    hand_.release();
    EXPECT_EQ(after(hand_, shape_, 2.0).position_mm.x, 80.0);
    const auto rests = after(hand_, shape_, 3.0);
    EXPECT_EQ(rests.position_mm, resting_hand().position_mm);
    EXPECT_FALSE(rests.pressing);
    hand_.hover({10.0, 40.0});
    EXPECT_EQ(next(hand_, shape_).position_mm.x, 10.0);
}

TEST_F(KioskHandTest, LetsGoOfAFingerThatLeapsOrIsNoNumber) {
    hand_.press({80.0, 50.0});
    for (int step = 1; step <= 10; ++step) {
        hand_.drag({80.0 - 15.0 * step, 50.0});
        EXPECT_TRUE(next(hand_, shape_).pressing) << "as fast as a hand is";
    }
    hand_.drag({-10.0, 50.0});
    hand_.drag({60.0, 50.0});
    EXPECT_FALSE(next(hand_, shape_).pressing);
    hand_.drag({55.0, 50.0});
    EXPECT_FALSE(next(hand_, shape_).pressing) << "until it presses again";
    hand_.press({55.0, 50.0});
    EXPECT_TRUE(next(hand_, shape_).pressing);
    constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    hand_.drag({kNoNumber, 50.0});
    EXPECT_FALSE(next(hand_, shape_).pressing);
    hand_.press({kNoNumber, kNoNumber});
    hand_.hover({kNoNumber, 1.0});
    hand_.steer({kNoNumber, 1.0}, false, shape_, 1.0);
    const auto tool = next(hand_, shape_);
    EXPECT_FALSE(tool.pressing);
    EXPECT_TRUE(std::isfinite(tool.position_mm.x) && std::isfinite(tool.position_mm.y));
}

TEST_F(KioskHandTest, StaysWithinReachAndAboveTheWheelHead) {
    hand_.press({9000.0, -50.0});
    const auto tool = next(hand_, shape_);
    EXPECT_EQ(tool.position_mm.x, 260.0);
    EXPECT_EQ(tool.position_mm.y, 0.0);
}

TEST_F(KioskHandTest, TakesItsSettingsFromTheLedge) {
    const auto least = hand_.request({.tool = 1, .water = 1, .speed = 1}, shape_, 0.016);
    const auto most = hand_.request({.tool = 3, .water = 5, .speed = 5}, shape_, 0.016);
    EXPECT_LT(least.radius_mm, most.radius_mm);
    EXPECT_EQ(least.water, 0.0);
    EXPECT_EQ(most.water, 1.0);
    EXPECT_LT(least.wheel_speed_rev_min, most.wheel_speed_rev_min);
    EXPECT_TRUE(most.wheel_button);
}

TEST_F(KioskHandTest, PlaysAStepOfTheLessonAndStops) {
    hand_.show(ShownStep::kPress, lump_, 1.0);
    auto tool = next(hand_, lump_);
    EXPECT_TRUE(hand_.shows());
    EXPECT_FALSE(tool.pressing) << "the hands are seen to come";
    EXPECT_GT(tool.position_mm.x, 62.0);
    tool = after(hand_, lump_, 1.2);
    EXPECT_TRUE(tool.pressing);
    int frames = 0;
    while (hand_.shows() && ++frames < 360)
        tool = next(hand_, lump_);
    EXPECT_LT(frames, 360) << "six seconds at most";
    EXPECT_FALSE(next(hand_, lump_).pressing);
    EXPECT_NEAR(tool.position_mm.x, 54.0, 0.5);
}

TEST_F(KioskHandTest, GivesWayToWhateverTheVisitorDoes) {
    const std::vector<std::function<void()>> ways{[&] {
                                                      hand_.press({0.0, 60.0});
                                                  },
                                                  [&] { hand_.key(HandKey::kUp, 1.0); },
                                                  [&] { hand_.button(HandKey::kLeft, 1.0); },
                                                  [&] {
                                                      hand_.steer({1.0, 0.0}, false, lump_, 1.0);
                                                  },
                                                  [&] { hand_.stop_showing(); },
                                                  [&] { hand_.release(); }};
    for (std::size_t way = 0; way < ways.size(); ++way) {
        hand_.leave_clay();
        hand_.show(ShownStep::kRaise, lump_, 1.0);
        ASSERT_TRUE(after(hand_, lump_, 1.5).pressing);
        ways[way]();
        EXPECT_FALSE(hand_.shows()) << way;
        EXPECT_FALSE(next(hand_, lump_).pressing) << "between two touches there is none: " << way;
    }
    hand_.release();
    hand_.show(ShownStep::kRaise, lump_, 1.0);
    after(hand_, lump_, 1.5);
    hand_.hover({0.0, 0.0});
    EXPECT_TRUE(hand_.shows()) << "a trembling mouse is not a visitor";
    hand_.press({0.0, 60.0});
    next(hand_, lump_);
    const auto tool = next(hand_, lump_);
    EXPECT_TRUE(tool.pressing);
    EXPECT_EQ(tool.position_mm, dvec3(0.0, 60.0, 0.0));
}

TEST_F(KioskHandTest, MakesATouchOfEveryKeyAndKeepsThemApart) {
    EXPECT_FALSE(hand_.marker_mm());
    hand_.key(HandKey::kLeft, 1.0);
    hand_.key(HandKey::kLeft, 1.0);
    int touches = 0;
    bool pressed = false;
    for (int frame = 0; frame < 120; ++frame) {
        const bool presses = next(hand_, shape_).pressing;
        touches += presses && !pressed ? 1 : 0;
        pressed = presses;
    }
    EXPECT_EQ(touches, 2);
    ASSERT_TRUE(hand_.marker_mm());
    EXPECT_EQ(*hand_.marker_mm(), dvec2(60.0, 30.0)) << "low on that side";
    for (int more = 0; more < 50; ++more)
        hand_.key(HandKey::kLeft, 1.0);
    EXPECT_FALSE(after(hand_, shape_, 2.5).pressing) << "a key that was held does not work on for long";
    hand_.press({10.0, 20.0});
    next(hand_, shape_);
    EXPECT_FALSE(hand_.marker_mm()) << "a finger needs none";
    hand_.key(HandKey::kLeft, 1.0);
    EXPECT_EQ(next(hand_, shape_).position_mm.x, 10.0) << "and has the hand for itself";
}

TEST_F(KioskHandTest, ForgetsItsKeysWithTheClay) {
    hand_.key(HandKey::kUp, 1.0);
    next(hand_, shape_);
    EXPECT_TRUE(hand_.marker_mm());
    hand_.key(HandKey::kLeft, 1.0);
    hand_.leave_clay();
    EXPECT_FALSE(after(hand_, shape_, 0.2).pressing);
    EXPECT_FALSE(hand_.marker_mm());
}

TEST_F(KioskHandTest, IsSteeredByAGamepadAndPressedByItsButton) {
    hand_.steer({-1.0, 0.0}, false, lump_, 1.0);
    auto tool = next(hand_, lump_);
    EXPECT_FALSE(tool.pressing);
    EXPECT_NEAR(tool.position_mm.x, 76.0, 1e-9) << "beside the clay";
    EXPECT_LT(tool.position_mm.y, 25.0) << "low down";
    hand_.steer({-2.0, 1.0}, true, lump_, 1.0);
    tool = next(hand_, lump_);
    EXPECT_TRUE(tool.pressing);
    EXPECT_NEAR(tool.position_mm.x, 74.0, 1e-9);
    hand_.steer({0.0, 0.0}, true, lump_, 1.0);
    EXPECT_TRUE(next(hand_, lump_).pressing) << "held";
    hand_.release();  // the clay gave way
    hand_.steer({0.0, 0.0}, true, lump_, 1.0);
    EXPECT_FALSE(next(hand_, lump_).pressing) << "until the button is let go and pressed again";
    hand_.steer({0.0, 0.0}, false, lump_, 1.0);
    hand_.steer({0.0, 0.0}, true, lump_, 1.0);
    EXPECT_TRUE(next(hand_, lump_).pressing);
    hand_.press({0.0, 60.0});
    hand_.steer({50.0, 0.0}, false, lump_, 1.0);
    next(hand_, lump_);
    tool = next(hand_, lump_);
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
haptics::ToolState holding(KioskHand& hand, kiosk::Held held, const pot::Pot& shape) {
    return hand.request({.held = held}, shape, 1.0 / 60.0);
}

TEST_F(KioskHandTest, HoldsWhatItIsGivenAndPressesWithIt) {
    EXPECT_EQ(holding(hand_, kiosk::Held::kRib, shape_).tool, haptic::kRib);
    hand_.press({70.0, 50.0});
    const auto tool = holding(hand_, kiosk::Held::kSponge, shape_);
    EXPECT_EQ(tool.tool, haptic::kSponge);
    EXPECT_TRUE(tool.guided && tool.pressing);
    EXPECT_EQ(holding(hand_, kiosk::Held::kHand, shape_).tool, haptics::ToolKind::kHand);
}

TEST_F(KioskHandTest, HoldsTheWireBelowTheRimAndMovesItWithoutATouch) {
    EXPECT_FALSE(hand_.wire_mm());
    EXPECT_EQ(holding(hand_, kiosk::Held::kWire, shape_).command, haptics::WorkCommand::kNone);
    EXPECT_EQ(hand_.wire_mm(), 94.0);
    hand_.key(HandKey::kDown, 1.0);
    hand_.key(HandKey::kDown, 1.0);
    hand_.button(HandKey::kUp, 1.0);
    holding(hand_, kiosk::Held::kWire, shape_);
    EXPECT_EQ(hand_.wire_mm(), 93.0);
    hand_.press({65.0, 80.0});
    EXPECT_FALSE(holding(hand_, kiosk::Held::kWire, shape_).pressing) << "nothing is cut by a finger";
    EXPECT_EQ(hand_.wire_mm(), 80.0);
    hand_.drag({65.0, 20.0});
    holding(hand_, kiosk::Held::kWire, shape_);
    EXPECT_EQ(hand_.wire_mm(), 50.0) << "never below half the height";
}

TEST_F(KioskHandTest, PullsTheWireThroughOnce) {
    hand_.cut_rim();
    EXPECT_EQ(holding(hand_, kiosk::Held::kHand, shape_).command, haptics::WorkCommand::kNone)
        << "it is not held";
    holding(hand_, kiosk::Held::kWire, shape_);
    hand_.cut_rim();
    const auto tool = holding(hand_, kiosk::Held::kHand, shape_);
    EXPECT_EQ(tool.command, haptic::kCutRim);
    EXPECT_EQ(tool.command_height_mm, 94.0);
    EXPECT_EQ(holding(hand_, kiosk::Held::kHand, shape_).command, haptics::WorkCommand::kNone);
    EXPECT_FALSE(hand_.wire_mm());
}

}  // namespace
}  // namespace onggi::app
