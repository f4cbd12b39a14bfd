// A jar of two bowls: the order of its steps, and their undo.
#include <gtest/gtest.h>

#include "game/kiosk/spoken.h"
#include "tests/unit/kiosk/visitor.h"

namespace onggi::kiosk {
namespace {

using Kind = Event::Kind;
using Ask = Effect::Kind;

constexpr int kJar = 2;

Visitor a_visitor() {
    return Visitor(Rules{.jars = {kJar}});
}

JarStep step_of(const Visitor& visitor) {
    return visitor.state.throwing.jar.step;
}

struct Jar : testing::Test {
    Visitor visitor = a_visitor();
};

TEST_F(Jar, IsToldOfBeforeItIsBegun) {
    visitor.chooses_a_jar(kJar);
    EXPECT_EQ(visitor.state.screen, Screen::kJarStart);
    EXPECT_EQ(spoken_key(visitor.state), "moon.title");
    EXPECT_FALSE(visitor.caused(Ask::kFreshClay));
    visitor.presses(Button::kBack);
    EXPECT_EQ(visitor.state.screen, Screen::kChoose);
    visitor.presses(Button::kTarget, kJar).presses(Button::kBegin);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(step_of(visitor), JarStep::kFirstBowl);
    EXPECT_EQ(visitor.state.throwing.target, kJar);
    EXPECT_EQ(spoken_key(visitor.state), "moon.s1");
    visitor = a_visitor();
    visitor.does(Kind::kInput).presses(Button::kTarget, 1);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow) << "any other pot is thrown at once";
    EXPECT_EQ(step_of(visitor), JarStep::kNone);
}

TEST_F(Jar, GoesThroughItsFiveSteps) {
    visitor.chooses_a_jar(kJar).presses(Button::kBegin).ends_a_bowl();
    EXPECT_EQ(visitor.count(Ask::kSetAside), 1);
    EXPECT_EQ(step_of(visitor), JarStep::kFirstBowl) << "until it is safe";
    visitor.presses(Button::kDone);
    EXPECT_EQ(visitor.count(Ask::kSetAside), 1) << "once";
    visitor.does(Kind::kSetAside);
    EXPECT_EQ(step_of(visitor), JarStep::kAside);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{{Ask::kFreshClay, kJar}}));
    visitor.waits(5.5);
    EXPECT_EQ(step_of(visitor), JarStep::kAside);
    visitor.waits(1.0);
    EXPECT_EQ(step_of(visitor), JarStep::kSecondBowl);
    visitor.ends_a_bowl();
    EXPECT_EQ(visitor.last, (std::vector<Effect>{{Ask::kHoldTogether, 0}}));
    visitor.does(Kind::kRims, 3);
    EXPECT_EQ(visitor.state.screen, Screen::kJoin);
    EXPECT_EQ(visitor.state.throwing.jar.rims_mm, 3);
    EXPECT_EQ(spoken_key(visitor.state), "moon.s4");
    visitor.presses(Button::kHandRight).presses(Button::kHandRight).presses(Button::kJoinBowls);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{{Ask::kJoinBowls, 2}}));
    visitor.does(Kind::kJoined);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(step_of(visitor), JarStep::kSeam);
    EXPECT_EQ(visitor.state.throwing.held, Held::kRib);
    EXPECT_EQ(spoken_key(visitor.state), "moon.s5");
    visitor.presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring);
    EXPECT_EQ(step_of(visitor), JarStep::kSeam) << "the fired pot is a jar of two bowls";
}

TEST_F(Jar, SetsNoClayAsideThatIsNoBowl) {
    visitor.chooses_a_jar(kJar).presses(Button::kBegin).presses(Button::kDone);
    EXPECT_FALSE(visitor.caused(Ask::kSetAside));
    EXPECT_TRUE(visitor.state.throwing.jar.is_low);
    visitor.does(Kind::kClayTouched, 1);
    EXPECT_EQ(spoken_key(visitor.state), "moon.low") << "under a touch that had begun before";
    visitor.does(Kind::kClayTouched);
    EXPECT_FALSE(visitor.state.throwing.jar.is_low);
}

TEST_F(Jar, GoesOnWithTheSecondBowlWhereTheClayIsTouched) {
    visitor.chooses_a_jar(kJar).presses(Button::kBegin).ends_a_bowl().does(Kind::kSetAside);
    visitor.does(Kind::kClayTouched);
    EXPECT_EQ(step_of(visitor), JarStep::kSecondBowl);
}

TEST_F(Jar, SaysWhereTheRimsAreTooFarApart) {
    visitor.chooses_a_jar(kJar).sets_a_bowl_aside().ends_a_bowl().does(Kind::kRimsApart);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(spoken_key(visitor.state), "moon.more");
    visitor.does(Kind::kClayTouched).presses(Button::kDone).does(Kind::kRims, 6);
    EXPECT_EQ(visitor.state.screen, Screen::kJoin);
}

TEST_F(Jar, MovesTheUpperBowlByEightMillimetresAtMost) {
    visitor.chooses_a_jar(kJar).holds_two_bowls();
    for (int i = 0; i < 20; ++i)
        visitor.presses(Button::kHandLeft);
    EXPECT_EQ(visitor.state.throwing.jar.shift_mm, -kMostShiftMm);
    visitor.presses(Button::kHandDown);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{{Ask::kJoinBowls, -kMostShiftMm}})) << "lowered";
}

TEST_F(Jar, IsTakenBackStepByStep) {
    visitor.chooses_a_jar(kJar).joins_two_bowls().presses(Button::kUndo);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{{Ask::kUndo, 0}}));
    EXPECT_EQ(step_of(visitor), JarStep::kSeam) << "a move of the rib, if there was one";
    visitor.does(Kind::kUndoneAll);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{{Ask::kTakeBack, 2}}));
    EXPECT_EQ(step_of(visitor), JarStep::kSecondBowl);
    EXPECT_EQ(visitor.state.throwing.held, Held::kHand);
    visitor.does(Kind::kUndoneAll);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{{Ask::kTakeBack, 1}}));
    EXPECT_EQ(step_of(visitor), JarStep::kFirstBowl);
    visitor.does(Kind::kUndoneAll);
    EXPECT_TRUE(visitor.last.empty());
    EXPECT_EQ(step_of(visitor), JarStep::kFirstBowl);
}

TEST_F(Jar, IsTakenBackFromTheJoinAndFromTheBowlThatWaits) {
    visitor.chooses_a_jar(kJar).holds_two_bowls().presses(Button::kUndo);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(step_of(visitor), JarStep::kSecondBowl);
    EXPECT_TRUE(visitor.last.empty()) << "it is still on the wheel";
    visitor = a_visitor();
    visitor.chooses_a_jar(kJar).presses(Button::kBegin).ends_a_bowl().does(Kind::kSetAside);
    visitor.presses(Button::kUndo);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{{Ask::kTakeBack, 1}}));
    EXPECT_EQ(step_of(visitor), JarStep::kFirstBowl);
}

TEST_F(Jar, LosesOneBowlAtMostWhereClayGivesWay) {
    for (const bool joined : {false, true}) {
        visitor = a_visitor();
        visitor.chooses_a_jar(kJar);
        joined ? visitor.joins_two_bowls() : visitor.sets_a_bowl_aside();
        visitor.all.clear();
        visitor.does(Kind::kCollapsed).presses(Button::kNewClay);
        EXPECT_EQ(step_of(visitor), JarStep::kSecondBowl);
        EXPECT_EQ(visitor.count(Ask::kFreshClay), 1);
        EXPECT_FALSE(visitor.caused(Ask::kForgetPot)) << "the first bowl still waits";
    }
}

TEST_F(Jar, StaysWhereItCannotBeHelped) {
    visitor.chooses_a_jar(kJar).holds_two_bowls().presses(Button::kJoinBowls).does(Kind::kJarStays);
    EXPECT_EQ(visitor.state.screen, Screen::kJoin);
    visitor.presses(Button::kJoinBowls);
    EXPECT_EQ(visitor.count(Ask::kJoinBowls), 2) << "it may be tried again";
}

TEST_F(Jar, WaitsForItsMakerForThreeMinutes) {
    visitor.chooses_a_jar(kJar).sets_a_bowl_aside().waits(170.0);
    EXPECT_EQ(visitor.state.panel, Panel::kNone);
    visitor.waits(11.0);
    EXPECT_EQ(visitor.state.panel, Panel::kIdle);
}

TEST_F(Jar, OfWhichOneBowlIsCutOffIsAPotLikeAnyOther) {
    visitor.chooses_a_jar(kJar).presses(Button::kBegin).does(Kind::kCollapsed).presses(Button::kKeepSlump);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring);
    EXPECT_EQ(step_of(visitor), JarStep::kNone);
}

}  // namespace
}  // namespace onggi::kiosk
