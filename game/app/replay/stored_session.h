// Loads a session file, with its start and its pot's decoration. Main thread, blocks.
#pragma once

#include <optional>
#include <string>

#include "engine/core/result.h"
#include "game/decoration/stroke.h"
#include "game/haptic/start_state.h"
#include "game/record/session.h"

namespace onggi::app {

// A session and its start, for a replay that compares.
struct LoadedSession {
    record::Session session;
    haptic::Start start;
    decoration::Recorded decoration{};  // of the final pot
};
[[nodiscard]] Result<LoadedSession> load_session(const std::string& file);

// Returns "FILE: cut short ..." for a session without its end marker.
[[nodiscard]] std::optional<std::string> remark_on_cut(const record::Session& session,
                                                       const std::string& file);

}  // namespace onggi::app
