// The lesson checks the clay, not the gesture: any way to the result counts.
#include <gtest/gtest.h>

#include <cmath>

#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "tests/support/millimetre_pot.h"

namespace onggi::app {
namespace {

pot::Pot lump() {
    return test::millimetre_pot(44, 62, 44, 0);
}

struct LessonTest : testing::Test {
    LessonTest() { EXPECT_EQ(lesson.steps_done(lump()), 0); }

    Lesson lesson;
};

TEST_F(LessonTest, CountsAFootNarrowerByThreeOrAHeightOfSixMoreAsPressed) {
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(44, 59.5, 44, 0)), 0);
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(44, 58.5, 44, 0)), 1);
    Lesson other;
    EXPECT_EQ(other.steps_done(lump()), 0);
    EXPECT_EQ(other.steps_done(test::millimetre_pot(49, 62, 49, 0)), 0);
    EXPECT_EQ(other.steps_done(test::millimetre_pot(51, 62, 51, 0)), 1);
}

TEST_F(LessonTest, CountsAWideAndDeepHollowAsOpened) {
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(45, 62, 30, 20)), 0) << "not deep enough";
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(45, 62, 15, 12)), 0) << "a hole for a thumb";
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(45, 62, 15, 22)), 0) << "a bore";
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(45, 62, 15, 26)), 2) << "which requires a press";
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(60, 62, 15, 26)), 2);
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(64, 55, 11, 46)), 3) << "1.4 of 45";
}

TEST_F(LessonTest, CountsAWallOfSeventyFiveAsRaisedHoweverItCameToIt) {
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(80, 45, 80, 0)), 1) << "a cone is no wall";
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(74, 50, 15, 41)), 2);
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(76, 50, 15, 41)), 3);
}

TEST_F(LessonTest, AsksForAnotherPullWhileTheWallIsThickerThanNineAndAHalf) {
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(100, 50, 15, 40)), 2);
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(100, 50, 15, 41)), 3);
}

TEST_F(LessonTest, TakesATallPotHoweverThickItsWallIs) {
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(160, 50, 15, 30)), 2);
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(195, 50, 15, 30)), 3);
}

TEST_F(LessonTest, NeverGoesBack) {
    EXPECT_EQ(lesson.steps_done(test::millimetre_pot(45, 62, 15, 26)), 2);
    EXPECT_EQ(lesson.steps_done(lump()), 2);
    lesson.begin();
    EXPECT_EQ(lesson.steps_done(lump()), 0);
}

TEST_F(LessonTest, AsksLessOfASmallLumpAndMoreOfALargeOne) {
    // Half a kilogram and two and a half, of the same form.
    const double small = std::cbrt(0.5);
    const double large = std::cbrt(2.5);
    for (const auto& [size, height_mm, steps] :
         {std::tuple(small, 61.0, 3), std::tuple(1.0, 61.0, 2), std::tuple(1.0, 76.0, 3),
          std::tuple(large, 76.0, 2), std::tuple(large, 103.0, 3)}) {
        lesson.begin();
        const double fresh_mm = std::round(44.0 * size);
        EXPECT_EQ(lesson.steps_done(test::millimetre_pot(fresh_mm, 62.0 * size, fresh_mm, 0)), 0);
        const double opened_mm = std::round(55.0 * size);
        EXPECT_EQ(lesson.steps_done(test::millimetre_pot(opened_mm, 62.0 * size, 11.0, 26.0 * size)), 2)
            << size;
        EXPECT_EQ(lesson.steps_done(test::millimetre_pot(height_mm, 55.0 * size, 11.0, 46.0 * size)), steps)
            << size << ' ' << height_mm;
    }
}

}  // namespace
}  // namespace onggi::app
