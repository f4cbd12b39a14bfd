#include "game/app/kiosk_clay.h"

#include <algorithm>

namespace onggi::app {
namespace {

constexpr double kSunkShare = 0.8;  // of the height at which it still stood

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
    const haptic::PotShape& shape = *snapshot.shape;
    if (snapshot.run != run_ || shape.run != run_) return false;
    if (puts_before_ && (snapshot.states_put == *puts_before_ || shape.states_put == *puts_before_))
        return false;
    puts_before_.reset();
    return true;
}

std::optional<ClayNews> KioskClay::look(const haptic::Snapshot& snapshot, kiosk::Warning before) {
    if (!is_there(snapshot)) return std::nullopt;
    ClayNews news{.steps_done = lesson_.steps_done(*snapshot.shape),
                  .warning = warning_of(snapshot.load, before)};
    const clay::studio::Failure& failure = snapshot.load.failure;
    const double height_mm = snapshot.shape->height_mm;
    if (failure.cause == clay::studio::Cause::kNone) {
        standing_mm_ = height_mm;
        failing_tick_ = 0;
        has_said_ = false;
        return news;
    }
    if (failing_tick_ == 0) failing_tick_ = std::max<std::uint64_t>(1, snapshot.tick);
    // Clay that gives way a little is no failure yet: the pot has to have sunk, or a piece come off.
    const bool gave_way = failure.torn || height_mm < kSunkShare * standing_mm_;
    if (gave_way && !has_said_) {
        has_said_ = true;
        news.gave_way = warning_for(failure.cause);
    }
    return news;
}

}  // namespace onggi::app
