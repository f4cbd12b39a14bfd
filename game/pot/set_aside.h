// Pots that are not thrown on at the moment: as a section, for small pictures, and one upside down on the rim
// of another. Any thread; pure. mm.
#pragma once

#include "game/pot/pot.h"
#include "game/pot/section.h"

namespace onggi::pot {

// Some forty points up the outside, as many down the inside. Precondition: a pot with rings.
[[nodiscard]] Section section_of(const Pot& pot);

// Upside down on its rim, turned as clay::join_pots() turns it. What is seen of it from outside: solid,
// without dents. Precondition: rings with upper edges; also of the next.
[[nodiscard]] Pot turned_over(const Pot& pot);

// `upper` turned over as clay::join_pots() turns it, set aside by the shift (x and z in the clay's frame) and
// on the rim of `lower`, nothing eased; both as turned_over() shows it.
[[nodiscard]] Pot stacked(const Pot& lower, const Pot& upper, const vec2& shift_mm);

}  // namespace onggi::pot
