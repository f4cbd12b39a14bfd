// Turning the foot: when it is offered, and how it ends.
#include <gtest/gtest.h>

#include "game/kiosk/spoken.h"
#include "tests/unit/kiosk/visitor.h"

namespace onggi::kiosk {
namespace {

using Kind = Event::Kind;
using Ask = Effect::Kind;

TEST(Trim, IsOfferedWhereThereIsClayToSpare) {
    Visitor visitor;
    visitor.fires().waits(5.0);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate) << "a thin foot is left alone";
    visitor = Visitor();
    visitor.fires().does(Kind::kThickFoot).waits(5.0);
    EXPECT_EQ(visitor.state.screen, Screen::kTrim);
    EXPECT_EQ(visitor.count(Ask::kBeginTrim), 1);
    EXPECT_FALSE(visitor.caused(Ask::kBeginDrawing));
    EXPECT_EQ(spoken_key(visitor.state), "trim.title");
}

TEST(Trim, TellsWhatWasTakenAndGoesOnWithThat) {
    Visitor visitor;
    visitor.fires().does(Kind::kThickFoot).presses(Button::kSkip);
    visitor.does(Kind::kTrimmed, 38);
    EXPECT_EQ(visitor.state.trimming.taken_g, 38);
    EXPECT_TRUE(visitor.state.trimming.touched);
    visitor.presses(Button::kUndo);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{{Ask::kUndo, 0}}));
    visitor.does(Kind::kTrimmed, 20).presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate);
    EXPECT_EQ(visitor.last.front().kind, Ask::kEndTrim) << "before it is drawn on";
    EXPECT_EQ(visitor.last.back().kind, Ask::kBeginDrawing);
}

TEST(Trim, MayBeLeft) {
    Visitor visitor;
    visitor.fires().does(Kind::kThickFoot).presses(Button::kSkip).presses(Button::kSkip);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate);
    EXPECT_EQ(visitor.count(Ask::kEndTrim), 1);
}

TEST(Trim, HasALoopOfThreeSizesAndTheWheelsSpeed) {
    Visitor visitor;
    visitor.fires().does(Kind::kThickFoot).presses(Button::kSkip);
    for (int i = 0; i < 5; ++i)
        visitor.presses(Button::kToolMore).presses(Button::kSpeedMore);
    EXPECT_EQ(visitor.state.trimming.loop, kMostTool);
    EXPECT_EQ(visitor.state.throwing.speed, kMostSpeed);
    for (int i = 0; i < 5; ++i)
        visitor.presses(Button::kToolLess).presses(Button::kSpeedLess);
    EXPECT_EQ(visitor.state.trimming.loop, 1);
    visitor.presses(Button::kHandLeft);
    EXPECT_EQ(visitor.last.front().kind, Ask::kMoveHand);
}

TEST(Trim, IsNotOfferedToAFiredPot) {
    Visitor visitor;
    visitor.decorates().presses(Button::kDone).does(Kind::kThickFoot).presses(Button::kSkip);
    EXPECT_EQ(visitor.state.screen, Screen::kGlaze);
    visitor.presses(Button::kDecorateAgain);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate);
}

}  // namespace
}  // namespace onggi::kiosk
