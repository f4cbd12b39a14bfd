// Keeping a pot and sharing it with a phone.
#include "game/kiosk/step_screens.h"

namespace onggi::kiosk {
namespace {

void share(Turn& turn) {
    turn.state.keeping.phone = Phone::kPacking;
    turn.add(effect::Share{});
}

}  // namespace

void take_saved(Turn& turn, std::optional<int> number) {
    Keeping& keeping = turn.state.keeping;
    if (turn.state.screen != Screen::kKeep || keeping.outcome != Keeping::Outcome::kSaving) return;
    if (!number) {
        keeping = {.outcome = Keeping::Outcome::kFull};
        return;
    }
    keeping = {.outcome = Keeping::Outcome::kKept, .number = *number};
    if (turn.rules.shares) share(turn);
}

void take_shared(Turn& turn, const event::Shared& shared) {
    Keeping& keeping = turn.state.keeping;
    // Ignore answers about an earlier pot, whose visitor did not wait.
    if (turn.state.screen != Screen::kKeep || keeping.number != shared.number) return;
    const bool waits = keeping.phone == Phone::kPacking;
    const bool has_code = keeping.phone == Phone::kWifi || keeping.phone == Phone::kReady;
    if (shared.outcome == ShareOutcome::kReady && waits) {
        keeping.phone = turn.rules.has_wifi ? Phone::kWifi : Phone::kReady;
    } else if (shared.outcome == ShareOutcome::kFailed && waits) {
        keeping.phone = Phone::kResting;
    } else if (shared.outcome == ShareOutcome::kOver && has_code) {
        keeping.phone = Phone::kOver;
    }
}

void press_keep(Turn& turn, const event::Pressed& event) {
    Keeping& keeping = turn.state.keeping;
    if (keeping.outcome == Keeping::Outcome::kSaving) return;  // wait until the pot is saved
    if (event.button == Button::kAnother) {
        turn.show(Screen::kChoose);
    } else if (event.button == Button::kFinish) {
        turn.end_visit();
    } else if (event.button == Button::kOnWifi && keeping.phone == Phone::kWifi) {
        keeping.phone = Phone::kReady;
    } else if (event.button == Button::kOnWall && turn.rules.has_wall &&
               keeping.outcome == Keeping::Outcome::kKept) {
        keeping.on_wall = !keeping.on_wall;
        turn.add(effect::Wall{.up = keeping.on_wall});
    } else if (event.button == Button::kShareAgain &&
               (keeping.phone == Phone::kResting || keeping.phone == Phone::kOver)) {
        share(turn);
    }
}

}  // namespace onggi::kiosk
