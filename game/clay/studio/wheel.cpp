#include "game/clay/studio/wheel.h"

#include <algorithm>

namespace onggi::clay::studio {

void PoweredWheel::step(double wanted_rad_s, double load_n_mm, double dt_s,
                        const WheelParameters& wheel) noexcept {
    constexpr double kNMmPerNM = 1000.0;
    // Motor and drag are linear in the speed, so an implicit step is one division and stable at any
    // stiffness.
    const double inertia = wheel.inertia_kg_m2 * kNMmPerNM;  // N mm s^2
    const double pulled = (inertia * speed_rad_s_ + dt_s * wheel.pull_n_mm_s * wanted_rad_s) /
                          (inertia + dt_s * (wheel.pull_n_mm_s + wheel.drag_n_mm_s));
    const double motor =
        std::clamp(wheel.pull_n_mm_s * (wanted_rad_s - pulled),
                   wheel.can_brake ? -wheel.largest_torque_n_mm : 0.0, wheel.largest_torque_n_mm);
    const double driven = (inertia * speed_rad_s_ + dt_s * motor) / (inertia + dt_s * wheel.drag_n_mm_s);
    // Friction stops a wheel; it never turns it backwards.
    const double slowed = driven - dt_s * load_n_mm / inertia;
    speed_rad_s_ = std::clamp(driven > 0.0 ? std::max(slowed, 0.0) : driven, 0.0, kFastestWheelRadS);
    angle_.turn(speed_rad_s_ * dt_s);
}

}  // namespace onggi::clay::studio
