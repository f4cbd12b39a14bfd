// The wheel under the studio clay: inertia, a motor that follows the pedal within its torque, drag, and the
// hands' friction as a load. Any one thread at a time; fit for the tick. Units: rad, s, N mm, kg m^2.
#pragma once

#include "engine/math/math.h"
#include "game/clay/wheel_angle.h"

namespace onggi::clay::studio {

constexpr double kFastestWheelRadS = 10.0 * kPi;  // 300 rev/min

// As they are: an electric wheel.
struct WheelParameters {
    double inertia_kg_m2 = 0.12;          // a 30 cm head of cast metal with its rotor
    double largest_torque_n_mm = 6000.0;  // of the motor, or of the foot
    double drag_n_mm_s = 20.0;            // bearing and belt, per rad/s
    double pull_n_mm_s = 4000.0;          // motor torque towards the pedal's speed, per rad/s of difference
    bool can_brake = true;                // a motor can slow the wheel; a foot cannot
};

// A heavy flywheel, a foot that only drives, little drag.
constexpr WheelParameters kick_wheel() {
    return {.inertia_kg_m2 = 1.8,
            .largest_torque_n_mm = 9000.0,
            .drag_n_mm_s = 25.0,
            .pull_n_mm_s = 6000.0,
            .can_brake = false};
}

class PoweredWheel {
  public:
    PoweredWheel() = default;
    // Restores a recorded state. Precondition: a unit vector; a finite speed.
    PoweredWheel(const Rotation& heading, double speed_rad_s) : angle_(heading), speed_rad_s_(speed_rad_s) {}

    // One step of dt_s with the pedal at wanted_rad_s and the hands' friction load_n_mm against the turning.
    void step(double wanted_rad_s, double load_n_mm, double dt_s, const WheelParameters& wheel) noexcept;
    // Sets the speed at once, as in the paper. For tests and for a wheel that the tick does not drive.
    void set_speed(double speed_rad_s) { speed_rad_s_ = speed_rad_s; }

    [[nodiscard]] double speed_rad_s() const { return speed_rad_s_; }
    // Cosine and sine of the angle turned, counter-clockwise seen from above.
    [[nodiscard]] const Rotation& heading() const { return angle_.heading(); }

  private:
    WheelAngle angle_;
    double speed_rad_s_ = 0.0;
};

}  // namespace onggi::clay::studio
