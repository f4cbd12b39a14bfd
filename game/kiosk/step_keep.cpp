// Keeping a pot and sharing it with a phone.
#include "game/kiosk/step_screens.h"

namespace onggi::kiosk {
namespace {

void share(Turn& turn) {
    turn.state.keeping.phone = Phone::kPacking;
    turn.add(Effect::Kind::kShare);
}

}  // namespace

void take_saved(Turn& turn, const Event& event) {
    Keeping& keeping = turn.state.keeping;
    if (turn.state.screen != Screen::kKeep || keeping.outcome != Keeping::Outcome::kSaving) return;
    if (event.kind == Event::Kind::kSaveFailed) {
        keeping = {.outcome = Keeping::Outcome::kFull};
        return;
    }
    keeping = {.outcome = Keeping::Outcome::kKept, .number = event.value};
    if (turn.rules.shares) share(turn);
}

void take_shared(Turn& turn, const Event& event) {
    Keeping& keeping = turn.state.keeping;
    // Ignore answers about an earlier pot, whose visitor did not wait.
    if (turn.state.screen != Screen::kKeep || keeping.number != event.value) return;
    const bool waits = keeping.phone == Phone::kPacking;
    const bool has_code = keeping.phone == Phone::kWifi || keeping.phone == Phone::kReady;
    if (event.kind == Event::Kind::kShared && waits) {
        keeping.phone = turn.rules.has_wifi ? Phone::kWifi : Phone::kReady;
    } else if (event.kind == Event::Kind::kShareFailed && waits) {
        keeping.phone = Phone::kResting;
    } else if (event.kind == Event::Kind::kShareOver && has_code) {
        keeping.phone = Phone::kOver;
    }
}

void press_keep(Turn& turn, const Event& event) {
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
        turn.add(Effect::Kind::kWall, keeping.on_wall ? 1 : 0);
    } else if (event.button == Button::kShareAgain &&
               (keeping.phone == Phone::kResting || keeping.phone == Phone::kOver)) {
        share(turn);
    }
}

}  // namespace onggi::kiosk
