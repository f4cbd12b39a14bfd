// The decoration recorded in a session, for the pot after its last tick. Any thread.
#pragma once

#include <string>

#include "engine/core/result.h"
#include "game/decoration/canvas.h"
#include "game/pot/pot.h"
#include "game/record/session.h"

namespace onggi::app {

// Returns no strokes if the session has none. Bad input: as decoration::recorded_from(); `name` is the file's
// name in messages.
[[nodiscard]] Result<decoration::Recorded> decoration_in(const record::Session& session,
                                                         const std::string& name);

// A pot's outer wall, for drawing on it. Precondition: it has rings.
[[nodiscard]] decoration::Wall wall_of(const pot::Pot& pot);

}  // namespace onggi::app
