// Fingers, keys and a single switch on a screen of three targets.
#include "game/app/kiosk/finger/kiosk_pointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

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
    Finger finger;
};

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

}  // namespace
}  // namespace onggi::app
