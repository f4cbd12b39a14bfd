// Trimming the foot of a leather-hard pot, offered if the foot has spare clay. Trimming is optional.
#include <algorithm>

#include "game/kiosk/step_screens.h"

namespace onggi::kiosk {
namespace {

void end_trimming(Turn& turn) {
    turn.add(effect::EndTrim{.took_clay = turn.state.trimming.touched});
    begin_decorating(turn);
}

}  // namespace

void end_drying(Turn& turn) {
    if (!turn.state.trimming.is_offered) return begin_decorating(turn);
    turn.state.trimming = {};
    turn.add(effect::BeginTrim{});
    turn.show(Screen::kTrim);
}

void press_trim(Turn& turn, const event::Pressed& event) {
    Trimming& trimming = turn.state.trimming;
    Throwing& throwing = turn.state.throwing;
    switch (event.button) {
        case Button::kUndo:
            turn.add(effect::Undo{});
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
            if (moves_hand(event.button)) turn.add(effect::MoveHand{event.button});
            break;
    }
}

void take_thick_foot(Turn& turn) {
    State& state = turn.state;
    state.trimming.is_offered = state.screen == Screen::kFiring && state.firing != FiringStage::kFire;
}

void take_trimmed(Turn& turn, const event::Trimmed& trimmed) {
    Trimming& trimming = turn.state.trimming;
    if (turn.state.screen != Screen::kTrim) return;
    trimming.taken_g = std::max(0, trimmed.taken_g);
    trimming.touched = trimming.touched || trimmed.taken_g > 0;
}

}  // namespace onggi::kiosk
