// The staff's states: the keypad's timeouts, and the panel's keys.
#include <gtest/gtest.h>

#include "tests/unit/visit/visitor.h"

namespace onggi::visit {
namespace {

Visitor at_the_keypad() {
    Visitor staff(Rules{.locked = true, .pin = 1234, .pin_digits = 4});
    staff.does(event::CornerHeld{});
    return staff;
}

Visitor& types(Visitor& staff, int first) {
    for (const int digit : {first, 2, 3, 4})
        staff.presses(Button::kDigit, digit);
    return staff;
}

Visitor at_the_panel() {
    Visitor staff = at_the_keypad();
    types(staff, 1);
    staff.all.clear();
    return staff;
}

TEST(StaffPin, MakesEachWrongGuessWaitLonger) {
    Visitor thief = at_the_keypad();
    types(thief, 9);
    types(thief, 9);
    EXPECT_EQ(pin_seconds_left(thief.state, thief.now_s), 0) << "anybody mistypes";
    types(thief, 9);
    EXPECT_EQ(pin_seconds_left(thief.state, thief.now_s), 15);
    types(thief, 1);
    EXPECT_EQ(thief.state.panel, Panel::kPin) << "not even the right one counts now";
    EXPECT_EQ(thief.state.staff.digits, 0);
    thief.waits(14.9);
    types(thief, 1);
    EXPECT_EQ(thief.state.panel, Panel::kPin);
    thief.waits(0.2);
    types(thief, 9);
    EXPECT_EQ(pin_seconds_left(thief.state, thief.now_s), 30);
    for (int tries = 0; tries < 60; ++tries) {
        thief.now_s = thief.state.pin_guard.opens_s;
        types(thief, 9);
        EXPECT_LE(pin_seconds_left(thief.state, thief.now_s), 900);
    }
    EXPECT_EQ(pin_seconds_left(thief.state, thief.now_s), 900);
}

TEST(StaffPin, RemembersTheWaitThroughClosingAndThroughVisits) {
    Visitor thief = at_the_keypad();
    for (int tries = 0; tries < 3; ++tries)
        types(thief, 9);
    thief.presses(Button::kPinClose).does(event::CornerHeld{});
    types(thief, 1);
    EXPECT_EQ(thief.state.panel, Panel::kPin);
    thief.presses(Button::kPinClear).presses(Button::kPinClose).starts_to_throw();
    thief.does(event::Fault{}).does(event::FaultOver{}).does(event::CornerHeld{});
    types(thief, 1);
    EXPECT_EQ(thief.state.panel, Panel::kPin);
    thief.waits(15.0);
    types(thief, 1);
    EXPECT_EQ(thief.state.panel, Panel::kStaff);
    EXPECT_EQ(thief.state.pin_guard.wrong, 0) << "the right one makes it good";
}

TEST(StaffPanel, TestsForceAndSoundAtOnce) {
    Visitor staff = at_the_panel();
    staff.presses(Button::kStaffForceTest).presses(Button::kStaffSoundTest);
    const std::vector<Effect> expected{effect::TestForce{}, effect::TestSound{}};
    EXPECT_EQ(staff.all, expected);
}

TEST(StaffPanel, AsksBeforeItDestroysAnything) {
    const struct {
        Button button;
        Effect effect;
    } kCases[] = {{Button::kStaffDeletePot, effect::DeletePot{7}},
                  {Button::kStaffWithdrawCode, effect::WithdrawCode{7}},
                  {Button::kStaffRestart, effect::Restart{}},
                  {Button::kStaffQuit, effect::Quit{}}};
    for (const auto& one : kCases) {
        Visitor staff = at_the_panel();
        staff.presses(one.button, 7);
        EXPECT_TRUE(staff.all.empty());
        EXPECT_NE(staff.state.staff.question, StaffQuestion::kNone);
        staff.presses(Button::kStaffForceTest).presses(Button::kStaffPage, 1);
        EXPECT_TRUE(staff.all.empty()) << "nothing else until it is answered";
        EXPECT_EQ(staff.state.staff.page, StaffPage::kHealth);
        staff.presses(Button::kStaffNo).presses(Button::kStaffYes);
        EXPECT_TRUE(staff.all.empty()) << "a confirmation without a question";
        staff.presses(one.button, 7).presses(Button::kStaffYes);
        ASSERT_EQ(staff.all.size(), 1U);
        EXPECT_EQ(staff.all.front(), one.effect);
        EXPECT_EQ(staff.state.staff.question, StaffQuestion::kNone);
    }
}

TEST(StaffPanel, ForgetsAQuestionThatWasLeft) {
    Visitor staff = at_the_panel();
    staff.presses(Button::kStaffQuit).waits(200.0).does(event::CornerHeld{});
    types(staff, 1);
    ASSERT_EQ(staff.state.panel, Panel::kStaff);
    staff.presses(Button::kStaffYes);
    EXPECT_FALSE(staff.caused<effect::Quit>());
}

TEST(StaffPanel, SetsTheVolumeForAllVisitsToCome) {
    Visitor staff = at_the_panel();
    staff.presses(Button::kSoundMore).presses(Button::kSoundMore).presses(Button::kSoundMore);
    EXPECT_EQ(staff.state.comfort.volume, 5);
    EXPECT_EQ(staff.count<effect::SetVolume>(), 2) << "there is no sixth step";
    EXPECT_EQ(staff.count<effect::KeepHouse>(), 2);
    staff.presses(Button::kStaffClose).starts_to_throw();
    EXPECT_EQ(staff.state.comfort.volume, 5);
    staff.presses(Button::kLanguages).presses(Button::kSoundLess).presses(Button::kSoundLess);
    EXPECT_EQ(staff.count<effect::KeepHouse>(), 2) << "a visitor sets it for themselves";
    staff.presses(Button::kComfortDone).waits(80.0);
    EXPECT_EQ(staff.state.screen, Screen::kAttract);
    EXPECT_EQ(staff.state.comfort.volume, 5);
    EXPECT_EQ(staff.all.rbegin()[1], (Effect(effect::SetVolume{5})));
}

TEST(StaffPanel, SetsTheLanguageThatAllVisitsToComeBeginIn) {
    Visitor staff = at_the_panel();
    const int first = staff.state.comfort.language;
    staff.presses(Button::kStaffLanguage);
    const int next = (first + 1) % staff.rules.language_count;
    EXPECT_EQ(staff.state.comfort.language, next);
    EXPECT_TRUE(staff.caused<effect::KeepHouse>());
    staff.presses(Button::kStaffClose).starts_to_throw();
    EXPECT_EQ(staff.state.comfort.language, next);
    staff.presses(Button::kLanguages).does(event::Pressed{Button::kLanguage, first});
    EXPECT_EQ(staff.state.comfort.language, first);
    staff.presses(Button::kComfortDone).waits(80.0);
    EXPECT_EQ(staff.state.screen, Screen::kAttract);
    EXPECT_EQ(staff.state.comfort.language, next) << "a visitor's choice is the visitor's alone";
}

TEST(StaffPanel, TurnsItsPagesAndTheirLists) {
    Visitor staff = at_the_panel();
    staff.presses(Button::kStaffPage, 2).presses(Button::kStaffList, 8);
    EXPECT_EQ(staff.state.staff.page, StaffPage::kGallery);
    EXPECT_EQ(staff.state.staff.first_line, 8);
    staff.presses(Button::kStaffPage, 3);
    EXPECT_EQ(staff.state.staff.first_line, 0) << "another page begins at its top";
    staff.presses(Button::kStaffPage, 4).presses(Button::kStaffPage, -1).presses(Button::kStaffList, -5);
    EXPECT_EQ(staff.state.staff.page, StaffPage::kDevices);
    EXPECT_EQ(staff.state.staff.first_line, 0);
}

TEST(StaffPanel, StaysOpenOverAFaultThatTheStaffLooksInto) {
    Visitor staff = at_the_panel();
    staff.presses(Button::kStaffPage, 3).does(event::Fault{});
    EXPECT_EQ(staff.state.screen, Screen::kFault);
    EXPECT_EQ(staff.state.panel, Panel::kStaff);
    EXPECT_EQ(staff.state.staff.page, StaffPage::kDevices);
}

}  // namespace
}  // namespace onggi::visit
