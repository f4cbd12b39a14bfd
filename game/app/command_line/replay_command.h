// `onggi replay`: simulates a session again and compares it with what was recorded. Main thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "engine/record/session.h"
#include "game/app/command_line/cli_names.h"
#include "game/haptic/start_state.h"

namespace onggi::app {

// Where a replay first differs from its recording.
struct Difference {
    std::uint64_t first_tick = 0;  // it differs at this tick at the earliest
    std::uint64_t last_tick = 0;   // and at this one at the latest; the same if it is known exactly
    std::string what;
};

// Simulates the session from `start`, and compares the force of every tick and the state wherever its hash is
// stored. `reached`, if any, is told of every tick.
[[nodiscard]] std::optional<Difference> find_difference(
    const record::Session& session, haptic::Start start,
    const std::function<void(std::uint64_t)>& reached = {});

void add_replay_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
