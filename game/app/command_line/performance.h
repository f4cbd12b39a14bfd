// A performance: a start, a player of the hand's path and its duration, from a gesture or a session. Shared
// by `throw`, `live` and `replay`. Main thread.
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

// The file's performance. Its first bytes, not its name, decide between gesture and session. Bad input: the
// parsers' errors; a rate or a clay given with a session, which contains both.
[[nodiscard]] Result<Performance> load_performance(const InputOptions& options);

// The lump and the parameters of these options, without their file. Bad input: an option that the clay does
// not have.
[[nodiscard]] Result<haptic::Start> fresh_start(const InputOptions& options);

// The start pot of a gesture in studio clay in place of a fresh lump: the pot that a session left, or two of
// them joined. Returns no pot where the options name none. Replays the sessions to their end. Bad input:
// --join without --on, a session of the paper's clay, one that is damaged, pots that cannot be joined.
[[nodiscard]] Result<std::optional<clay::StudioClay>> start_pot(const StartPot& options);

}  // namespace onggi::app
