// Every number of the safety chain in one place, and how a device's own limits lower them. Plain values; any
// thread. mm, N, s, mJ (N mm).
#pragma once

#include "engine/haptics/haptic_device.h"
#include "engine/haptics/tool_state.h"

namespace onggi::haptics {

// The kiosk's profile; a weaker device lowers it, a stronger one never raises it.
constexpr double kKioskPeakForceN = 3.3;
constexpr double kKioskContinuousForceN = 0.88;

struct SafetyLimits {
    // gate
    double workspace_mm = kWorkspaceMm;  // each coordinate within +-
    // speed: in contact, from the first on the force gives way to a brake; above the second there is none.
    double brake_speed_mm_s = 600.0;
    double stop_speed_mm_s = 1200.0;
    double brake_n_s_per_mm = 0.002;
    // late: a larger fraction of late periods than this makes the touch softer, down to the least gain.
    double late_fraction = 0.01;
    double least_gain = 0.25;
    double late_memory_s = 1.0;
    double soften_s = 0.05;  // from full gain to none
    double harden_s = 1.0;   // and back
    // passivity: the damping it may add, and how much energy it keeps in hand or is owed.
    double damping_n_s_per_mm = 0.002;
    double energy_credit_mj = 0.02;  // a long dissipative past must not pay for a shake
    double energy_debt_mj = 10.0;    // bounds how long the damping stays on
    double forget_s = 0.05;          // out of contact
    // hand: nobody there, or a position that is no longer refreshed.
    int stale_ticks = 2;
    double device_period_s = 0.0;  // a device slower than the loop is stale after two of its own periods
    double decay_s = 0.005;        // from full force to none
    double return_s = 0.25;        // and back, if it never came to none; else through the ramp
    // ramp
    double ramp_s = 1.0;         // from nothing to full force, at the start and after a fault
    double small_force_n = 0.2;  // the ramp begins only after a force below this ...
    int small_force_ticks = 3;   // ... for more than so many ticks in a row: no start inside a wall
    // budget: the mean of the squared force over budget_s, what heats a motor, stays below the square of
    // this.
    double continuous_force_n = kKioskPeakForceN;
    double budget_s = 10.0;
    // clamp
    double peak_force_n = kKioskPeakForceN;
    // slew
    double slew_n_per_s = 200.0;      // how fast the force may grow or turn
    double release_n_per_s = 2000.0;  // how fast it may fall: 3.3 N are gone in 2 ms
};

// The kiosk's profile, lowered to what the device can give. A device without motors (a picture of a tool) has
// no continuous limit but its peak, and no limit of speed.
[[nodiscard]] SafetyLimits limits_for(const DeviceCapabilities& device);

}  // namespace onggi::haptics
