// The assist: a second hand for those who have one, held opposite the first across the wall.
// Haptic thread; no allocation. Units: mm.
#pragma once

#include "game/clay/studio/contact.h"

namespace onggi::clay::studio {

// Whether there is an assist. Solid clay has no other side to hold.
bool has_assist(const StudioInput& input, const Rings& rings, const Hand& hand) noexcept;

// The second hand across the wall from the first, which is in that state and touches the clay so.
//
// It rests on the wall without pressing it, and goes where the wall goes: a wall that both hold is carried
// (moves.h). Only while the first hand climbs does it squeeze, at a time by no more than a fraction of the
// wall that is there, until the hands' surfaces are least_gap_mm apart; thick walls take several pulls. It
// answers the first hand: it presses only while that one touches, and less where the floor keeps it from
// being opposite. work: the assist's own contact, which is yet to be found. Precondition: has_assist();
// least_gap_mm > 0.
Hand assist_of(const Hand& hand, const HandState& state, const Contact& contact, Contact& work,
               const Rings& rings, double least_gap_mm, const StudioParameters& parameters) noexcept;

}  // namespace onggi::clay::studio
