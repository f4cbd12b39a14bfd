// What the clay on the wheel tells a visit: how far the lesson has come, what it warns of, that it gave way.
// New clay, or an earlier state of it, is on its way for some frames: until it is there, what is on the wheel
// is the last visitor's, or what sank, and tells nothing. Pure state, no clock. Main thread, once a frame.
#pragma once

#include <cstdint>
#include <optional>

#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/haptic/messages.h"
#include "game/kiosk/state.h"

namespace onggi::app {

struct ClayNews {
    int steps_done = 0;  // of kiosk::kTeachingSteps
    kiosk::Warning warning = kiosk::Warning::kNone;
    std::optional<kiosk::Warning> gave_way{};  // by what; said once
};

class KioskClay {
  public:
    // Another lump was asked for: that run, as Snapshot::run counts.
    void expect_lump(std::uint64_t run);
    // A state of that lump was asked for, an interrupted pot's among them. `now` is what is on the wheel.
    void expect_state(const haptic::Snapshot& now);
    // It does not come: what is on the wheel stays.
    void expect_nothing() { puts_before_.reset(); }

    // Nothing while what was asked for is on its way. `before`: what is being warned of.
    [[nodiscard]] std::optional<ClayNews> look(const haptic::Snapshot& snapshot, kiosk::Warning before);
    // The tick at which the clay that gave way began to; 0 while it stands.
    [[nodiscard]] std::uint64_t began_to_fail_tick() const { return failing_tick_; }

  private:
    [[nodiscard]] bool is_there(const haptic::Snapshot& snapshot);

    Lesson lesson_;
    std::uint64_t run_ = 0;
    std::optional<std::uint64_t> puts_before_;  // as Snapshot::states_put counts
    std::uint64_t failing_tick_ = 0;
    bool has_said_ = false;
    // Before it began to fail.
    double standing_height_mm_ = 0.0;
    double standing_width_mm_ = 0.0;
};

}  // namespace onggi::app
