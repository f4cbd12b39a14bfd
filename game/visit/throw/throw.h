// Throwing: what its files and the jar share. Any thread, but the drawing.
#pragma once

#include "game/visit/flow/turn.h"

namespace onggi::visit {

// Returns whether the cue for the next move is visible now.
[[nodiscard]] bool shows_hint(const State& state, double now_s, const Rules& rules);

// Cuts the pot off the wheel as it is, and goes to the firing.
void finish_throwing(Turn& turn);

void draw_throw(Page& page);

}  // namespace onggi::visit
