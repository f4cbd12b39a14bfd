// What a gesture of the studio clay is thrown on when it is not a fresh lump: the pot that a session left, or
// two of them joined. Main thread.
#pragma once

#include <optional>

#include "engine/core/result.h"
#include "game/app/command_line/options.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::app {

// The pot, or nothing where none is asked for. The sessions are replayed to their end. Bad input: --join
// without --on, a session of the paper's clay, one that is damaged, pots that cannot be joined.
[[nodiscard]] Result<std::optional<clay::StudioClay>> start_pot(const StartPot& options);

}  // namespace onggi::app
