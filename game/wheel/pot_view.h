// What the picture needs of a snapshot of the haptic loop: a view, not a copy. Any thread; mm, N.
#pragma once

#include <span>

#include "engine/math/math.h"

namespace onggi::wheel {

struct PotView {
    std::span<const float> radii_mm;  // bottom first; must live until apply() and the draw have returned
    double height_mm = 200.0;
    dvec3 tool_position_mm{0.0, 260.0, 0.0};
    double tool_radius_mm = 10.0;
    bool tool_shown = true;
    dvec2 wheel_direction{1.0,
                          0.0};  // unit vector (cos, sin) of the angle turned, counter-clockwise from above
    bool wheel_turning = false;
    int contacts = 0;  // elements that the tool touches
};

}  // namespace onggi::wheel
