// A performance: a start, a player and how long it plays, from a gesture or a session. What `throw`, `live`
// and `replay` have in common. Main thread.
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
    std::optional<std::string> remark;  // for the user: that a session was cut short
};

// The file's performance. Whether it is a gesture or a session is seen by its first bytes, not by its name.
// Bad input: what the parsers refuse; a rate or a clay given with a session, which brings its own.
[[nodiscard]] Result<Performance> load_performance(const InputOptions& options);

// The lump and the parameters that these options ask for, whatever their file. Bad input: an option that the
// clay does not have.
[[nodiscard]] Result<haptic::Start> fresh_start(const InputOptions& options);

// What a gesture of the studio clay is thrown on when it is not a fresh lump: the pot that a session left, or
// two of them joined. Nothing where none is asked for. The sessions are replayed to their end. Bad input:
// --join without --on, a session of the paper's clay, one that is damaged, pots that cannot be joined.
[[nodiscard]] Result<std::optional<clay::StudioClay>> start_pot(const StartPot& options);

}  // namespace onggi::app
