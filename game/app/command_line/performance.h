// A performance: a start, a player of the hand's path, and its duration, loaded from a gesture or a session.
// Shared by `throw`, `live` and `replay`. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "game/app/command_line/options.h"
#include "game/app/replay/stored_session.h"
#include "game/clay/studio/studio_clay.h"
#include "game/haptic/start_state.h"
#include "game/haptic/tool_device.h"

namespace onggi::app {

struct Performance {
    haptic::Start start;
    std::uint64_t tick_count = 0;
    std::unique_ptr<haptic::ToolDevice> player;
    std::optional<std::string> remark;  // for the user, when a session was cut short
};

// Loads the file's performance. Its first bytes decide between gesture and session, not its name. Bad input:
// the parsers' errors; a rate or a clay given with a session, which contains both.
[[nodiscard]] Result<Performance> load_performance(const InputOptions& options);

// Returns the lump and the parameters that the options describe, without their file. Bad input: an option
// that the clay does not have.
[[nodiscard]] Result<haptic::Start> fresh_start(const InputOptions& options);

// The start pot of a gesture in studio clay, which replaces the fresh lump: the pot at the end of a session,
// or two such pots joined. Returns nothing if the options name none. Replays the sessions to their end. Bad
// input: --join without --on, a session of the paper's clay, a damaged session, pots that cannot be joined.
[[nodiscard]] Result<std::optional<clay::StudioClay>> start_pot(const StartPot& options);

}  // namespace onggi::app
