// A jar of two bowls: the order of its steps, and their undo.
#include <gtest/gtest.h>

#include "game/visit/steps.h"
#include "tests/unit/visit/visitor.h"

namespace onggi::visit {
namespace {

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

TEST_F(Jar, IsIntroducedBeforeItBegins) {
    visitor.chooses_a_jar(kJar);
    EXPECT_EQ(visitor.state.screen, Screen::kJarStart);
    EXPECT_EQ(spoken_key(visitor.state), "moon.title");
    EXPECT_FALSE(visitor.caused<effect::FreshClay>());
    visitor.presses(Button::kBack);
    EXPECT_EQ(visitor.state.screen, Screen::kChoose);
    visitor.presses(Button::kTarget, kJar).presses(Button::kBegin);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(step_of(visitor), JarStep::kFirstBowl);
    EXPECT_EQ(visitor.state.throwing.target, kJar);
    EXPECT_EQ(spoken_key(visitor.state), "moon.s1");
    visitor = a_visitor();
    visitor.does(event::Input{}).presses(Button::kTarget, 1);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow) << "any other pot is thrown at once";
    EXPECT_EQ(step_of(visitor), JarStep::kNone);
}

TEST_F(Jar, GoesThroughItsFiveSteps) {
    visitor.chooses_a_jar(kJar).presses(Button::kBegin).ends_a_bowl();
    EXPECT_EQ(visitor.count<effect::SetAside>(), 1);
    EXPECT_EQ(step_of(visitor), JarStep::kFirstBowl) << "until it is safe";
    visitor.presses(Button::kDone);
    EXPECT_EQ(visitor.count<effect::SetAside>(), 1) << "once";
    visitor.does(event::SetAside{});
    EXPECT_EQ(step_of(visitor), JarStep::kAside);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::FreshClay{kJar}}));
    visitor.waits(5.5);
    EXPECT_EQ(step_of(visitor), JarStep::kAside);
    visitor.waits(1.0);
    EXPECT_EQ(step_of(visitor), JarStep::kSecondBowl);
    visitor.ends_a_bowl();
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::HoldTogether{}}));
    visitor.does(event::Rims{3});
    EXPECT_EQ(visitor.state.screen, Screen::kJoin);
    EXPECT_EQ(visitor.state.throwing.jar.rims_mm, 3);
    EXPECT_EQ(spoken_key(visitor.state), "moon.s4");
    visitor.presses(Button::kHandRight).presses(Button::kHandRight).presses(Button::kJoinBowls);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::JoinBowls{2}}));
    visitor.does(event::Joined{});
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(step_of(visitor), JarStep::kSeam);
    EXPECT_EQ(visitor.state.throwing.held, tool::Tool::kRib);
    EXPECT_EQ(spoken_key(visitor.state), "moon.s5");
    visitor.presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring);
    EXPECT_EQ(step_of(visitor), JarStep::kSeam) << "the fired pot is a jar of two bowls";
}

TEST_F(Jar, SetsNoClayAsideThatIsNoBowl) {
    visitor.chooses_a_jar(kJar).presses(Button::kBegin).presses(Button::kDone);
    EXPECT_FALSE(visitor.caused<effect::SetAside>());
    EXPECT_TRUE(visitor.state.throwing.jar.is_low);
    visitor.does(event::ClayTouched{.goes_on = true});
    EXPECT_EQ(spoken_key(visitor.state), "moon.low") << "under a touch that had begun before";
    visitor.does(event::ClayTouched{});
    EXPECT_FALSE(visitor.state.throwing.jar.is_low);
}

TEST_F(Jar, GoesOnWithTheSecondBowlWhereTheClayIsTouched) {
    visitor.chooses_a_jar(kJar).presses(Button::kBegin).ends_a_bowl().does(event::SetAside{});
    visitor.does(event::ClayTouched{});
    EXPECT_EQ(step_of(visitor), JarStep::kSecondBowl);
}

TEST_F(Jar, SaysWhereTheRimsAreTooFarApart) {
    visitor.chooses_a_jar(kJar).sets_a_bowl_aside().ends_a_bowl().does(event::RimsApart{});
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(spoken_key(visitor.state), "moon.more");
    visitor.does(event::ClayTouched{}).presses(Button::kDone).does(event::Rims{6});
    EXPECT_EQ(visitor.state.screen, Screen::kJoin);
}

TEST_F(Jar, MovesTheUpperBowlByEightMillimetresAtMost) {
    visitor.chooses_a_jar(kJar).holds_two_bowls();
    for (int i = 0; i < 20; ++i)
        visitor.presses(Button::kHandLeft);
    EXPECT_EQ(visitor.state.throwing.jar.shift_mm, -kMostShiftMm);
    visitor.presses(Button::kHandDown);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::JoinBowls{-kMostShiftMm}})) << "lowered";
}

TEST_F(Jar, IsTakenBackStepByStep) {
    visitor.chooses_a_jar(kJar).joins_two_bowls().presses(Button::kUndo);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::Undo{}}));
    EXPECT_EQ(step_of(visitor), JarStep::kSeam) << "a move of the rib, if there was one";
    visitor.does(event::UndoneAll{});
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::TakeBack{2}}));
    EXPECT_EQ(step_of(visitor), JarStep::kSecondBowl);
    EXPECT_EQ(visitor.state.throwing.held, tool::Tool::kHand);
    visitor.does(event::UndoneAll{});
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::TakeBack{1}}));
    EXPECT_EQ(step_of(visitor), JarStep::kFirstBowl);
    visitor.does(event::UndoneAll{});
    EXPECT_TRUE(visitor.last.empty());
    EXPECT_EQ(step_of(visitor), JarStep::kFirstBowl);
}

TEST_F(Jar, IsTakenBackFromTheJoinAndFromTheBowlThatWaits) {
    visitor.chooses_a_jar(kJar).holds_two_bowls().presses(Button::kUndo);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(step_of(visitor), JarStep::kSecondBowl);
    EXPECT_TRUE(visitor.last.empty()) << "it is still on the wheel";
    visitor = a_visitor();
    visitor.chooses_a_jar(kJar).presses(Button::kBegin).ends_a_bowl().does(event::SetAside{});
    visitor.presses(Button::kUndo);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::TakeBack{1}}));
    EXPECT_EQ(step_of(visitor), JarStep::kFirstBowl);
}

TEST_F(Jar, LosesOneBowlAtMostWhereClayGivesWay) {
    for (const bool joined : {false, true}) {
        visitor = a_visitor();
        visitor.chooses_a_jar(kJar);
        joined ? visitor.joins_two_bowls() : visitor.sets_a_bowl_aside();
        visitor.all.clear();
        visitor.does(event::Collapsed{}).presses(Button::kNewClay);
        EXPECT_EQ(step_of(visitor), JarStep::kSecondBowl);
        EXPECT_EQ(visitor.count<effect::FreshClay>(), 1);
        EXPECT_FALSE(visitor.caused<effect::ForgetPot>()) << "the first bowl still waits";
    }
}

TEST_F(Jar, StaysWhereItCannotBeHelped) {
    visitor.chooses_a_jar(kJar).holds_two_bowls().presses(Button::kJoinBowls).does(event::JarStays{});
    EXPECT_EQ(visitor.state.screen, Screen::kJoin);
    visitor.presses(Button::kJoinBowls);
    EXPECT_EQ(visitor.count<effect::JoinBowls>(), 2) << "it may be tried again";
}

TEST_F(Jar, WaitsForItsMakerForThreeMinutes) {
    visitor.chooses_a_jar(kJar).sets_a_bowl_aside().waits(170.0);
    EXPECT_EQ(visitor.state.panel, Panel::kNone);
    visitor.waits(11.0);
    EXPECT_EQ(visitor.state.panel, Panel::kIdle);
}

TEST_F(Jar, OfWhichOneBowlIsCutOffIsAPotLikeAnyOther) {
    visitor.chooses_a_jar(kJar).presses(Button::kBegin).does(event::Collapsed{}).presses(Button::kKeepSlump);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring);
    EXPECT_EQ(step_of(visitor), JarStep::kNone);
}

}  // namespace
}  // namespace onggi::visit
