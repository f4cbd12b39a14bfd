// Throwing: what its parts share, and when it shows the cue for the next move. Any thread, but the drawing.
#pragma once

#include "game/visit/flow/turn.h"

namespace onggi::visit {

// Whether the cue for the next move is visible now.
[[nodiscard]] bool shows_hint(const State& state, double now_s, const Rules& rules);

// The clay on the wheel becomes a pot, as it is.
void finish_throwing(Turn& turn);

void draw_throw(Page& page);

}  // namespace onggi::visit
