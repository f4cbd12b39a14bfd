// A session simulated again, tick by tick, and compared with what was recorded. Any one thread at a time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "game/decoration/stroke.h"
#include "game/haptic/start_state.h"
#include "game/record/session.h"

namespace onggi::app {

// Where a replay first differs from its recording.
struct Difference {
    std::uint64_t first_tick = 0;  // it differs at this tick at the earliest
    std::uint64_t last_tick = 0;   // and at this one at the latest; the same if it is known exactly
    std::string what;
    bool after_all = false;  // every tick is as recorded; what was done to the pot later is not
};
[[nodiscard]] std::string sentence_for(const Difference& difference);

class Replay {
  public:
    // The session must outlive the replay and stay where it is.
    Replay(const record::Session& session, haptic::Start start);

    [[nodiscard]] bool is_over() const { return ticks_ == session_.tick_count(); }
    // The next tick. Nothing: it is as recorded, and so are all before it. Precondition: !is_over().
    [[nodiscard]] std::optional<Difference> step();
    // That the start is another one than was recorded; nothing: it is the same.
    [[nodiscard]] std::optional<Difference> compare_start() const;

    [[nodiscard]] std::uint64_t ticks() const { return ticks_; }  // simulated so far
    [[nodiscard]] const haptic::HapticState& state() const { return start_.state; }
    [[nodiscard]] const haptic::HapticParameters& parameters() const { return start_.parameters; }
    [[nodiscard]] const haptic::TickResult& last() const { return last_; }

  private:
    const record::Session& session_;
    haptic::Start start_;
    record::SessionCursor cursor_;
    haptic::TickResult last_{};
    std::uint64_t ticks_ = 0;
    std::size_t block_ = 0;
};

// The whole of it: the force of every tick is compared, the state wherever its hash is stored, and what the
// strokes come to on the pot that is left. `reached`, if any, is told of every tick.
[[nodiscard]] std::optional<Difference> find_difference(
    const record::Session& session, haptic::Start start, const decoration::Recorded& decoration = {},
    const std::function<void(std::uint64_t)>& reached = {});

}  // namespace onggi::app
