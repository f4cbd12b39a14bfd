// The calm cue's position and visibility, on a virtual clock.
#include "game/app/kiosk/presentation/kiosk_cue.h"
#include "tests/support/millimetre_pot.h"

#include <gtest/gtest.h>

namespace onggi::app {
namespace {

using clay::studio::Grip;
using clay::studio::GripGuard;
using clay::studio::GripReport;

class Cue : public testing::Test {
  protected:
    std::optional<CuePlace> look(const GripReport& grip, std::optional<int> step = {},
                                 std::optional<dvec2> hovers_mm = {}) {
        return cue_.look({.now_s = now_s_ += 1.0 / 60.0,
                          .shape = shape_,
                          .grip = grip,
                          .is_shown = is_shown_,
                          .wanted_step = step,
                          .hovers_mm = hovers_mm});
    }
    // Pulls a wall up for `seconds` at `mm_s`.
    std::optional<CuePlace> draws_up(double seconds, double mm_s, GripGuard guard = GripGuard::kNone) {
        std::optional<CuePlace> place;
        for (double s = 0.0; s < seconds; s += 1.0 / 60.0) {
            hand_mm_.y += mm_s / 60.0;
            place = look({.grip = Grip::kWall,
                          .guard = guard,
                          .hand_mm = hand_mm_,
                          .finger_mm = hand_mm_,
                          .low_mm = hand_mm_.y - 12.0,
                          .high_mm = hand_mm_.y + 40.0});
        }
        return place;
    }
    std::optional<CuePlace> rests(double seconds) {
        std::optional<CuePlace> place;
        for (double s = 0.0; s < seconds; s += 1.0 / 60.0)
            place = look({}, {}, dvec2(55.0, 50.0));
        return place;
    }
    pot::Pot shape_ = test::millimetre_pot(100, 50, 12, 40);
    KioskCue cue_;
    dvec2 hand_mm_{50.0, 20.0};
    double now_s_ = 0.0;
    bool is_shown_ = false;
};

TEST_F(Cue, LiesWhereTheLessonWantsTheFingerWithAnArrow) {
    shape_ = test::millimetre_pot(50, 62, 50, 0);
    const auto pressed = look({}, 0);
    ASSERT_TRUE(pressed);
    EXPECT_EQ(pressed->step, 0);
    EXPECT_EQ(pressed->hold->opening_mm, 0.0);
    EXPECT_LT(pressed->hold->low_mm, 0.3 * 50.0);
    EXPECT_GT(pressed->hold->high_mm, 0.3 * 50.0);
    const auto opened = look({}, 1);
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->hold->opening_mm, 17.0) << "the middle of the top";
    EXPECT_EQ(opened->hold->high_mm, 50.0);
    EXPECT_FALSE(look({})) << "nothing is wanted, and no hand is near";
}

TEST_F(Cue, FollowsAMouseThatHoversOverTheClay) {
    const auto place = look({}, {}, dvec2(52.0, 60.0));
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->hold->low_mm, 48.0, 1e-9);
    EXPECT_NEAR(place->hold->high_mm, 72.0, 1e-9);
    EXPECT_FALSE(place->step);
    EXPECT_FALSE(look({}, {}, dvec2(300.0, 60.0))) << "off the clay";
    EXPECT_FALSE(look({}, {}, dvec2(52.0, -20.0))) << "under the wheel's head";
    const auto taught = look({}, 2, dvec2(52.0, 60.0));
    ASSERT_TRUE(taught);
    EXPECT_EQ(taught->step, 2) << "the arrow stays where the lesson wants the finger";
    EXPECT_GT(taught->hold->low_mm, 40.0);
}

TEST_F(Cue, StaysWhereKeysActEvenForAnExperiencedVisitor) {
    EXPECT_FALSE(draws_up(2.0, 20.0));
    const auto place = cue_.look({.now_s = now_s_ += 0.016,
                                  .shape = shape_,
                                  .grip = {},
                                  .hovers_mm = dvec2(50.0, 80.0),
                                  .marker_mm = dvec2(50.0, 30.0)});
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->hold->low_mm, 18.0, 1e-9);
}

TEST_F(Cue, PointsAtThePlaceOfTheKeysAlsoWhileTheHandWorksThere) {
    CueMoment moment{.now_s = now_s_ += 0.016,
                     .shape = shape_,
                     .grip = {},
                     .wanted_step = 2,
                     .marker_mm = dvec2(50.0, 30.0)};
    auto place = cue_.look(moment);
    ASSERT_TRUE(place && place->marker_mm);
    EXPECT_EQ(*place->marker_mm, dvec2(50.0, 30.0));
    EXPECT_FALSE(place->step) << "one arrow is enough";
    EXPECT_FALSE(draws_up(2.0, 20.0)) << "a visitor who knows how";
    const clay::studio::GripReport works{.grip = Grip::kWall, .hand_mm = {50.0, 30.0}};
    place =
        cue_.look({.now_s = now_s_ += 0.016, .shape = shape_, .grip = works, .marker_mm = dvec2(50.0, 30.0)});
    ASSERT_TRUE(place && place->marker_mm);
    place = cue_.look({.now_s = now_s_ += 0.016,
                       .shape = shape_,
                       .grip = works,
                       .is_shown = true,
                       .marker_mm = dvec2(50.0, 30.0)});
    EXPECT_FALSE(place && place->marker_mm) << "the hands are the wheel's own";
}

TEST_F(Cue, SurroundsTheClayThatTheHandsHold) {
    const auto place = draws_up(0.3, 1.0);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->hold->low_mm, hand_mm_.y - 12.0, 0.5);
    EXPECT_NEAR(place->hold->high_mm, hand_mm_.y + 20.0, 0.5) << "beyond it they hardly move the wall";
    EXPECT_EQ(place->hand_side, 1.0);
    const auto opens = look({.grip = Grip::kOpen, .hand_mm = {0.0, 30.0}});
    ASSERT_TRUE(opens);
    EXPECT_EQ(opens->hold->opening_mm, 40.0) << "the mouth, as wide as it is";
}

TEST_F(Cue, GoesAfterASecondAndAHalfOfProgressAndComesBackAfterSixWithout) {
    EXPECT_TRUE(draws_up(1.4, 20.0));
    EXPECT_FALSE(draws_up(0.3, 20.0));
    EXPECT_FALSE(rests(5.5)) << "who knows how is not shown again";
    EXPECT_TRUE(rests(0.7));
    EXPECT_TRUE(draws_up(1.0, 20.0));
    EXPECT_TRUE(draws_up(4.0, 1.0)) << "hands that get nowhere are no progress";
}

TEST_F(Cue, StaysRoundTheWheelsOwnHands) {
    is_shown_ = true;
    EXPECT_TRUE(draws_up(4.0, 20.0));
}

TEST_F(Cue, SaysWhyTheClayDoesLessOnceThatLasts) {
    EXPECT_FALSE(draws_up(2.0, 20.0));
    EXPECT_FALSE(draws_up(0.5, 20.0, GripGuard::kNoMoreClay)) << "a moment is no reason";
    const auto place = draws_up(0.2, 20.0, GripGuard::kNoMoreClay);
    ASSERT_TRUE(place) << "also to who has got on without";
    EXPECT_EQ(place->guard, screens::CueGuard::kNoMoreClay);
    EXPECT_FALSE(draws_up(0.5, 20.0, GripGuard::kAsWide)) << "another reason takes as long";
    EXPECT_EQ(draws_up(0.3, 20.0, GripGuard::kAsWide)->guard, screens::CueGuard::kAsWide);
    EXPECT_FALSE(look({})) << "and only while the hand presses";
}

TEST_F(Cue, EasesFromOnePlaceToTheNextUnlessLessMotionIsWanted) {
    static_cast<void>(look({}, {}, dvec2(52.0, 30.0)));
    const auto eased = look({}, {}, dvec2(52.0, 80.0));
    ASSERT_TRUE(eased);
    EXPECT_LT(eased->hold->low_mm, 40.0);
    const auto jumped = cue_.look({.now_s = now_s_ + 0.016,
                                   .shape = shape_,
                                   .grip = {},
                                   .hovers_mm = dvec2(52.0, 80.0),
                                   .still = true});
    ASSERT_TRUE(jumped);
    EXPECT_EQ(jumped->hold->low_mm, 68.0);
}

TEST_F(Cue, LeadsFromTheFingerToHandsThatLagBehindIt) {
    const GripReport together{.grip = Grip::kWall,
                              .hand_mm = dvec2(50.0, 40.0),
                              .finger_mm = dvec2(50.0, 46.0),
                              .low_mm = 28.0,
                              .high_mm = 66.0};
    GripReport apart = together;
    apart.finger_mm = dvec2(50.0, 70.0);
    EXPECT_FALSE(look(together)->thread) << "a hand covers the finger";
    const auto place = look(apart);
    ASSERT_TRUE(place && place->thread);
    EXPECT_EQ(place->thread->finger_mm, apart.finger_mm);
    EXPECT_EQ(place->thread->hand_mm, apart.hand_mm);
    EXPECT_EQ(place->thread->strength, 1.0);
    GripReport between = together;
    between.finger_mm.y = between.hand_mm.y + 14.0;
    EXPECT_NEAR(thread_of(between)->strength, 0.5, 1e-9) << "it comes little by little";
    is_shown_ = true;
    EXPECT_FALSE(look(apart)->thread) << "the wheel's own hands show where they are";
    is_shown_ = false;
    apart.grip = Grip::kNone;
    const auto lifted = look(apart);
    EXPECT_FALSE(lifted && lifted->thread);
}

// An experienced visitor, without the belt, still sees the lead of the finger.
TEST_F(Cue, ThreadStaysForAnExperiencedVisitor) {
    draws_up(3.0, 20.0);
    GripReport apart{.grip = Grip::kWall,
                     .hand_mm = hand_mm_ += dvec2(0.0, 0.3),
                     .finger_mm = hand_mm_ + dvec2(0.0, 40.0),
                     .low_mm = 30.0,
                     .high_mm = 90.0};
    const auto place = look(apart);
    ASSERT_TRUE(place);
    EXPECT_TRUE(place->thread);
    EXPECT_FALSE(place->hold);
}

}  // namespace
}  // namespace onggi::app
