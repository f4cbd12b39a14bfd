// A jar of two bowls: what the throwing step uses, because its bowls are thrown there. Any thread, but the
// drawing.
#pragma once

#include "game/visit/flow/turn.h"

namespace onggi::visit {

// Returns whether the jar handled the button. Throwing calls it first.
[[nodiscard]] bool press_jar(Turn& turn, const event::Pressed& event);
void take_jar(Turn& turn, const Event& event);
// pass_aside() begins the second bowl after Rules::aside_s, end_aside() at once.
void pass_aside(Turn& turn);
void end_aside(Turn& turn);
// Replaces the clay on the wheel; a bowl that was set aside stays.
void put_on_new_clay(Turn& turn);
// Continues the jar of an interrupted visit, if there is one.
void resume_jar(Turn& turn);

// Draws the jar's five steps in place of the lesson's, with the name of the current one.
void add_jar_steps(Page& page);
// Draws the ledge while the first bowl is set aside.
void add_aside_ledge(Page& page);
// Draws the card that explains the step; it disappears at the first touch of the clay.
void add_jar_card(Page& page);

}  // namespace onggi::visit
