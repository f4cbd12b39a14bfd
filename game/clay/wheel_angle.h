// The wheel's angle as a unit vector that each tick rotates a little: no angle grows without bound, and no
// libm sine is needed. One thread at a time; fit for the tick.
#pragma once

#include "game/clay/exact_math.h"

namespace onggi::clay {

class WheelAngle {
  public:
    WheelAngle() = default;
    // From a recorded state. Precondition: a unit vector.
    explicit WheelAngle(const Rotation& heading) : heading_(heading) {}

    // Turns by step_rad, counter-clockwise seen from above.
    void turn(double step_rad) noexcept {
        if (step_rad != step_rad_) {  // the step stays the same while the speed does
            step_rad_ = step_rad;
            step_ = rotation_by(step_rad);
        }
        const double cosine = heading_.cosine * step_.cosine - heading_.sine * step_.sine;
        const double sine = heading_.sine * step_.cosine + heading_.cosine * step_.sine;
        // One Newton step towards length 1. Rounding moves the length by 1e-16 a tick, which this undoes.
        const double scale = 1.5 - 0.5 * (cosine * cosine + sine * sine);
        heading_ = {cosine * scale, sine * scale};
    }

    // Cosine and sine of the angle turned since the start.
    [[nodiscard]] const Rotation& heading() const { return heading_; }

  private:
    Rotation heading_;
    Rotation step_;  // caches rotation_by(step_rad_); not state
    double step_rad_ = 0.0;
};

}  // namespace onggi::clay
