// Moves of two skilled hands on the rings: move a wall, open solid clay, pull a rim up or press it down, and
// smooth the clay behind them. Each sets new radii at a ring's present height; whole grains that do not fit
// there pass to walls near by (share_out). So only pulling, opening and pressing down change heights. Haptic
// thread; no allocation. Units: mm.
#pragma once

#include <vector>

#include "game/clay/studio/moves.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

constexpr double kFloorMm = 11.0;  // thickness left when a pot is opened

// Work space of the moves, one entry a ring. Not state.
struct GripSpace {
    explicit GripSpace(int capacity);

    std::vector<double> wanted_mm;
    std::vector<double> second_mm;
    std::vector<double> weight;
};

// Outer radius of the ring at that height; of the rim if y is above it.
double outer_face_mm(const Rings& rings, double y_mm) noexcept;

// Moves a wall: the outer face moves by step_mm at height_mm, less above and below.
struct Carry {
    double height_mm = 0.0;
    double step_mm = 0.0;
    double up_mm = 16.0;  // reach of the hands, with weight (1 - s^2)^2
    double down_mm = 16.0;
    double foot_least_mm = 28.0;  // bounds of the foot; a foot already beyond them may stay
    double foot_most_mm = 68.0;
    double steepest = 0.0;          // bound of |dR/dy|
    double steepest_at_foot = 0.0;  // up to a little above the floor
    bool keeps_slopes = false;      // a slope that is steeper already may stay
};

// A bore from the rim down to bottom_mm, rounded at the bottom: every ring's inner face moves to it. outward
// is the fraction of the clay that goes to the outer face; the rest rises.
struct Bore {
    double bottom_mm = 0.0;
    double radius_mm = 0.0;
    double outward = 0.0;
    double largest_strain = 0.03;  // fraction of a ring's height
};

// The part of the wall that a pull takes: all of it unless two hands hold it, with weight (1 - s^2)^2.
struct Held {
    double height_mm = 0.0;
    double reach_mm = 1e300;
};

Changed carry_wall(Rings& rings, GripSpace& space, const Carry& carry) noexcept;
Changed open_bore(Rings& rings, const Bore& bore) noexcept;
// Pulls the hollow clay up by `rise`, thick parts most. Returns the rise of the rim.
double pull_up(Rings& rings, GripSpace& space, double rise, double largest_strain,
               const Held& held = {}) noexcept;
// Presses the rim down by `sink`; the wall below it thickens to both sides.
Changed press_down(Rings& rings, double sink) noexcept;
// Moves the wall near y towards its own averages: by middle_fraction for the middle of the wall (averaged
// over 4 mm), by thickness_fraction for its thickness (over 6 mm).
Changed fair_wall(Rings& rings, GripSpace& space, double y, double middle_fraction,
                  double thickness_fraction) noexcept;
// Hands that climb past clay that is thicker than the rest of the wall take it up with them (Manner::kWide).
Changed carry_up(Rings& rings, GripSpace& space, double y, double fraction) noexcept;
// Rounds the rim's edge, as a wet leather does.
Changed soften_lip(Rings& rings, GripSpace& space, double fraction) noexcept;

}  // namespace onggi::clay::studio
