// Fingers, keys and a single switch on a screen of three targets.
#include "game/app/kiosk/finger/kiosk_pointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "game/app/kiosk/visit/bench_tools.h"

namespace onggi::app {
namespace {

using Kind = PointerNews::Kind;
using kiosk::Button;

screens::Composition screen() {
    screens::Composition composition;
    composition.bounds = {0.0F, 0.0F, 1280.0F, 720.0F};
    composition.px_per_u = 1.0F;
    composition.targets = {
        {.button = Button::kDone, .rect = {100.0F, 600.0F, 100.0F, 66.0F}, .name = "Done"},
        {.button = Button::kToolMore,
         .rect = {300.0F, 600.0F, 50.0F, 66.0F},
         .name = "Tool +",
         .repeats = true},
        {.button = Button::kGlaze, .value = 4, .rect = {500.0F, 600.0F, 100.0F, 66.0F}, .name = "Ash"}};
    return composition;
}

// The same screen without that button, composed again.
screens::Composition screen_without_done() {
    screens::Composition composition = screen();
    composition.targets.erase(composition.targets.begin());
    return composition;
}

class Finger {
  public:
    Finger() { pointer.look_at(&composition, 1, false); }

    Finger& moves(double x, double y) { return does(window::PointerEvent{x, y}); }
    Finger& presses() { return does(window::ButtonEvent{window::MouseButton::kLeft, true}); }
    Finger& lifts() { return does(window::ButtonEvent{window::MouseButton::kLeft, false}); }
    Finger& types(window::Key key) { return does(window::KeyEvent{key, true, false}); }
    Finger& does(const window::Event& event) {
        pointer.handle(event, now_s, news);
        return *this;
    }
    Finger& waits(double seconds) {
        const double until_s = now_s + seconds;
        for (; now_s < until_s; now_s += 0.05)
            pointer.pass_time(now_s, news);
        return *this;
    }
    [[nodiscard]] std::vector<Button> pressed() const {
        std::vector<Button> buttons;
        for (const PointerNews& one : news) {
            if (one.kind == Kind::kPressed) buttons.push_back(one.button);
        }
        return buttons;
    }
    // How much of that was a sign of life.
    [[nodiscard]] int signs_of(Kind kind) const {
        return static_cast<int>(std::count_if(
            news.begin(), news.end(), [&](const PointerNews& one) { return one.kind == kind && one.lives; }));
    }
    [[nodiscard]] bool said(Kind kind) const {
        return std::any_of(news.begin(), news.end(),
                           [&](const PointerNews& one) { return one.kind == kind; });
    }

    screens::Composition composition = screen();
    KioskPointer pointer;
    std::vector<PointerNews> news;
    double now_s = 0.0;
};

struct KioskPointer : testing::Test {
    void second(window::TouchPhase phase, double x, double y) {
        finger.does(window::SecondFingerEvent{phase, x, y});
    }
    [[nodiscard]] long count(Kind kind) const {
        return std::count_if(finger.news.begin(), finger.news.end(),
                             [&](const PointerNews& one) { return one.kind == kind; });
    }

    Finger finger;
};

TEST_F(KioskPointer, GivesASecondFingerTheSceneAndNoButton) {
    using window::TouchPhase;
    finger.moves(640.0, 300.0).presses();
    second(TouchPhase::kBegin, 150.0, 630.0);  // on Done
    second(TouchPhase::kMove, 640.0, 200.0);
    second(TouchPhase::kEnd, 640.0, 200.0);
    EXPECT_TRUE(finger.pressed().empty());
    EXPECT_EQ(count(Kind::kSecondDown) + count(Kind::kSecondMoved) + count(Kind::kSecondUp), 0);
    EXPECT_EQ(count(Kind::kFingerUp), 0) << "the first is not disturbed";

    second(TouchPhase::kBegin, 600.0, 250.0);
    second(TouchPhase::kMove, 605.0, 250.0);
    finger.lifts();
    second(TouchPhase::kMove, 610.0, 250.0);
    second(TouchPhase::kEnd, 610.0, 250.0);
    EXPECT_EQ(count(Kind::kSecondDown), 1);
    EXPECT_EQ(count(Kind::kSecondMoved), 2);
    EXPECT_EQ(count(Kind::kSecondUp), 1);
}

TEST_F(KioskPointer, EndsASecondFingerThatLeavesOrLiesStill) {
    using window::TouchPhase;
    second(TouchPhase::kBegin, 600.0, 250.0);
    second(TouchPhase::kMove, -30.0, 250.0);
    EXPECT_EQ(count(Kind::kSecondUp), 1);
    second(TouchPhase::kBegin, 600.0, 250.0);
    finger.waits(61.0);
    EXPECT_EQ(count(Kind::kSecondUp), 2);
    second(TouchPhase::kBegin, 600.0, 250.0);
    finger.does(window::FocusEvent{false});
    EXPECT_EQ(count(Kind::kSecondUp), 3);
    second(TouchPhase::kMove, 620.0, 250.0);
    EXPECT_EQ(count(Kind::kSecondMoved), 0) << "its press was not seen";
}

TEST_F(KioskPointer, LetsTheScanWaitForAVoice) {
    finger.types(window::Key::kSpace);
    EXPECT_EQ(finger.pointer.focus(), 0);
    finger.pointer.hold_scan(true);
    finger.waits(10.0);
    EXPECT_EQ(finger.pointer.focus(), 0) << "its name is being said";
    finger.pointer.hold_scan(false);
    finger.waits(1.2);
    EXPECT_EQ(finger.pointer.focus(), 0) << "time to press";
    finger.waits(0.4);
    EXPECT_EQ(finger.pointer.focus(), 1);
}

TEST_F(KioskPointer, TakesTheQuestionWhereOneIsAsNoOtherKey) {
    finger.types(window::Key::kW);
    EXPECT_TRUE(finger.said(Kind::kWhere));
    EXPECT_FALSE(finger.said(Kind::kLife)) << "it ends no demonstration";
}

TEST_F(KioskPointer, PressesOnReleaseOverTheSameTarget) {
    finger.moves(150, 630).presses();
    EXPECT_EQ(finger.pointer.pressed(), 0);
    EXPECT_TRUE(finger.pressed().empty());
    finger.lifts();
    EXPECT_EQ(finger.pressed(), std::vector<Button>{Button::kDone});
    EXPECT_EQ(finger.pointer.pressed(), -1);
}

TEST_F(KioskPointer, LetsAPressBeTakenBackByLeavingTheTarget) {
    finger.moves(150, 630).presses().moves(150, 500);
    EXPECT_EQ(finger.pointer.pressed(), -1) << "it no longer looks pressed";
    finger.lifts();
    EXPECT_TRUE(finger.pressed().empty());
}

TEST_F(KioskPointer, DropsAPressThatEndsOnAnotherScreen) {
    finger.moves(150, 630).presses();
    finger.pointer.look_at(&finger.composition, 2, false);
    finger.lifts();
    EXPECT_TRUE(finger.pressed().empty());
}

TEST_F(KioskPointer, StaysOnItsButtonWhenAnotherOneGoes) {
    screens::Composition fewer = screen_without_done();
    finger.moves(320, 630).presses();
    finger.pointer.look_at(&fewer, 1, false);
    EXPECT_EQ(finger.pointer.pressed(), 0);
    finger.lifts();
    EXPECT_EQ(finger.pressed(), std::vector<Button>{Button::kToolMore}) << "and not what took its place";
    Finger keys;
    keys.types(window::Key::kTab).types(window::Key::kTab);
    keys.pointer.look_at(&fewer, 1, false);
    EXPECT_EQ(keys.pointer.focus(), 0);
    keys.pointer.look_at(&keys.composition, 1, false);
    keys.types(window::Key::kEnter);
    EXPECT_EQ(keys.pressed(), std::vector<Button>{Button::kToolMore});
}

TEST_F(KioskPointer, PressesNoTargetIfItsButtonIsGone) {
    screens::Composition fewer = screen_without_done();
    finger.moves(150, 630).presses();
    finger.pointer.look_at(&fewer, 1, false);
    EXPECT_EQ(finger.pointer.pressed(), -1);
    finger.waits(1.1).lifts();
    EXPECT_TRUE(finger.pressed().empty());
    Finger keys;
    keys.types(window::Key::kLeftBracket);
    EXPECT_EQ(keys.pointer.focus(), 2);
    fewer.targets.pop_back();
    keys.pointer.look_at(&fewer, 1, false);
    EXPECT_EQ(keys.pointer.focus(), 0) << "the ring is on the remaining button";
}

TEST_F(KioskPointer, RepeatsOnlyRepeatingTargets) {
    finger.moves(320, 630).presses().waits(1.1).lifts();
    EXPECT_EQ(finger.pressed().size(), 3U) << "after half a second, and every quarter from then on";
    Finger other;
    other.moves(150, 630).presses().waits(1.1).lifts();
    EXPECT_EQ(other.pressed().size(), 1U);
}

TEST_F(KioskPointer, GivesTheSceneAHandWhereNoTargetIs) {
    finger.moves(640, 300);
    EXPECT_TRUE(finger.said(Kind::kHovered));
    finger.presses().moves(600, 300).lifts();
    EXPECT_TRUE(finger.said(Kind::kFingerDown));
    EXPECT_TRUE(finger.said(Kind::kFingerMoved));
    EXPECT_TRUE(finger.said(Kind::kFingerUp));
    EXPECT_TRUE(finger.pressed().empty());
}

class TouchThatGoesWrong : public ::testing::Test {
  protected:
    TouchThatGoesWrong() {
        finger_.moves(640, 300).presses().moves(600, 300);
        finger_.news.clear();
    }
    [[nodiscard]] bool ended() const { return finger_.said(Kind::kFingerUp); }
    // Checks that later events of this touch do nothing to the clay.
    void stays_ended() {
        EXPECT_FALSE(finger_.pointer.rests_on_scene());
        finger_.news.clear();
        finger_.moves(610, 300).lifts();
        EXPECT_FALSE(finger_.said(Kind::kFingerMoved));
        EXPECT_FALSE(finger_.said(Kind::kFingerUp)) << "it is told once";
        finger_.news.clear();
        finger_.presses().moves(620, 300);
        EXPECT_TRUE(finger_.said(Kind::kFingerDown)) << "the next touch is as good as any";
        EXPECT_TRUE(finger_.said(Kind::kFingerMoved));
    }

    Finger finger_;
};

TEST_F(TouchThatGoesWrong, EndsWhereItLeavesTheWindow) {
    finger_.moves(1279.6, 300);
    EXPECT_FALSE(ended());
    finger_.moves(1300, 300);
    EXPECT_TRUE(ended());
    stays_ended();
}

TEST_F(TouchThatGoesWrong, EndsWithASecondButton) {
    finger_.does(window::ButtonEvent{window::MouseButton::kRight, true});
    EXPECT_TRUE(ended());
    finger_.does(window::ButtonEvent{window::MouseButton::kRight, false});
    stays_ended();
    Finger other;
    other.moves(640, 300).does(window::ButtonEvent{window::MouseButton::kRight, true}).presses();
    EXPECT_FALSE(other.said(Kind::kFingerDown)) << "in whichever order";
}

TEST_F(TouchThatGoesWrong, EndsAfterAMinuteWithoutMotion) {
    finger_.waits(58.0);
    EXPECT_FALSE(ended());
    finger_.moves(602, 301).waits(1.0);
    EXPECT_FALSE(ended());
    finger_.waits(1.5);
    EXPECT_TRUE(ended()) << "a tremble is no motion";
    stays_ended();
}

TEST_F(TouchThatGoesWrong, GoesOnWhileItMoves) {
    for (int minute = 0; minute < 5; ++minute)
        finger_.waits(50.0).moves(600 + 10 * (minute % 2), 310);
    EXPECT_FALSE(ended());
}

TEST_F(TouchThatGoesWrong, EndsWhenTheWindowLosesAttention) {
    finger_.does(window::FocusEvent{true});
    EXPECT_FALSE(ended());
    finger_.does(window::FocusEvent{false});
    EXPECT_TRUE(ended());
    stays_ended();
    Finger other;
    other.moves(150, 630).presses().does(window::FocusEvent{false}).lifts();
    EXPECT_TRUE(other.pressed().empty()) << "nor is a button pressed by what comes after";
}

TEST_F(TouchThatGoesWrong, EndsWithAPlaceThatIsNoNumber) {
    constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    finger_.moves(kNoNumber, 300);
    EXPECT_TRUE(ended());
    EXPECT_FALSE(finger_.said(Kind::kFingerMoved));
    stays_ended();
}

TEST_F(TouchThatGoesWrong, EndsWhereItsReleaseWasLost) {
    finger_.presses();
    EXPECT_TRUE(ended());
    EXPECT_TRUE(finger_.said(Kind::kFingerDown)) << "and another begins";
    finger_.lifts();
    EXPECT_FALSE(finger_.pointer.rests_on_scene());
}

TEST_F(TouchThatGoesWrong, IsNoSignOfLifeWhileItTrembles) {
    for (int turn = 0; turn < 100; ++turn)
        finger_.moves(600 + 3 * (turn % 2), 300).waits(0.1);
    EXPECT_EQ(finger_.signs_of(Kind::kFingerMoved), 0) << "each move was one";
    EXPECT_TRUE(finger_.said(Kind::kFingerMoved)) << "the clay follows it";
    finger_.moves(610, 300);
    EXPECT_EQ(finger_.signs_of(Kind::kFingerMoved), 1);
}

TEST_F(TouchThatGoesWrong, EndsWhereItNeverComesToRest) {
    const auto wanders = [&](int turns) {
        for (int turn = 0; turn < turns; ++turn)
            finger_.moves(600 + 9 * (turn % 2), 300).waits(1.0);
    };
    wanders(590);
    EXPECT_FALSE(ended());
    wanders(80);
    EXPECT_TRUE(ended()) << "a drop of water";
    EXPECT_EQ(finger_.pointer.restless(), std::vector<std::string>{"touch screen or mouse button"});
    stays_ended();
    finger_.lifts().waits(61.0);
    EXPECT_TRUE(finger_.pointer.restless().empty()) << "it was wiped off";
}

TEST_F(KioskPointer, TakesASpotThatPressesItselfForWornAndPressesBesideItNot) {
    int pressed = 0;
    for (int second = 0; second < 700; second += 2) {
        finger.news.clear();
        finger.moves(150, 630).presses().waits(0.2).lifts().waits(1.8);
        pressed += static_cast<int>(finger.pressed().size());
    }
    EXPECT_NEAR(pressed, 300, 6) << "it went on for ever";
    EXPECT_EQ(finger.pointer.restless().size(), 1U);
    finger.news.clear();
    finger.moves(550, 630).presses().lifts();
    EXPECT_EQ(finger.pressed(), std::vector<Button>{Button::kGlaze});
}

TEST_F(KioskPointer, TakesManyPeopleForNoWornSpot) {
    for (int second = 0; second < 1500; second += 2) {
        finger.news.clear();
        finger.moves(second % 4 == 0 ? 150 : 550, 630).presses().lifts().waits(2.0);
        EXPECT_EQ(finger.pressed().size(), 1U) << second;
    }
}

TEST_F(KioskPointer, RepeatsWhatIsHeldForAMinute) {
    finger.moves(320, 630).presses().waits(59.0);
    const std::size_t before = finger.pressed().size();
    EXPECT_GT(before, 200U);
    finger.waits(2.0);
    const std::size_t after = finger.pressed().size();
    finger.waits(600.0);
    EXPECT_EQ(finger.pressed().size(), after);
    EXPECT_EQ(finger.pointer.restless(), std::vector<std::string>{"touch screen or mouse button"});
    finger.lifts().waits(0.1);
    EXPECT_TRUE(finger.pointer.restless().empty());
}

TEST_F(KioskPointer, TakesARepeatingKeyForNoSignOfLifeAndEndsItAfterAMinute) {
    finger.types(window::Key::kUp);
    EXPECT_EQ(finger.signs_of(Kind::kLife), 1);
    EXPECT_EQ(finger.signs_of(Kind::kNudged), 1);
    const auto repeats = [&](double seconds) {
        finger.news.clear();
        for (double since_s = 0.0; since_s < seconds; since_s += 0.5)
            finger.does(window::KeyEvent{window::Key::kUp, true, true}).waits(0.5);
    };
    repeats(59.0);
    EXPECT_EQ(finger.signs_of(Kind::kLife) + finger.signs_of(Kind::kNudged), 0) << "each repeat was one";
    EXPECT_TRUE(finger.said(Kind::kNudged)) << "the hand moves on";
    repeats(2.0);
    repeats(450.0);
    EXPECT_TRUE(finger.news.empty());
    EXPECT_TRUE(finger.pointer.restless().empty());
    repeats(150.0);
    EXPECT_EQ(finger.pointer.restless(), std::vector<std::string>{"keyboard"});
    finger.does(window::KeyEvent{window::Key::kUp, false, false});
    EXPECT_TRUE(finger.pointer.restless().empty());
    finger.types(window::Key::kUp);
    EXPECT_EQ(finger.signs_of(Kind::kNudged), 1);
}

TEST_F(KioskPointer, TakesOneSwitchForAPersonHoweverLongItIsUsed) {
    for (int press = 0; press < 900; ++press) {
        finger.news.clear();
        finger.types(window::Key::kSpace)
            .does(window::KeyEvent{window::Key::kSpace, false, false})
            .waits(2.0);
        EXPECT_EQ(finger.pressed().empty(), press == 0);
    }
    EXPECT_TRUE(finger.pointer.restless().empty());
}

TEST_F(KioskPointer, TakesAMouseThatWandersForNobodyAfterTenMinutes) {
    const auto wanders = [&](int turns) {
        finger.news.clear();
        for (int turn = 0; turn < turns; ++turn)
            finger.moves(640 + 40 * (turn % 2), 360).waits(1.0);
    };
    wanders(590);
    EXPECT_GT(finger.signs_of(Kind::kLife), 500);
    wanders(20);
    wanders(900);
    EXPECT_EQ(finger.signs_of(Kind::kLife), 0) << "it was somebody for ever";
    EXPECT_EQ(finger.pointer.restless(), std::vector<std::string>{"mouse"});
    finger.moves(900, 360).waits(0.1).moves(1000, 200).waits(0.2);
    EXPECT_TRUE(finger.said(Kind::kLife)) << "a hand";
    finger.waits(61.0);
    EXPECT_TRUE(finger.pointer.restless().empty());
}

TEST_F(KioskPointer, TakesAWheelThatNeverStopsForNobodyAfterTenMinutes) {
    const auto turns = [&](int times) {
        finger.news.clear();
        for (int turn = 0; turn < times; ++turn)
            finger.does(window::ScrollEvent{1.0}).waits(1.0);
        return finger.signs_of(Kind::kLife);
    };
    EXPECT_EQ(turns(590), 590);
    turns(20);
    EXPECT_EQ(turns(600), 0);
    EXPECT_EQ(finger.pointer.restless(), std::vector<std::string>{"mouse wheel"});
    finger.waits(61.0);
    EXPECT_EQ(turns(1), 1);
}

TEST_F(KioskPointer, IgnoresAShakenMouse) {
    finger.moves(640, 360);
    EXPECT_FALSE(finger.said(Kind::kLife)) << "it only lies where the window opened";
    for (int i = 0; i < 50; ++i)
        finger.moves(640 + i % 2, 360 + i % 3);
    EXPECT_FALSE(finger.said(Kind::kLife));
    finger.moves(700, 360).waits(0.2);
    EXPECT_FALSE(finger.said(Kind::kLife)) << "it was put there";
    finger.waits(5.0).moves(640, 360).waits(0.2);
    EXPECT_FALSE(finger.said(Kind::kLife)) << "and there";
    finger.moves(670, 360).moves(700, 360).waits(0.2);
    EXPECT_TRUE(finger.said(Kind::kLife));
}

TEST_F(KioskPointer, LandsOnATargetWithoutWakingTheScreenFirst) {
    // A touch arrives as a jump of the mouse and a press; if the jump counted as activity, the idle panel
    // would disappear before its button is pressed.
    finger.moves(640, 100).waits(0.2);
    finger.news.clear();
    finger.moves(150, 630).presses().waits(0.2).lifts();
    EXPECT_FALSE(finger.said(Kind::kLife));
    EXPECT_EQ(finger.pressed(), std::vector<Button>{Button::kDone});
    finger.news.clear();
    finger.moves(400, 500).moves(640, 300).waits(0.2);
    EXPECT_TRUE(finger.said(Kind::kLife)) << "a mouse that goes its way";
}

TEST_F(KioskPointer, PressesTheFocusedTargetWithoutWakingTheScreenFirst) {
    for (const window::Key key : {window::Key::kEnter, window::Key::kSpace}) {
        Finger hand;
        hand.types(key);
        EXPECT_TRUE(hand.said(Kind::kLife)) << "without a ring it only says that somebody is there";
        hand.types(window::Key::kTab);
        hand.news.clear();
        hand.types(key);
        EXPECT_FALSE(hand.said(Kind::kLife));
        EXPECT_EQ(hand.pressed().size(), 1U);
    }
}

TEST_F(KioskPointer, WalksWithTabAndPressesWithEnter) {
    finger.types(window::Key::kTab)
        .types(window::Key::kTab)
        .types(window::Key::kTab)
        .types(window::Key::kEnter);
    ASSERT_EQ(finger.pressed(), std::vector<Button>{Button::kGlaze});
    EXPECT_EQ(finger.news.back().value, 4);
    finger.types(window::Key::kTab);
    EXPECT_EQ(finger.pointer.focus(), 0) << "round";
    finger.types(window::Key::kUp);
    EXPECT_EQ(finger.news.back().kind, Kind::kNudged);
}

TEST_F(KioskPointer, WalksWithArrowKeysWhereTheyAreNoHand) {
    finger.pointer.walk(Button::kHandRight);
    EXPECT_EQ(finger.pointer.focus(), 0);
    finger.pointer.walk(Button::kHandLeft);
    EXPECT_EQ(finger.pointer.focus(), 2) << "round";
    finger.pointer.look_at(&finger.composition, 2, true);
    EXPECT_EQ(finger.pointer.focus(), 0) << "the ring stays on the next screen";
    finger.pointer.walk(Button::kHandLeft);
    EXPECT_EQ(finger.pointer.focus(), 1) << "onwards, from right to left";
    finger.pointer.walk(Button::kHandDown);
    EXPECT_EQ(finger.pointer.focus(), 2);
    EXPECT_TRUE(finger.pointer.arrows_walk());
    finger.types(window::Key::kTab);
    EXPECT_FALSE(finger.pointer.arrows_walk());
}

TEST_F(KioskPointer, LeavesTheArrowKeysToTheHandAtTheClayUntilEnter) {
    finger.pointer.walk(Button::kHandDown);
    finger.pointer.look_at(&finger.composition, 2, false, true);
    EXPECT_EQ(finger.pointer.focus(), -1);
    finger.types(window::Key::kEnter);
    EXPECT_EQ(finger.news.back().kind, Kind::kPutDown);
    EXPECT_TRUE(finger.pressed().empty());
    finger.pointer.begin_walk();
    EXPECT_EQ(finger.pointer.focus(), 0);
    finger.pointer.walk(Button::kHandLeft);
    EXPECT_EQ(finger.pointer.focus(), -1) << "before the first";
    finger.pointer.begin_walk();
    for (int i = 0; i < 3; ++i)
        finger.pointer.walk(Button::kHandRight);
    EXPECT_EQ(finger.pointer.focus(), -1) << "beyond the last";
    finger.pointer.look_at(&finger.composition, 3, false);
    EXPECT_EQ(finger.pointer.focus(), 0) << "the next screen is walked again";
    finger.pointer.walk(Button::kHandDown);
    finger.types(window::Key::kTab);
    finger.pointer.look_at(&finger.composition, 4, false, true);
    EXPECT_EQ(finger.pointer.focus(), 0) << "a ring that Tab moved stays, and the arrows are the hand's";
    EXPECT_FALSE(finger.pointer.arrows_walk());
}

TEST_F(KioskPointer, IsUsedWithOneSwitchAlone) {
    finger.types(window::Key::kSpace);
    EXPECT_TRUE(finger.pointer.scans());
    EXPECT_EQ(finger.pointer.focus(), 0);
    EXPECT_TRUE(finger.pressed().empty());
    finger.waits(1.5);
    EXPECT_EQ(finger.pointer.focus(), 1);
    finger.types(window::Key::kSpace);
    EXPECT_EQ(finger.pressed(), std::vector<Button>{Button::kToolMore});
    finger.waits(3.0);
    EXPECT_EQ(finger.pointer.focus(), 0);
}

TEST_F(KioskPointer, OpensTheCornerWhenHeldForFiveSeconds) {
    finger.moves(20, 20).presses().waits(4.5);
    EXPECT_FALSE(finger.said(Kind::kCornerHeld));
    finger.waits(1.0);
    EXPECT_TRUE(finger.said(Kind::kCornerHeld));
    Finger other;
    other.moves(20, 20).presses().waits(3.0).moves(200, 200).moves(20, 20).waits(3.0);
    EXPECT_FALSE(other.said(Kind::kCornerHeld)) << "the finger left it";
    Finger mirrored;
    mirrored.pointer.look_at(&mirrored.composition, 1, true);
    mirrored.moves(1270, 20).presses().waits(5.2);
    EXPECT_TRUE(mirrored.said(Kind::kCornerHeld)) << "on the other side where the page is mirrored";
}

TEST_F(KioskPointer, StopsTheForceWithPause) {
    finger.types(window::Key::kPause);
    EXPECT_TRUE(finger.said(Kind::kStopForce));
}

TEST_F(KioskPointer, AsksToCloseForEveryWayOutThatWindowsHave) {
    for (const window::Event& way : {window::Event(window::CloseEvent{}),
                                     window::Event(window::KeyEvent{window::Key::kEscape, true, false}),
                                     window::Event(window::KeyEvent{window::Key::kQ, true, false})}) {
        Finger hand;
        hand.does(way);
        EXPECT_EQ(hand.news.back().kind, Kind::kCloseAsked);
    }
}

TEST(BenchTouch, TakesTheToolThatIsTapped) {
    BenchTouch touch;
    touch.begin(tool::Tool::kRib, {100.0F, 200.0F}, 24.0F);
    EXPECT_FALSE(touch.becomes_drag({110.0F, 210.0F})) << "a finger slips a little";
    EXPECT_EQ(touch.lift(), tool::Tool::kRib);
    EXPECT_FALSE(touch.lift()) << "once";
}

TEST(BenchTouch, LeavesTheToolToADragAndTellsItOnce) {
    BenchTouch touch;
    touch.begin(tool::Tool::kWire, {100.0F, 200.0F}, 72.0F);
    EXPECT_FALSE(touch.becomes_drag({100.0F, 225.0F})) << "a large screen has more pixels";
    EXPECT_TRUE(touch.becomes_drag({100.0F, 275.0F}));
    EXPECT_FALSE(touch.becomes_drag({100.0F, 290.0F}));
    EXPECT_FALSE(touch.lift());
}

TEST(BenchTouch, IsNoneWhereNoToolWasTouched) {
    BenchTouch touch;
    EXPECT_FALSE(touch.becomes_drag({500.0F, 500.0F}));
    EXPECT_FALSE(touch.lift());
}

}  // namespace
}  // namespace onggi::app
