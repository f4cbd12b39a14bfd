// What two skilled hands do to the rings: they carry a wall, open solid clay, pull a rim up and press it
// down, fair what they have passed. Each gives a ring new radii at its present height; the clay that does not
// fit there, whole grains of it, passes to walls near by (share_out), so that no move but pulling, opening
// and pressing down changes how high anything stands. Haptic thread; no allocation. Units: mm, mm^3, s.
#pragma once

#include <vector>

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

// A wall that is carried: the outer face moves by step_mm at height_mm, less above and below.
struct Carry {
    double height_mm = 0.0;
    double step_mm = 0.0;
    double up_mm = 16.0;  // how far the hands reach, (1 - s^2)^2
    double down_mm = 16.0;
    double foot_least_mm = 28.0;  // bounds of the foot, which may lie beyond them already
    double foot_most_mm = 68.0;
};
Changed carry_wall(Rings& rings, GripSpace& space, const Carry& carry) noexcept;

// A bore from the rim down to bottom_mm, round below: every ring's inner face follows to it. outward is the
// fraction of the clay that goes to the outer face; the rest rises.
struct Bore {
    double bottom_mm = 0.0;
    double radius_mm = 0.0;
    double outward = 0.3;
    double largest_strain = 0.03;  // of a ring's height
};
Changed open_bore(Rings& rings, const Bore& bore) noexcept;

// Draws the hollow clay up by as much, the thick parts most. Returns how far the rim came.
double pull_up(Rings& rings, GripSpace& space, double rise_mm, double largest_strain) noexcept;

// Presses the rim down by as much; the wall below it thickens to both sides.
Changed press_down(Rings& rings, double sink_mm) noexcept;

// Faces follow their own averages near that height; shares of 4 mm of the middle of the wall and 6 mm of its
// thickness.
Changed fair_wall(Rings& rings, GripSpace& space, double height_mm, double middle_fraction,
                  double thickness_fraction) noexcept;

// The rim's edge becomes round, as a wet leather leaves it.
Changed soften_lip(Rings& rings, GripSpace& space, double fraction) noexcept;

}  // namespace onggi::clay::studio
