// Carries out a finger's touch on the clay: reads the touch, chooses the grip and moves the rings, step by
// step of simulated time, so that a replay of the recorded finger is bit-exact. The wall's outer face goes
// where the finger goes and never past it; a move that would ruin the pot is left out. Haptic thread; no
// allocation. Units: mm, s.
#pragma once

#include <vector>

#include "game/clay/studio/grip_touch.h"
#include "game/clay/studio/moves.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

// Work space of the moves, one entry a ring. Not state.
struct GripSpace {
    explicit GripSpace(int capacity);

    std::vector<double> wanted_mm;
    std::vector<double> second_mm;
    std::vector<double> weight;
};

// Conditions of the clay that scale the hands' moves.
struct GripClimate {
    double load_index = 0.0;  // the largest of the load sweep
    double softness = 1.0;    // how readily the clay flows; 1 for fresh clay
    double size = 1.0;        // cube root of the lump's mass in kilograms
};

// Half the torque that breaks the weakest ring from the wheel up to that height, N mm: a steady potter
// applies no more friction.
double bearable_twist(const Rings& rings, double y_mm);

// Advances by dt_s a finger that presses at (x, y). Returns the rings that changed; their places are up to
// date.
Changed work_grip(GripState& state, Rings& rings, GripSpace& space, const dvec2& finger_mm,
                  const GripClimate& climate, double dt_s) noexcept;

}  // namespace onggi::clay::studio
