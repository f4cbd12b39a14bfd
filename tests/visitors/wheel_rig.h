// The interface of a simulated visitor: the visible wheel, and a pointer. mm on the vertical plane through
// the axis, x to the right, y up from the wheel head; s of simulated time.
#pragma once

#include "engine/math/math.h"

namespace onggi::visitors {

constexpr double kFrameS = 1.0 / 60.0;  // of the display

class WheelRig {
  public:
    virtual ~WheelRig() = default;

    // Advances one frame of the display with the pointer at that position.
    virtual void frame(const dvec2& pointer_mm, bool pressed) = 0;

    // The visible dimensions of the clay.
    [[nodiscard]] virtual double height_mm() const = 0;
    [[nodiscard]] virtual double floor_mm() const = 0;  // the total height if the clay is solid
    [[nodiscard]] virtual double outer_mm(double y_mm) const = 0;
    [[nodiscard]] virtual double inner_mm(double y_mm) const = 0;  // 0: solid

    // The lesson's progress on the screen, 0 to 3: pressed, opened, raised.
    [[nodiscard]] virtual int steps_done() const = 0;
    // Whether the wheel's own hands demonstrate a step. Most people watch them.
    [[nodiscard]] virtual bool shows() const { return false; }

    // Presses "done", and returns what the screen advises instead of cutting the pot off.
    enum class Advice { kNone, kOpen, kDrawUp };
    virtual Advice press_done() { return Advice::kNone; }

    [[nodiscard]] double depth_mm() const { return height_mm() - floor_mm(); }
};

}  // namespace onggi::visitors
