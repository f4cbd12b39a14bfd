#include "game/app/kiosk/visit/kiosk_clay.h"

#include <algorithm>

namespace onggi::app {
namespace {

constexpr double kSunkFraction = 0.8;     // of the height at which it still stood
constexpr double kSpreadFraction = 1.12;  // of the width: a bowl that spins apart hardly sinks
constexpr double kFirmly = 0.7;           // of what the clay bears: it stands again

double widest_mm(const pot::Pot& shape) {
    const auto& outer = shape.outer_mm;
    return outer.empty() ? 0.0 : 2.0 * double{*std::max_element(outer.begin(), outer.end())};
}

}  // namespace

void KioskClay::expect_lump(std::uint64_t run) {
    *this = {};
    run_ = run;
}

void KioskClay::expect_state(const haptic::Snapshot& now) {
    expect_lump(run_);
    puts_before_ = now.states_put;
}

bool KioskClay::is_there(const haptic::Snapshot& snapshot) {
    // The rings come at a pace of their own, after the numbers or before them.
    if (snapshot.run != run_ || snapshot.pot_stamp.run != run_) return false;
    if (puts_before_ &&
        (snapshot.states_put == *puts_before_ || snapshot.pot_stamp.states_put == *puts_before_))
        return false;
    puts_before_.reset();
    return true;
}

std::optional<ClayNews> KioskClay::look(const haptic::Snapshot& snapshot, kiosk::Warning before) {
    if (!is_there(snapshot)) return std::nullopt;
    ClayNews news{.steps_done = lesson_.steps_done(*snapshot.pot),
                  .warning = warning_of(snapshot.load, before)};
    const clay::studio::Failure& failure = snapshot.load.failure;
    const double height_mm = snapshot.pot->height_mm;
    const double width_mm = widest_mm(*snapshot.pot);
    const bool ever_failed = failure.cause != clay::studio::Cause::kNone;
    // Clay that gave way a little and was saved may be pressed down and drawn out as any other; an earlier
    // state that was put back is judged from how it stood then.
    const bool is_new = standing_height_mm_ == 0.0;
    if (!ever_failed || is_new || (snapshot.load.index < kFirmly && !failure.torn)) {
        standing_height_mm_ = height_mm;
        standing_width_mm_ = width_mm;
        failing_tick_ = 0;
        if (!ever_failed) has_said_ = false;
        return news;
    }
    if (failing_tick_ == 0) failing_tick_ = std::max<std::uint64_t>(1, snapshot.tick);
    // Clay that gives way a little is no failure yet: the pot has to have sunk, or to be spun apart, or a
    // piece come off.
    const bool is_sunk = height_mm < kSunkFraction * standing_height_mm_;
    const bool is_spread = snapshot.load.index >= 1.0 && width_mm > kSpreadFraction * standing_width_mm_;
    const bool gave_way = failure.torn || is_sunk || is_spread;
    if (gave_way && !has_said_) {
        has_said_ = true;
        news.gave_way = warning_for(failure.cause, failure.strength_kpa);
    }
    return news;
}

}  // namespace onggi::app
