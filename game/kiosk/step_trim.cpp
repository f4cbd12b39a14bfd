// Trimming the foot of a leather-hard pot, offered if the foot has spare clay. Trimming is optional.
#include <algorithm>

#include "game/kiosk/step_screens.h"

namespace onggi::kiosk {
namespace {

void end_trimming(Turn& turn) {
    turn.add(Effect::Kind::kEndTrim, turn.state.trimming.touched ? 1 : 0);
    begin_decorating(turn);
}

}  // namespace

void end_drying(Turn& turn) {
    if (!turn.state.trimming.is_offered) return begin_decorating(turn);
    turn.state.trimming = {};
    turn.add(Effect::Kind::kBeginTrim);
    turn.show(Screen::kTrim);
}

void press_trim(Turn& turn, const Event& event) {
    Trimming& trimming = turn.state.trimming;
    Throwing& throwing = turn.state.throwing;
    switch (event.button) {
        case Button::kUndo:
            turn.add(Effect::Kind::kUndo);
            break;
        case Button::kToolLess:
        case Button::kToolMore:
            change(trimming.loop, event.button == Button::kToolMore ? 1 : -1, kMostTool);
            break;
        case Button::kSpeedLess:
        case Button::kSpeedMore:
            change(throwing.speed, event.button == Button::kSpeedMore ? 1 : -1, kMostSpeed);
            break;
        case Button::kSkip:
        case Button::kDone:
            end_trimming(turn);
            break;
        default:
            if (moves_hand(event.button)) turn.add(Effect::Kind::kMoveHand, static_cast<int>(event.button));
            break;
    }
}

void take_trim(Turn& turn, const Event& event) {
    State& state = turn.state;
    if (event.kind == Event::Kind::kThickFoot) {
        state.trimming.is_offered = state.screen == Screen::kFiring && state.firing != FiringStage::kFire;
    } else if (state.screen == Screen::kTrim) {
        state.trimming.taken_g = std::max(0, event.value);
        state.trimming.touched = state.trimming.touched || event.value > 0;
    }
}

}  // namespace onggi::kiosk
