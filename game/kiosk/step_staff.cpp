// The staff's keypad and panel.
#include <algorithm>
#include <cmath>
#include <utility>

#include "game/kiosk/step_screens.h"

namespace onggi::kiosk {
namespace {

void count_wrong_pin(Turn& turn) {
    PinGuard& guard = turn.state.pin_guard;
    const Rules& rules = turn.rules;
    ++guard.wrong;
    if (guard.wrong < rules.pin_tries) return;
    constexpr int kMostDoublings = 30;
    const int doublings = std::min(guard.wrong - rules.pin_tries, kMostDoublings);
    const double wait_s = std::min(std::ldexp(rules.pin_wait_s, doublings), rules.pin_longest_wait_s);
    guard.opens_s = turn.now_s + wait_s;
}

void press_pin(Turn& turn, const event::Pressed& event) {
    Staff& staff = turn.state.staff;
    if (event.button == Button::kPinClear) staff = {};
    if (event.button != Button::kDigit || event.value < 0 || event.value > 9) return;
    if (pin_seconds_left(turn.state, turn.now_s) > 0) return;
    staff.typed = staff.typed * 10 + event.value;
    staff.was_wrong = false;
    if (++staff.digits < turn.rules.pin_digits) return;
    const bool right = staff.typed == turn.rules.pin;
    staff = {.was_wrong = !right};
    if (!right) return count_wrong_pin(turn);
    turn.state.pin_guard = {};
    turn.lay_over(Panel::kStaff);
}

// Handles the answer to a confirmation.
void answer_question(Turn& turn, bool yes) {
    Staff& staff = turn.state.staff;
    const StaffQuestion question = std::exchange(staff.question, StaffQuestion::kNone);
    if (!yes) return;
    switch (question) {
        case StaffQuestion::kDeletePot:
            turn.add(effect::DeletePot{staff.pot});
            break;
        case StaffQuestion::kWithdrawCode:
            turn.add(effect::WithdrawCode{staff.pot});
            break;
        case StaffQuestion::kRestart:
            turn.add(effect::Restart{});
            break;
        case StaffQuestion::kQuit:
            turn.add(effect::Quit{});
            break;
        case StaffQuestion::kNone:
            break;
    }
}

void press_panel(Turn& turn, const event::Pressed& event) {
    Staff& staff = turn.state.staff;
    switch (event.button) {
        case Button::kStaffPage:
            if (event.value < 0 || event.value >= kStaffPageCount) break;
            staff.page = static_cast<StaffPage>(event.value);
            staff.first_line = 0;
            break;
        case Button::kStaffList:
            staff.first_line = std::max(0, event.value);
            break;
        case Button::kStaffForceTest:
            turn.add(effect::TestForce{});
            break;
        case Button::kStaffSoundTest:
            turn.add(effect::TestSound{});
            break;
        case Button::kSoundLess:
        case Button::kSoundMore:
            turn.change_volume(event.button == Button::kSoundMore ? 1 : -1);
            if (turn.state.house_volume == turn.state.comfort.volume) break;
            turn.state.house_volume = turn.state.comfort.volume;
            turn.add(effect::KeepHouse{});
            break;
        case Button::kStaffLanguage:
            turn.state.house_language = (turn.state.house_language + 1) % turn.rules.language_count;
            turn.state.comfort.language = turn.state.house_language;
            turn.add(effect::KeepHouse{});
            break;
        case Button::kStaffDeletePot:
        case Button::kStaffWithdrawCode:
            staff.question = event.button == Button::kStaffDeletePot ? StaffQuestion::kDeletePot
                                                                     : StaffQuestion::kWithdrawCode;
            staff.pot = event.value;
            break;
        case Button::kStaffRestart:
            staff.question = StaffQuestion::kRestart;
            break;
        case Button::kStaffQuit:
            staff.question = StaffQuestion::kQuit;
            break;
        default:
            break;
    }
}

}  // namespace

void press_staff(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kPinClose || event.button == Button::kStaffClose) {
        turn.leave_staff();
    } else if (turn.state.panel == Panel::kPin) {
        press_pin(turn, event);
    } else if (turn.state.staff.question == StaffQuestion::kNone) {
        press_panel(turn, event);
    } else if (event.button == Button::kStaffYes || event.button == Button::kStaffNo) {
        answer_question(turn, event.button == Button::kStaffYes);
    }
}

}  // namespace onggi::kiosk
