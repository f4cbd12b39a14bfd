// Every screen, drawn from the state: one function each, and compose() which picks. The composer's thread.
#pragma once

#include "game/screens/page/page.h"

namespace onggi::screens {

// The whole screen for this view: the state's screen, or the panel that lies over it.
[[nodiscard]] Composition compose(const View& view, ui::Painter& painter, PaintingStore& store);

void draw_attract(Page& page);
void draw_wall(Page& page);
void draw_choose(Page& page);
void draw_jar_start(Page& page);
void draw_throw(Page& page);
void draw_join(Page& page);
void draw_failure(Page& page);
void draw_firing(Page& page);
void draw_trim(Page& page);
void draw_decorate(Page& page);
void draw_glazes(Page& page);
void draw_your_pot(Page& page);
void draw_keep(Page& page);
void draw_resume(Page& page);
void draw_fault(Page& page);
void draw_idle(Page& page);
void draw_language(Page& page);
void draw_pin(Page& page);
void draw_staff(Page& page);
void draw_card_panel(Page& page);

// The card by which the pot goes home by phone, at whatever that has come to.
void add_phone_card(Page& page, const ui::Rect& card);

// What forces are shown with, and the panel where the visitor asked for it.
void add_forces(Page& page);

// The dark ledge under the clay: the lesson, and what can be pressed; or while the wheel's own hands show it,
// how to take over.
void add_throw_ledge(Page& page);

}  // namespace onggi::screens
