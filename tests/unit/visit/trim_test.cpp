// Turning the foot: when it is offered, and how it ends.
#include <gtest/gtest.h>

#include "game/visit/steps.h"
#include "tests/unit/visit/visitor.h"

namespace onggi::visit {
namespace {

TEST(Trim, IsOfferedForAFootWithSpareClay) {
    Visitor visitor;
    visitor.fires().waits(5.0);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate) << "a thin foot is left alone";
    visitor = Visitor();
    visitor.fires().does(event::ThickFoot{}).waits(5.0);
    EXPECT_EQ(visitor.state.screen, Screen::kTrim);
    EXPECT_EQ(visitor.count<effect::BeginTrim>(), 1);
    EXPECT_FALSE(visitor.caused<effect::BeginDrawing>());
    EXPECT_EQ(spoken_key(visitor.state), "trim.title");
}

TEST(Trim, ReportsTheRemovedMassAndContinuesWithThatPot) {
    Visitor visitor;
    visitor.fires().does(event::ThickFoot{}).presses(Button::kSkip);
    visitor.does(event::Trimmed{38});
    EXPECT_EQ(visitor.state.trimming.taken_g, 38);
    EXPECT_TRUE(visitor.state.trimming.touched);
    visitor.presses(Button::kUndo);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::Undo{}}));
    visitor.does(event::Trimmed{20}).presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate);
    EXPECT_TRUE(std::holds_alternative<effect::EndTrim>(visitor.last.front())) << "before it is drawn on";
    EXPECT_TRUE(std::holds_alternative<effect::BeginDrawing>(visitor.last.back()));
}

TEST(Trim, MayBeLeft) {
    Visitor visitor;
    visitor.fires().does(event::ThickFoot{}).presses(Button::kSkip).presses(Button::kSkip);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate);
    EXPECT_EQ(visitor.count<effect::EndTrim>(), 1);
}

TEST(Trim, HasALoopOfThreeSizesAndTheWheelsSpeed) {
    Visitor visitor;
    visitor.fires().does(event::ThickFoot{}).presses(Button::kSkip);
    for (int i = 0; i < 5; ++i)
        visitor.presses(Button::kToolMore).presses(Button::kSpeedMore);
    EXPECT_EQ(visitor.state.trimming.loop, kMostTool);
    EXPECT_EQ(visitor.state.throwing.speed, kMostSpeed);
    for (int i = 0; i < 5; ++i)
        visitor.presses(Button::kToolLess).presses(Button::kSpeedLess);
    EXPECT_EQ(visitor.state.trimming.loop, 1);
    visitor.presses(Button::kHandLeft);
    EXPECT_TRUE(std::holds_alternative<effect::MoveHand>(visitor.last.front()));
}

TEST(Trim, IsNotOfferedToAFiredPot) {
    Visitor visitor;
    visitor.decorates().presses(Button::kDone).does(event::ThickFoot{}).presses(Button::kSkip);
    EXPECT_EQ(visitor.state.screen, Screen::kGlaze);
    visitor.presses(Button::kDecorateAgain);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate);
}

}  // namespace
}  // namespace onggi::visit
