// Pots that are not thrown on at the moment: as a section, for small pictures, and one upside down on the rim
// of another. Any thread; pure. mm.
#pragma once

#include "game/pot/pot.h"
#include "game/pot/section.h"

namespace onggi::pot {

// Some forty points up the outside, as many down the inside. Precondition: a pot with rings.
[[nodiscard]] Section section_of(const Pot& pot);

// `upper` turned over as clay::join_pots() turns it, set aside by the shift (x and z in the clay's frame) and
// on the rim of `lower`, nothing eased. What is seen of both from outside: solid, without dents.
// Precondition: both have rings with upper edges.
[[nodiscard]] Pot stacked(const Pot& lower, const Pot& upper, const vec2& shift_mm);

}  // namespace onggi::pot
