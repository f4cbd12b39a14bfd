// Demonstrating hands on the visitor's clay: on request, or when the visitor makes no progress.
#include <gtest/gtest.h>

#include "game/visit/steps.h"
#include "game/visit/throw/throw.h"
#include "tests/unit/visit/visitor.h"

namespace onggi::visit {
namespace {

TEST(Show, DemonstratesTheNextStepOnRequest) {
    for (int done = 0; done <= kTeachingSteps; ++done) {
        Visitor visitor;
        visitor.starts_to_throw().does(event::Progress{done}).presses(Button::kShowMe);
        const auto step = static_cast<ShownStep>(std::min(done, kTeachingSteps - 1));
        EXPECT_EQ(visitor.state.throwing.shown, step);
        EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::ShowStep{step}}))
            << "after the lesson, the last: raising";
        EXPECT_EQ(spoken_key(visitor.state), "show.on");
        EXPECT_FALSE(shows_hint(visitor.state, visitor.now_s, visitor.rules));
    }
}

TEST(Show, StopsAtOnceForAnyKeyAnyTouchAndMyTurn) {
    const Event kSigns[] = {event::Input{.by_key = true},       event::ClayTouched{},
                            event::Pressed{Button::kMyTurn},    event::Pressed{Button::kShowMe},
                            event::Pressed{Button::kWaterMore}, event::Pressed{Button::kLanguages},
                            event::Pressed{Button::kDone}};
    for (const Event& sign : kSigns) {
        Visitor visitor;
        visitor.starts_to_throw().presses(Button::kShowMe).waits(1.0).does(sign);
        EXPECT_FALSE(visitor.state.throwing.shown) << sign.index();
        ASSERT_FALSE(visitor.last.empty());
        EXPECT_TRUE(std::holds_alternative<effect::StopShow>(visitor.last.front()));
    }
}

TEST(Show, GoesOnWhileAMouseIsMovedOrSomebodyLooksIn) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kShowMe).does(event::Input{}).presses(Button::kLookIn);
    EXPECT_TRUE(visitor.state.throwing.shown);
    EXPECT_TRUE(visitor.state.throwing.looks_in);
}

TEST(Show, IsTakenBackByOneUndoThatFindsItOver) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kShowMe).waits(1.0).presses(Button::kUndo);
    const std::vector<Effect> expected{effect::StopShow{}, effect::Undo{}};
    EXPECT_EQ(visitor.last, expected);
}

TEST(Show, EndsByItselfAndAfterTwentySecondsAtMost) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kShowMe).waits(2.0).does(event::ShowOver{});
    EXPECT_FALSE(visitor.state.throwing.shown);
    visitor.presses(Button::kShowMe).waits(19.8);
    EXPECT_TRUE(visitor.state.throwing.shown);
    visitor.waits(0.3);
    EXPECT_FALSE(visitor.state.throwing.shown);
    EXPECT_TRUE(visitor.caused<effect::StopShow>());
}

TEST(Show, ComesByItselfAfterEightSecondsWithoutProgressOnceAStep) {
    Visitor visitor;
    visitor.starts_to_throw().waits(7.8);
    EXPECT_FALSE(visitor.state.throwing.shown);
    visitor.waits(0.3);
    EXPECT_EQ(visitor.state.throwing.shown, ShownStep::kPress);
    visitor.does(event::ShowOver{}).waits(20.0);
    EXPECT_EQ(visitor.count<effect::ShowStep>(), 1) << "after the demonstration the visitor is left alone";
    visitor.does(event::ClayTouched{}).waits(2.8);
    EXPECT_EQ(visitor.count<effect::ShowStep>(), 1) << "not the moment the visitor lets go";
    visitor.waits(0.4);
    EXPECT_EQ(visitor.count<effect::ShowStep>(), 2) << "who has tried may need it again";
}

TEST(Show, DemonstratesAllStepsToAnIdleVisitor) {
    Visitor visitor;
    visitor.starts_to_throw();
    for (int step = 0; step < kTeachingSteps; ++step) {
        visitor.waits(8.2);
        EXPECT_EQ(visitor.state.throwing.shown, static_cast<ShownStep>(step));
        visitor.does(event::Progress{step + 1}).does(event::ShowOver{});
    }
    visitor.waits(15.0);
    EXPECT_FALSE(visitor.state.throwing.shown) << "all is shown";
    visitor.waits(6.0);
    EXPECT_EQ(visitor.state.panel, Panel::kIdle) << "the wheel's hands are no sign of life";
}

TEST(Show, ComesUnderAHandThatRubsOrHoldsStillForTwentySecondsWithoutProgress) {
    Visitor holding;
    holding.starts_to_throw().does(event::ClayTouched{}).does(event::Held{.holds = true}).waits(19.0);
    EXPECT_FALSE(holding.caused<effect::ShowStep>());
    holding.waits(1.2);
    EXPECT_EQ(holding.state.throwing.shown, ShownStep::kPress);

    Visitor rubbing;
    rubbing.starts_to_throw().does(event::Progress{1});
    for (int stroke = 0; stroke < 20; ++stroke)
        rubbing.does(event::ClayTouched{}).waits(0.9);
    EXPECT_FALSE(rubbing.caused<effect::ShowStep>());
    rubbing.does(event::ClayTouched{}).waits(2.5);
    EXPECT_EQ(rubbing.state.throwing.shown, ShownStep::kOpen);
}

TEST(Show, NeverComesByItselfUnderAHandAtWorkOrOnClayThatHardlyStands) {
    Visitor holding;
    holding.starts_to_throw().does(event::ClayTouched{}).does(event::Held{.holds = true}).waits(15.0);
    EXPECT_FALSE(holding.caused<effect::ShowStep>());
    holding.does(event::Held{.holds = false}).waits(2.8);
    EXPECT_FALSE(holding.caused<effect::ShowStep>());
    holding.waits(0.3);
    EXPECT_TRUE(holding.caused<effect::ShowStep>());

    Visitor warned;
    warned.starts_to_throw().does(event::Warned{Warning::kWet}).waits(30.0);
    EXPECT_FALSE(warned.caused<effect::ShowStep>());
}

TEST(Show, ComesOnlyWhenAskedForWhereTheMuseumWantsItSo) {
    Visitor visitor(Rules{.shows_by_itself = false});
    visitor.starts_to_throw().waits(30.0);
    EXPECT_FALSE(visitor.caused<effect::ShowStep>());
    visitor.presses(Button::kShowMe);
    EXPECT_TRUE(visitor.state.throwing.shown);
}

TEST(Show, ShowsNoCueToAHandThatIsAtWork) {
    Visitor visitor;
    visitor.starts_to_throw();
    EXPECT_TRUE(shows_hint(visitor.state, visitor.now_s, visitor.rules));
    visitor.does(event::Held{.holds = true});
    EXPECT_FALSE(shows_hint(visitor.state, visitor.now_s, visitor.rules));
}

}  // namespace
}  // namespace onggi::visit
