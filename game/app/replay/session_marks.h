// The decoration that a session holds, on the pot that its ticks left. Any thread.
#pragma once

#include <string>

#include "engine/core/result.h"
#include "game/decoration/canvas.h"
#include "game/pot/pot.h"
#include "game/record/session.h"

namespace onggi::app {

// No strokes where it holds none. Bad input: decoration::recorded_from(); `name` stands for the file.
[[nodiscard]] Result<decoration::Recorded> decoration_in(const record::Session& session,
                                                         const std::string& name);

// A pot's outer wall, to be drawn on. Precondition: it has rings.
[[nodiscard]] decoration::Wall wall_of(const pot::Pot& pot);

}  // namespace onggi::app
