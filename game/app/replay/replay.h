// Simulates a session again, tick by tick, and compares it with the recording. One thread at a time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "game/decoration/stroke.h"
#include "game/haptic/start_state.h"
#include "game/record/session.h"

namespace onggi::app {

struct Difference {
    std::uint64_t first_tick = 0;  // the first possible tick of the difference
    std::uint64_t last_tick = 0;   // the last possible one; equal if known exactly
    std::string what;
    bool after_all = false;  // every tick agrees, but the later work on the pot differs
};
[[nodiscard]] std::string sentence_for(const Difference& difference);

class Replay {
  public:
    // The session must outlive the replay at a fixed address.
    Replay(const record::Session& session, haptic::Start start);

    [[nodiscard]] bool is_over() const { return ticks_ == session_.tick_count(); }
    // Simulates the next tick. Returns nothing if it and all before it are as recorded. Precondition:
    // !is_over().
    [[nodiscard]] std::optional<Difference> step();
    // Returns a difference if the start differs from the recorded one.
    [[nodiscard]] std::optional<Difference> compare_start() const;

    [[nodiscard]] std::uint64_t ticks() const { return ticks_; }  // number simulated
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

// Replays the whole session: compares the force of every tick, the state wherever its hash is stored, and the
// decoration of the strokes on the final pot. Calls `reached`, if set, after every tick.
[[nodiscard]] std::optional<Difference> find_difference(
    const record::Session& session, haptic::Start start, const decoration::Recorded& decoration = {},
    const std::function<void(std::uint64_t)>& reached = {});

}  // namespace onggi::app
