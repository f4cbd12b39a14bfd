// Demonstrating hands on the visitor's clay: on request, or when the visitor makes no progress.
#include <gtest/gtest.h>

#include "game/kiosk/spoken.h"
#include "tests/unit/kiosk/visitor.h"

namespace onggi::kiosk {
namespace {

using Kind = Event::Kind;

TEST(Show, DoesTheNextStepForWhoAsks) {
    for (int done = 0; done <= kTeachingSteps; ++done) {
        Visitor visitor;
        visitor.starts_to_throw().does(Kind::kProgress, done).presses(Button::kShowMe);
        const int step = std::min(done, kTeachingSteps - 1);
        EXPECT_EQ(visitor.state.throwing.shown, step);
        EXPECT_EQ(visitor.last, (std::vector<Effect>{{Effect::Kind::kShowStep, step}}))
            << "after the lesson, the last: raising";
        EXPECT_EQ(spoken_key(visitor.state), "show.on");
        EXPECT_FALSE(shows_hint(visitor.state, visitor.now_s, visitor.rules));
    }
}

TEST(Show, StopsAtOnceForAnyKeyAnyTouchAndMyTurn) {
    const Event kSigns[] = {{Kind::kInput, Button::kNone, 1},   {Kind::kClayTouched, Button::kNone, 0},
                            Event::pressed(Button::kMyTurn),    Event::pressed(Button::kShowMe),
                            Event::pressed(Button::kWaterMore), Event::pressed(Button::kLanguages),
                            Event::pressed(Button::kDone)};
    for (const Event& sign : kSigns) {
        Visitor visitor;
        visitor.starts_to_throw().presses(Button::kShowMe).waits(1.0).does(sign);
        EXPECT_FALSE(visitor.state.throwing.shown) << static_cast<int>(sign.button);
        ASSERT_FALSE(visitor.last.empty());
        EXPECT_EQ(visitor.last.front().kind, Effect::Kind::kStopShow);
    }
}

TEST(Show, GoesOnWhileAMouseIsMovedOrSomebodyLooksIn) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kShowMe).does(Kind::kInput).presses(Button::kLookIn);
    EXPECT_TRUE(visitor.state.throwing.shown);
    EXPECT_TRUE(visitor.state.throwing.looks_in);
}

TEST(Show, IsTakenBackByOneUndoThatFindsItOver) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kShowMe).waits(1.0).presses(Button::kUndo);
    const std::vector<Effect> expected{{Effect::Kind::kStopShow, 0}, {Effect::Kind::kUndo, 0}};
    EXPECT_EQ(visitor.last, expected);
}

TEST(Show, EndsByItselfAndAfterSixSecondsAtMost) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kShowMe).waits(2.0).does(Kind::kShowOver);
    EXPECT_FALSE(visitor.state.throwing.shown);
    visitor.presses(Button::kShowMe).waits(5.8);
    EXPECT_TRUE(visitor.state.throwing.shown);
    visitor.waits(0.3);
    EXPECT_FALSE(visitor.state.throwing.shown);
    EXPECT_TRUE(visitor.caused(Effect::Kind::kStopShow));
}

TEST(Show, ComesByItselfAfterEightSecondsWithoutProgressOnceAStep) {
    Visitor visitor;
    visitor.starts_to_throw().waits(7.8);
    EXPECT_FALSE(visitor.state.throwing.shown);
    visitor.waits(0.3);
    EXPECT_EQ(visitor.state.throwing.shown, 0);
    visitor.does(Kind::kShowOver).waits(20.0);
    EXPECT_EQ(visitor.count(Effect::Kind::kShowStep), 1)
        << "after the demonstration the visitor is left alone";
    visitor.does(Kind::kClayTouched).waits(2.8);
    EXPECT_EQ(visitor.count(Effect::Kind::kShowStep), 1) << "not the moment the visitor lets go";
    visitor.waits(0.4);
    EXPECT_EQ(visitor.count(Effect::Kind::kShowStep), 2) << "who has tried may need it again";
}

TEST(Show, GoesThroughAllStepsForWhoOnlyLooks) {
    Visitor visitor;
    visitor.starts_to_throw();
    for (int step = 0; step < kTeachingSteps; ++step) {
        visitor.waits(8.2);
        EXPECT_EQ(visitor.state.throwing.shown, step);
        visitor.does(Kind::kProgress, step + 1).does(Kind::kShowOver);
    }
    visitor.waits(15.0);
    EXPECT_FALSE(visitor.state.throwing.shown) << "all is shown";
    visitor.waits(6.0);
    EXPECT_EQ(visitor.state.panel, Panel::kIdle) << "the wheel's hands are no sign of life";
}

TEST(Show, NeverComesByItselfUnderAHandOrOnClayThatHardlyStands) {
    Visitor holding;
    holding.starts_to_throw().does(Kind::kClayTouched).does(Kind::kHeld, 1).waits(30.0);
    EXPECT_FALSE(holding.caused(Effect::Kind::kShowStep));
    holding.does(Kind::kHeld, 0).waits(2.8);
    EXPECT_FALSE(holding.caused(Effect::Kind::kShowStep));
    holding.waits(0.3);
    EXPECT_TRUE(holding.caused(Effect::Kind::kShowStep));

    Visitor warned;
    warned.starts_to_throw().does(Kind::kWarned, static_cast<int>(Warning::kWet)).waits(30.0);
    EXPECT_FALSE(warned.caused(Effect::Kind::kShowStep));
}

TEST(Show, ComesOnlyWhenAskedForWhereTheMuseumWantsItSo) {
    Visitor visitor(Rules{.shows_by_itself = false});
    visitor.starts_to_throw().waits(30.0);
    EXPECT_FALSE(visitor.caused(Effect::Kind::kShowStep));
    visitor.presses(Button::kShowMe);
    EXPECT_TRUE(visitor.state.throwing.shown);
}

TEST(Show, ShowsNoCueToAHandThatIsAtWork) {
    Visitor visitor;
    visitor.starts_to_throw();
    EXPECT_TRUE(shows_hint(visitor.state, visitor.now_s, visitor.rules));
    visitor.does(Kind::kHeld, 1);
    EXPECT_FALSE(shows_hint(visitor.state, visitor.now_s, visitor.rules));
}

}  // namespace
}  // namespace onggi::kiosk
