// The flow of a visit, from the visitor's view.
#include <gtest/gtest.h>

#include "game/visit/steps.h"
#include "game/visit/throw/throw.h"
#include "tests/unit/visit/visitor.h"

namespace onggi::visit {
namespace {

struct Kiosk : testing::Test {
    Visitor visitor;
};

TEST_F(Kiosk, AttractsForEverWithoutAVisitor) {
    visitor.waits(3600.0);
    EXPECT_EQ(visitor.state.screen, Screen::kAttract);
    EXPECT_TRUE(visitor.all.empty());
}

TEST_F(Kiosk, TakesAVisitorFromAttractToAKeptPot) {
    visitor.does(event::Input{});
    EXPECT_EQ(visitor.state.screen, Screen::kChoose);
    EXPECT_EQ(visitor.count<effect::VisitBegan>(), 1);
    visitor.presses(Button::kTarget, 2);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(visitor.state.throwing.target, 2);
    EXPECT_TRUE(visitor.caused<effect::FreshClay>());
    visitor.does(event::ClayTouched{}).waits(5.0).presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring);
    EXPECT_TRUE(visitor.caused<effect::CutOff>());
    visitor.waits(1.3);
    EXPECT_EQ(visitor.state.firing, FiringStage::kDry);
    visitor.waits(1.5);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate);
    EXPECT_TRUE(visitor.caused<effect::BeginDrawing>());
    visitor.waits(20.0);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate) << "no hurry";
    visitor.presses(Button::kDone);
    EXPECT_EQ(visitor.state.firing, FiringStage::kFire);
    EXPECT_TRUE(visitor.caused<effect::EndDrawing>());
    visitor.waits(2.5);
    EXPECT_EQ(visitor.state.screen, Screen::kGlaze);
    visitor.presses(Button::kGlaze, 4).presses(Button::kTakeGlaze);
    EXPECT_EQ(visitor.state.screen, Screen::kYourPot);
    EXPECT_EQ(visitor.state.glaze, 4);
    visitor.presses(Button::kKeep);
    EXPECT_EQ(visitor.count<effect::Save>(), 1);
    visitor.does(event::Saved{14});
    EXPECT_EQ(visitor.state.keeping.outcome, Keeping::Outcome::kKept);
    EXPECT_EQ(visitor.state.keeping.number, 14);
    visitor.presses(Button::kFinish);
    EXPECT_EQ(visitor.state.screen, Screen::kAttract);
    EXPECT_EQ(visitor.count<effect::VisitEnded>(), 1);
    EXPECT_EQ(visitor.count<effect::ForgetPot>(), 2);  // before the clay, and after the visitor
}

TEST_F(Kiosk, DecoratesWithTheToolsOfTheLedge) {
    visitor.decorates();
    const Decorating& decorating = visitor.state.decorating;
    EXPECT_TRUE(decorating.turns);
    visitor.presses(Button::kDrawingTool, 3).presses(Button::kSlip, 1).presses(Button::kToolMore);
    EXPECT_EQ(decorating.tool, kInlayTool);
    EXPECT_TRUE(decorating.black);
    EXPECT_EQ(decorating.brush, 3);
    visitor.presses(Button::kToolMore).presses(Button::kTurning);
    EXPECT_EQ(decorating.brush, kMostBrush);
    EXPECT_FALSE(decorating.turns);
    visitor.presses(Button::kDrawingTool, kDrawingTools).presses(Button::kMotif, -1);
    EXPECT_EQ(decorating.tool, kInlayTool) << "there is no such tool";
    visitor.presses(Button::kDrawingTool, kMotifTool).presses(Button::kMotif, 4).presses(Button::kAllRound);
    EXPECT_EQ(decorating.motif, 4);
    EXPECT_TRUE(decorating.all_round);
    visitor.presses(Button::kBack);
    EXPECT_EQ(decorating.tool, 0);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate);
}

TEST_F(Kiosk, ClearsOnlyAnExistingDrawing) {
    visitor.decorates().presses(Button::kClear);
    EXPECT_FALSE(visitor.caused<effect::ClearDrawing>());
    visitor.does(event::Drawn{1}).presses(Button::kClear);
    EXPECT_TRUE(visitor.caused<effect::ClearDrawing>());
    EXPECT_TRUE(visitor.state.decorating.touched);
}

TEST_F(Kiosk, AKeysBrushStaysDownUntilItIsLiftedOrSomethingElseIsDone) {
    visitor.decorates().presses(Button::kPutBrush);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::PutBrush{true}}));
    visitor.presses(Button::kHandLeft);
    EXPECT_TRUE(visitor.state.decorating.brush_down);
    visitor.presses(Button::kPutBrush);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::PutBrush{false}}));
    visitor.presses(Button::kPutBrush).presses(Button::kDrawingTool, kMotifTool);
    EXPECT_FALSE(visitor.state.decorating.brush_down);
    visitor.presses(Button::kPutBrush);
    EXPECT_FALSE(visitor.state.decorating.brush_down) << "a motif is there at once";
}

TEST_F(Kiosk, APotRestsWhileItIsDecoratedWithReducedMotion) {
    visitor.starts_to_throw()
        .presses(Button::kLanguages)
        .presses(Button::kStill)
        .presses(Button::kComfortDone);
    visitor.presses(Button::kDone).presses(Button::kSkip);
    EXPECT_EQ(visitor.state.screen, Screen::kDecorate);
    EXPECT_FALSE(visitor.state.decorating.turns);
}

TEST_F(Kiosk, StartsFreeThrowingOnATouchOfTheClay) {
    visitor.does(event::ClayTouched{});
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_FALSE(visitor.state.throwing.target.has_value());
}

TEST_F(Kiosk, AsksBeforeItStartsAfresh) {
    visitor.starts_to_throw().waits(44.0);
    EXPECT_EQ(visitor.state.panel, Panel::kNone);
    visitor.waits(1.2);
    EXPECT_EQ(visitor.state.panel, Panel::kIdle);
    EXPECT_EQ(seconds_left(visitor.state, visitor.rules.countdown_s, visitor.now_s), 20);
    visitor.waits(19.0);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    visitor.waits(1.2);
    EXPECT_EQ(visitor.state.screen, Screen::kAttract);
    EXPECT_EQ(visitor.state.panel, Panel::kNone);
}

TEST_F(Kiosk, GoesOnForAnySignOfLifeDuringTheCountdown) {
    for (const Event& sign : {Event(event::Input{}), Event(event::ClayTouched{})}) {
        visitor = Visitor();
        visitor.starts_to_throw().waits(60.0);
        ASSERT_EQ(visitor.state.panel, Panel::kIdle);
        visitor.does(sign).waits(40.0);
        EXPECT_EQ(visitor.state.screen, Screen::kThrow);
        EXPECT_EQ(visitor.state.panel, Panel::kNone);
    }
}

TEST_F(Kiosk, TakesNewClayFromTheCountdownWhenAsked) {
    visitor.keeps().does(event::Saved{1}).waits(50.0).presses(Button::kFresh);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_TRUE(std::holds_alternative<effect::FreshClay>(visitor.last.back()));
}

TEST_F(Kiosk, ForgetsEveryRequestOfTheVisitorBefore) {
    visitor.starts_to_throw().presses(Button::kLanguages);
    visitor.presses(Button::kLanguage, 2).presses(Button::kTextMore).presses(Button::kSoundMore);
    visitor.presses(Button::kReach).presses(Button::kLeftHand).presses(Button::kStill);
    visitor.presses(Button::kComfortDone);
    const Comfort requests{
        .language = 2, .text_size = 2, .volume = 4, .reach = true, .left_hand = true, .still = true};
    EXPECT_EQ(visitor.state.comfort, requests);
    visitor.does(
        event::Progress{kTeachingSteps});  // after all steps are learnt there are no more demonstrations
    visitor.all.clear();
    visitor.waits(70.0);
    EXPECT_EQ(visitor.state.screen, Screen::kAttract);
    EXPECT_EQ(visitor.state.comfort, Comfort{});
    EXPECT_EQ(visitor.state.throwing.water, Throwing{}.water);
    const std::vector<Effect> expected{effect::VisitEnded{65, Screen::kThrow}, effect::ForgetPot{},
                                       effect::SetVolume{3}, effect::StartDemo{}};
    EXPECT_EQ(visitor.all, expected);
}

TEST_F(Kiosk, ShowsTheSameScreenWhileTimePassesAndHandsOnlyWork) {
    visitor = Visitor(Rules{.shows_by_itself = false});
    visitor.starts_to_throw();
    const ScreenState seen = visitor.state;
    visitor.does(event::ClayTouched{})
        .does(event::Held{.holds = true})
        .waits(3.0)
        .does(event::Held{.holds = false});
    visitor.does(event::Input{}).waits(3.0);
    EXPECT_TRUE(seen == visitor.state);
    visitor.does(event::Progress{1});
    EXPECT_FALSE(seen == visitor.state);
}

TEST_F(Kiosk, AsksOnceBeforeItFiresASolidLump) {
    visitor.starts_to_throw().does(event::Progress{.steps_done = 1, .is_solid = true});
    visitor.presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(spoken_key(visitor.state), "solid.ask");
    visitor.does(event::ClayTouched{}).presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow) << "asked again after another touch";
    visitor.presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring) << "which the visitor wants";
}

TEST_F(Kiosk, AdvisesAnotherPullOfAThickWallBeforeThePotIsCutOff) {
    visitor.starts_to_throw().does(event::Progress{.steps_done = 3, .thick_mm = 22}).presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(spoken_key(visitor.state), "thick.ask");
    EXPECT_EQ(visitor.state.throwing.asked_mm, 22);
    EXPECT_FALSE(visitor.caused<effect::CutOff>());
    visitor.presses(Button::kToWheel);
    EXPECT_EQ(spoken_key(visitor.state), "step.own") << "one tap, and the visitor is back at the wheel";
    visitor.does(event::ClayTouched{}).does(event::Progress{.steps_done = 3, .thick_mm = 19});
    visitor.presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow) << "who took the advice gets the next one";
    EXPECT_EQ(visitor.state.throwing.asked_mm, 19);
    visitor.does(event::ClayTouched{}).does(event::Progress{.steps_done = 3}).presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring) << "now it is thin enough";
}

TEST_F(Kiosk, AdvisesOnceWhereTheWallStaysAsThick) {
    visitor.starts_to_throw().does(event::Progress{.steps_done = 3, .thick_mm = 22}).presses(Button::kDone);
    visitor.does(event::ClayTouched{}).does(event::Progress{.steps_done = 3, .thick_mm = 21});
    visitor.presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring);
}

TEST_F(Kiosk, KeepsAThickWallThatTheVisitorWants) {
    visitor.starts_to_throw().does(event::Progress{.steps_done = 3, .thick_mm = 22});
    visitor.presses(Button::kDone).presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring);
    Visitor other;
    other.starts_to_throw().does(event::Progress{.steps_done = 3, .thick_mm = 22});
    other.presses(Button::kNewClay).does(event::Progress{.steps_done = 3}).presses(Button::kDone);
    EXPECT_EQ(other.state.screen, Screen::kFiring) << "of the clay on the wheel";
}

// Where the wall is about to sink, nobody is told to draw it higher.
TEST_F(Kiosk, AdvisesNoPullOfAWallThatIsAboutToSink) {
    visitor.starts_to_throw().does(event::Progress{.steps_done = 3, .thick_mm = 22});
    visitor.does(event::Warned{Warning::kThin}).presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring);
}

TEST_F(Kiosk, CountsNoIdleTimeWhileItKeepsAndPacksThePot) {
    visitor.rules.shares = true;
    visitor.keeps().waits(80.0);
    EXPECT_EQ(visitor.state.panel, Panel::kNone) << "the disk is slow";
    visitor.does(event::Saved{3}).waits(80.0);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kPacking);
    EXPECT_EQ(visitor.state.panel, Panel::kNone) << "the visitor waits for the code";
    visitor.does(event::Shared{3, ShareOutcome::kReady}).waits(visitor.rules.idle_s - 0.2);
    EXPECT_EQ(visitor.state.panel, Panel::kNone) << "the full time to see it";
    visitor.waits(0.3);
    EXPECT_EQ(visitor.state.panel, Panel::kIdle);
}

TEST_F(Kiosk, IsFreedFromAWorkThatNeverEnds) {
    visitor.keeps().waits(visitor.rules.works_most_s + visitor.rules.idle_s + 0.2);
    EXPECT_EQ(visitor.state.panel, Panel::kIdle);
    visitor.waits(visitor.rules.countdown_s + 0.1);
    EXPECT_EQ(visitor.state.screen, Screen::kAttract);
}

TEST_F(Kiosk, ResumesTheChosenPotAndAPotThatWasCutOffWithItsGlaze) {
    visitor.does(event::InterruptedSession{.pot = {.target = 2, .glaze = 4}}).does(event::Input{});
    visitor.presses(Button::kResumeGo);
    EXPECT_EQ(visitor.state.throwing.target, 2) << "whose outline is shown";
    visitor.does(event::Progress{.steps_done = 2});
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    Visitor other;
    other.does(event::InterruptedSession{.pot = {.target = 2, .glaze = 4, .is_cut_off = true}});
    other.does(event::Input{}).presses(Button::kResumeGo);
    EXPECT_EQ(other.state.screen, Screen::kThrow) << "until the clay is on the wheel";
    other.does(event::Progress{.steps_done = 3, .thick_mm = 22});
    EXPECT_EQ(other.state.screen, Screen::kFiring);
    EXPECT_TRUE(other.caused<effect::CutOff>());
    other.presses(Button::kSkip).presses(Button::kDone).presses(Button::kSkip);
    EXPECT_EQ(other.state.screen, Screen::kGlaze);
    EXPECT_EQ(other.state.glaze, 4);
    Visitor fresh;
    fresh.does(event::InterruptedSession{.pot = {.target = 2, .is_cut_off = true}}).does(event::Input{});
    fresh.presses(Button::kResumeFresh).does(event::Progress{.steps_done = 1});
    EXPECT_EQ(fresh.state.screen, Screen::kThrow) << "another lump";
    EXPECT_FALSE(fresh.state.throwing.target);
}

TEST_F(Kiosk, FiresAHollowPotWithoutAQuestion) {
    visitor.starts_to_throw().does(event::Progress{.steps_done = 1, .is_solid = true});
    visitor.does(event::Progress{.steps_done = 2}).presses(Button::kDone);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring);
}

TEST_F(Kiosk, ShowsTheCueUntilTheVisitorActsAndAgainWithoutProgress) {
    visitor.starts_to_throw();
    EXPECT_TRUE(shows_hint(visitor.state, visitor.now_s, visitor.rules));
    visitor.waits(1.0).does(event::ClayTouched{});
    EXPECT_FALSE(shows_hint(visitor.state, visitor.now_s, visitor.rules));
    visitor.waits(6.1);
    EXPECT_TRUE(shows_hint(visitor.state, visitor.now_s, visitor.rules));
    visitor.does(event::ClayTouched{}).does(event::Progress{1});
    EXPECT_EQ(visitor.state.throwing.steps_done, 1);
    EXPECT_FALSE(shows_hint(visitor.state, visitor.now_s, visitor.rules));
    visitor.does(event::Progress{3}).waits(20.0);
    EXPECT_FALSE(shows_hint(visitor.state, visitor.now_s, visitor.rules)) << "there is nothing left to teach";
}

TEST_F(Kiosk, LooksIntoThePotAndOutAgain) {
    visitor.starts_to_throw().presses(Button::kLookIn);
    EXPECT_TRUE(visitor.state.throwing.looks_in);
    visitor.presses(Button::kLookIn);
    EXPECT_FALSE(visitor.state.throwing.looks_in);
    visitor.presses(Button::kLookIn).presses(Button::kNewClay);
    EXPECT_FALSE(visitor.state.throwing.looks_in) << "new clay has nothing to look into";
}

TEST_F(Kiosk, PagesThroughTheWholeShelf) {
    visitor.does(event::Input{}).presses(Button::kShelfBefore, -4);
    EXPECT_EQ(visitor.state.shelf_first, 0);
    visitor.presses(Button::kShelfNext, 2);
    EXPECT_EQ(visitor.state.shelf_first, 2);
    visitor.presses(Button::kShelfNext, 400);
    EXPECT_EQ(visitor.state.shelf_first, visitor.rules.target_count);
    visitor.presses(Button::kTarget, 3).presses(Button::kBack);
    EXPECT_EQ(visitor.state.shelf_first, 0);
}

TEST_F(Kiosk, TellsOfAPotAndThrowsItOrGoesBack) {
    visitor.does(event::Input{}).presses(Button::kCard, 2);
    EXPECT_EQ(visitor.state.panel, Panel::kCard);
    EXPECT_EQ(visitor.state.card, 2);
    visitor.presses(Button::kCardClose);
    EXPECT_EQ(visitor.state.panel, Panel::kNone);
    EXPECT_EQ(visitor.state.screen, Screen::kChoose);
    visitor.presses(Button::kCard, 99).presses(Button::kCard, -1);
    EXPECT_EQ(visitor.state.panel, Panel::kNone) << "there is no such pot";
    visitor.presses(Button::kCard, 2).presses(Button::kCardThrow);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(visitor.state.throwing.target, 2);
    Visitor reader;
    reader.does(event::Input{}).presses(Button::kCard, 2).waits(300.0);
    EXPECT_EQ(reader.state.screen, Screen::kAttract) << "no longer read";
}

TEST_F(Kiosk, NeverTeachesBackwards) {
    visitor.starts_to_throw().does(event::Progress{2}).does(event::Progress{1});
    EXPECT_EQ(visitor.state.throwing.steps_done, 2);
}

TEST_F(Kiosk, KeepsTheSettingsWithinTheirSteps) {
    visitor.starts_to_throw();
    for (int i = 0; i < 9; ++i)
        visitor.presses(Button::kToolMore).presses(Button::kWaterLess).presses(Button::kSpeedMore);
    EXPECT_EQ(visitor.state.throwing.tool, kMostTool);
    EXPECT_EQ(visitor.state.throwing.water, 1);
    EXPECT_EQ(visitor.state.throwing.speed, kMostSpeed);
}

TEST_F(Kiosk, ForgivesACollapse) {
    visitor.starts_to_throw().does(event::Warned{Warning::kThin});
    EXPECT_EQ(visitor.state.throwing.warning, Warning::kThin);
    visitor.does(event::Collapsed{});
    EXPECT_EQ(visitor.state.screen, Screen::kFailure);
    visitor.presses(Button::kBeforeCollapse);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_EQ(visitor.state.throwing.warning, Warning::kNone);
    EXPECT_TRUE(visitor.caused<effect::BeforeCollapse>());
    visitor.does(event::Collapsed{}).presses(Button::kKeepSlump);
    EXPECT_EQ(visitor.state.screen, Screen::kFiring);
}

TEST_F(Kiosk, SlowsTheWheelThatSpunThePotApart) {
    visitor.starts_to_throw().presses(Button::kSpeedMore).presses(Button::kSpeedMore);
    visitor.does(event::Collapsed{Warning::kFast}).presses(Button::kBeforeCollapse);
    EXPECT_EQ(visitor.state.throwing.speed, Throwing().speed);
    visitor.does(event::Collapsed{Warning::kFast}).presses(Button::kBeforeCollapse);
    EXPECT_EQ(visitor.state.throwing.speed, Throwing().speed - 1);
    visitor.does(event::Collapsed{Warning::kThin}).presses(Button::kBeforeCollapse);
    EXPECT_EQ(visitor.state.throwing.speed, Throwing().speed - 1) << "by no fault of the wheel's";
}

TEST_F(Kiosk, NamesTheCauseOfACollapse) {
    for (const Warning cause : {Warning::kThin, Warning::kWet, Warning::kFast}) {
        visitor = Visitor();
        visitor.starts_to_throw().does(event::Collapsed{cause});
        EXPECT_EQ(visitor.state.throwing.collapse, cause);
        visitor.presses(Button::kNewClay);
        EXPECT_EQ(visitor.state.throwing.collapse, Warning::kNone) << "new clay has not given way";
    }
}

TEST_F(Kiosk, SaysThatTheShelfIsFullAndStaysUsable) {
    visitor.keeps();
    visitor.presses(Button::kFinish);
    EXPECT_EQ(visitor.state.screen, Screen::kKeep) << "not before the pot is known to be safe";
    visitor.does(event::SaveFailed{});
    EXPECT_EQ(visitor.state.keeping.outcome, Keeping::Outcome::kFull);
    visitor.presses(Button::kAnother);
    EXPECT_EQ(visitor.state.screen, Screen::kChoose);
}

TEST_F(Kiosk, GoesOnWhenAHandControlIsUnplugged) {
    visitor.starts_to_throw().does(event::Device{.is_there = false});
    EXPECT_TRUE(visitor.state.device_lost);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    visitor.waits(70.0);
    EXPECT_TRUE(visitor.state.device_lost) << "the next visitor has none either";
    visitor.does(event::Device{.is_there = true});
    EXPECT_FALSE(visitor.state.device_lost);
}

TEST_F(Kiosk, GoesOnThrowingWhileTheForceRests) {
    visitor.starts_to_throw().does(event::ClayTouched{}).does(event::Force{.rests = true});
    EXPECT_TRUE(visitor.state.force_rests);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    visitor.presses(Button::kDone).presses(Button::kSkip).presses(Button::kDone).presses(Button::kSkip);
    EXPECT_EQ(visitor.state.screen, Screen::kGlaze);
    visitor.waits(70.0);
    EXPECT_EQ(visitor.state.screen, Screen::kAttract);
    EXPECT_TRUE(visitor.state.force_rests) << "it rests for the next visitor too";
    visitor.does(event::Force{.rests = false});
    EXPECT_FALSE(visitor.state.force_rests);
}

TEST_F(Kiosk, ShowsTheForcesOnRequestUntilTheVisitEnds) {
    visitor.starts_to_throw().presses(Button::kForces);
    EXPECT_TRUE(visitor.state.comfort.forces);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    visitor.presses(Button::kForces);
    EXPECT_FALSE(visitor.state.comfort.forces);
    visitor.presses(Button::kForces).presses(Button::kLanguages).presses(Button::kForces);
    EXPECT_TRUE(visitor.state.comfort.forces) << "not through a panel";
    visitor.presses(Button::kComfortDone).waits(70.0);
    EXPECT_EQ(visitor.state.screen, Screen::kAttract);
    EXPECT_FALSE(visitor.state.comfort.forces);
}

TEST_F(Kiosk, RestsWhileTheWheelCannotWork) {
    visitor.starts_to_throw().does(event::Fault{});
    EXPECT_EQ(visitor.state.screen, Screen::kFault);
    visitor.does(event::Input{}).presses(Button::kFree).presses(Button::kLanguages).waits(200.0);
    EXPECT_EQ(visitor.state.screen, Screen::kFault);
    EXPECT_EQ(visitor.state.panel, Panel::kNone);
    visitor.does(event::FaultOver{});
    EXPECT_EQ(visitor.state.screen, Screen::kAttract);
}

TEST_F(Kiosk, OffersAPotThatWasLeftWhenThePowerWent) {
    visitor.does(event::InterruptedSession{}).does(event::Input{});
    EXPECT_EQ(visitor.state.screen, Screen::kResume);
    visitor.presses(Button::kResumeGo);
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_TRUE(visitor.caused<effect::Resume>());
    EXPECT_FALSE(visitor.caused<effect::FreshClay>());

    Visitor other;
    other.does(event::InterruptedSession{}).does(event::Input{}).presses(Button::kResumeFresh);
    EXPECT_TRUE(other.caused<effect::DropInterrupted>());
    EXPECT_FALSE(other.state.interrupted_session);
}

TEST_F(Kiosk, OffersALeftPotUntilSomebodyHasDecided) {
    visitor.does(event::InterruptedSession{}).does(event::Input{}).waits(70.0);
    EXPECT_EQ(visitor.state.screen, Screen::kAttract) << "who was asked went away";
    EXPECT_FALSE(visitor.caused<effect::DropInterrupted>());
    visitor.does(event::Input{});
    EXPECT_EQ(visitor.state.screen, Screen::kResume);
    visitor.waits(46.0);
    EXPECT_EQ(visitor.state.panel, Panel::kIdle);
    visitor.presses(Button::kFresh);
    EXPECT_TRUE(visitor.caused<effect::DropInterrupted>()) << "new clay is an answer";
    EXPECT_EQ(visitor.state.screen, Screen::kThrow);
    EXPECT_FALSE(visitor.state.interrupted_session);
}

TEST_F(Kiosk, ClosesAsAnyWindowUnlessItIsLocked) {
    visitor.does(event::CloseAsked{});
    EXPECT_TRUE(visitor.caused<effect::Quit>());
    Visitor locked(Rules{.locked = true});
    locked.does(event::CloseAsked{});
    EXPECT_FALSE(locked.caused<effect::Quit>());
}

TEST_F(Kiosk, OpensTheStaffPanelForTheRightPinOnly) {
    visitor = Visitor(Rules{.locked = true, .pin = 472, .pin_digits = 4});  // 0472
    visitor.presses(Button::kDigit, 1);
    EXPECT_EQ(visitor.state.panel, Panel::kNone) << "there is no keypad before the corner was held";
    visitor.does(event::CornerHeld{});
    EXPECT_EQ(visitor.state.panel, Panel::kPin);
    for (const int digit : {0, 4, 7, 1})
        visitor.presses(Button::kDigit, digit);
    EXPECT_EQ(visitor.state.panel, Panel::kPin);
    EXPECT_TRUE(visitor.state.staff.was_wrong);
    for (const int digit : {0, 4, 7, 2})
        visitor.presses(Button::kDigit, digit);
    EXPECT_EQ(visitor.state.panel, Panel::kStaff);
}

TEST_F(Kiosk, HasNoStaffPanelWithoutAPin) {
    visitor.does(event::CornerHeld{});
    EXPECT_EQ(visitor.state.panel, Panel::kNone);
}

TEST_F(Kiosk, LocksTheStaffPanelWhenItIsLeftAlone) {
    visitor = Visitor(Rules{.pin = 1234, .pin_digits = 4});
    visitor.does(event::CornerHeld{});
    for (const int digit : {1, 2, 3, 4})
        visitor.presses(Button::kDigit, digit);
    visitor.waits(100.0).presses(Button::kStaffPage, 2).waits(100.0);
    EXPECT_EQ(visitor.state.panel, Panel::kStaff);
    visitor.waits(25.0);
    EXPECT_EQ(visitor.state.panel, Panel::kNone);
}

}  // namespace
}  // namespace onggi::visit
