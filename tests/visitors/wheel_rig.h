// What a simulated visitor has before them: the wheel as they see it, and a pointer. mm on the upright plane
// through the axis, x to the right, y up from the wheel head; s of simulated time.
#pragma once

#include "engine/math/math.h"

namespace onggi::visitors {

constexpr double kFrameS = 1.0 / 60.0;  // of the display

class WheelRig {
  public:
    virtual ~WheelRig() = default;

    // One frame of the display, in which the pointer is there.
    virtual void frame(const dvec2& pointer_mm, bool pressed) = 0;

    // What is seen of the clay.
    [[nodiscard]] virtual double height_mm() const = 0;
    [[nodiscard]] virtual double floor_mm() const = 0;  // the height where nothing is hollow
    [[nodiscard]] virtual double outer_mm(double y_mm) const = 0;
    [[nodiscard]] virtual double inner_mm(double y_mm) const = 0;  // 0: solid

    [[nodiscard]] double depth_mm() const { return height_mm() - floor_mm(); }
};

}  // namespace onggi::visitors
