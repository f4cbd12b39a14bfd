// Pots that are off the wheel: as a section for small pictures, and upside down on the rim of another pot.
// Any thread; pure. mm.
#pragma once

#include "game/pot/pot.h"
#include "game/pot/section.h"

namespace onggi::pot {

// Some forty points up the outside and as many down the inside. Precondition: a pot with rings.
[[nodiscard]] Section section_of(const Pot& pot);

// The pot upside down, turned as clay::join_pots() turns it. Only its outside: solid, without dents.
// Precondition: rings with upper edges; also for stacked().
[[nodiscard]] Pot turned_over(const Pot& pot);

// `upper` turned over as by clay::join_pots(), shifted (x and z in the clay's frame) and set on the rim of
// `lower`, without blending; both solid as in turned_over().
[[nodiscard]] Pot stacked(const Pot& lower, const Pot& upper, const vec2& shift_mm);

}  // namespace onggi::pot
