// The wheel's own hands demonstrate a step of the lesson on the visitor's clay: on request, or unasked when
// the visitor makes no progress.
#include <algorithm>

#include "game/kiosk/step_screens.h"

namespace onggi::kiosk {
namespace {

// Or the last one, if all are done.
ShownStep next_step(const Throwing& throwing) {
    return static_cast<ShownStep>(std::min(throwing.steps_done, kTeachingSteps - 1));
}

}  // namespace

void begin_show(Turn& turn) {
    Throwing& throwing = turn.state.throwing;
    const bool is_tool = throwing.held == Held::kRib || throwing.held == Held::kSponge;
    const ShownStep step = is_tool ? ShownStep::kDrawTool : next_step(throwing);
    if (!is_tool) throwing.held = Held::kHand;
    throwing.tray = false;
    throwing.shown = step;
    turn.state.pace.shown_s = turn.now_s;
    turn.state.pace.seen_since_touch = step;
    turn.add(effect::ShowStep{step});
}

void end_show(Turn& turn) {
    Throwing& throwing = turn.state.throwing;
    if (!throwing.shown) return;
    throwing.shown.reset();
    turn.state.pace.show_over_s = turn.now_s;
}

void pass_show(Turn& turn) {
    const Throwing& throwing = turn.state.throwing;
    const Pace& pace = turn.state.pace;
    const Rules& rules = turn.rules;
    const double now_s = turn.now_s;
    if (throwing.shown) {
        if (now_s - pace.shown_s >= rules.show_most_s) end_show(turn);
        return;
    }
    // Once per step, and never while the visitor's hand is on the clay or holds a tool, or when the clay is
    // near collapse.
    const bool is_wanted = rules.shows_by_itself && throwing.steps_done < kTeachingSteps && !pace.held &&
                           throwing.held == Held::kHand && !throwing.tray &&
                           pace.seen_since_touch != next_step(throwing) && throwing.warning == Warning::kNone;
    const double quiet_s = now_s - std::max(pace.touched_s, pace.show_over_s);
    if (is_wanted && now_s - pace.progress_s >= rules.show_after_s && quiet_s >= rules.show_rests_s)
        begin_show(turn);
}

}  // namespace onggi::kiosk
