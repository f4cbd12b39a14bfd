// Decorating: after the pot has dried and before it is fired. Decorating is optional.
#include <algorithm>

#include "game/kiosk/step_screens.h"

namespace onggi::kiosk {
namespace {

void lift_brush(Turn& turn) {
    if (!turn.state.decorating.brush_down) return;
    turn.state.decorating.brush_down = false;
    turn.add(effect::PutBrush{.down = false});
}

void take_tool(Turn& turn, int tool) {
    if (tool < 0 || tool >= kDrawingTools) return;
    turn.state.decorating.tool = tool;
    turn.state.decorating.touched = false;
}

// A motif is placed at once; a brush stays down until it is lifted.
void put_brush(Turn& turn) {
    Decorating& decorating = turn.state.decorating;
    if (decorating.brush_down) return lift_brush(turn);
    decorating.brush_down = decorating.tool != kMotifTool;
    turn.add(effect::PutBrush{.down = true});
}

}  // namespace

void begin_decorating(Turn& turn) {
    turn.state.decorating = {.turns = !turn.state.comfort.still};
    turn.add(effect::BeginDrawing{});
    turn.show(Screen::kDecorate);
}

void press_decorate(Turn& turn, const event::Pressed& event) {
    Decorating& decorating = turn.state.decorating;
    if (!moves_hand(event.button) && event.button != Button::kPutBrush) lift_brush(turn);
    switch (event.button) {
        case Button::kDrawingTool:
            take_tool(turn, event.value);
            break;
        case Button::kMotif:
            if (event.value >= 0 && event.value < kMotifs) decorating.motif = event.value;
            break;
        case Button::kBack:
            take_tool(turn, 0);
            break;
        case Button::kAllRound:
            decorating.all_round = !decorating.all_round;
            break;
        case Button::kSlip:
            decorating.black = event.value == 1;
            break;
        case Button::kToolLess:
        case Button::kToolMore:
            decorating.brush =
                std::clamp(decorating.brush + (event.button == Button::kToolMore ? 1 : -1), 1, kMostBrush);
            break;
        case Button::kTurning:
            decorating.turns = !decorating.turns;
            break;
        case Button::kUndo:
            turn.add(effect::UndoStroke{});
            break;
        case Button::kClear:
            if (decorating.strokes > 0) turn.add(effect::ClearDrawing{});
            break;
        case Button::kPutBrush:
            put_brush(turn);
            break;
        case Button::kDone:
            turn.add(effect::EndDrawing{});
            turn.state.firing = FiringStage::kFire;
            turn.show(Screen::kFiring);
            break;
        default:
            if (moves_hand(event.button)) turn.add(effect::MoveHand{event.button});
            break;
    }
}

void take_drawn(Turn& turn, const event::Drawn& drawn) {
    if (turn.state.screen != Screen::kDecorate) return;
    Decorating& decorating = turn.state.decorating;
    decorating.touched = decorating.touched || drawn.strokes > decorating.strokes;
    decorating.strokes = std::max(0, drawn.strokes);
}

}  // namespace onggi::kiosk
