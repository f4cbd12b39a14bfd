// The machine behind one finger: it reads a touch, chooses the grip, and lets two skilled hands carry it out
// on the true clay, step by step of simulated time, so that a replay of the recorded finger is the same to
// the bit. The wall's outer face goes where the finger goes and never past it; what a move would ruin, it
// leaves. Haptic thread; no allocation. Units: mm, s.
#pragma once

#include <vector>

#include "game/clay/studio/grip_touch.h"
#include "game/clay/studio/moves.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

// Work space of the moves, entry i of ring i. Not a state.
struct GripSpace {
    explicit GripSpace(int capacity);

    std::vector<double> wanted_mm;
    std::vector<double> second_mm;
    std::vector<double> weight;
};

// What the hands know besides the clay.
struct GripClimate {
    double load_index = 0.0;  // the largest, of the sweep
    double softness = 1.0;    // 1 for fresh clay: how readily it flows
    double size = 1.0;        // of the lump, 1 for a kilogram: its cube root
};

// The torque that half breaks the weakest ring from the wheel up to that height, N mm: a steady potter rubs
// no harder.
double bearable_twist(const Rings& rings, double y_mm);

// dt_s more of a finger that presses at (x, y). Returns the rings that changed; places are worked out.
Changed work_grip(GripState& state, Rings& rings, GripSpace& space, const dvec2& finger_mm,
                  const GripClimate& climate, double dt_s) noexcept;

}  // namespace onggi::clay::studio
