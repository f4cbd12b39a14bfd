// The one-axis closed loop on which stiffness is judged: a device's mass with its damping and Coulomb
// friction, an encoder with steps, a wall of springs and dampers worked out once a tick and held, one tick of
// delay. Any thread but the haptic one: a judgement takes some ms. mm, N, s, kg.
//
// The rule of passivity, b > K T (1/2 + d), forbids what real devices do stably: friction and the passivity
// controller carry them further. So a stiffness is tried, from a touch and from a knock, and refused where
// the motion grows or does not come to rest. Source of the setting: J. J. Abbott and A. M. Okamura, "Effects
// of position quantization and sampling rate on virtual-wall passivity", IEEE Trans. on Robotics 21(5), 2005;
// N. Diolaiti, G. Niemeyer, F. Barbagli and J. K. Salisbury, "Stability of haptic rendering: discretization,
// quantization, time delay, and Coulomb effects", IEEE Trans. on Robotics 22(2), 2006.
#pragma once

#include <span>

#include "engine/core/result.h"
#include "engine/haptics/haptic_device.h"
#include "engine/haptics/safety_chain.h"

namespace onggi::haptics {

// What is between the wall's force and the device: nothing, or stages of the safety chain.
struct LoopSetting {
    double rate_hz = 1000.0;
    int delay_ticks = 1;                       // from the encoder's reading to the force it causes
    std::span<const SafetyStage> stages = {};  // empty: the bare wall, no limit but the device's own
    double viscosity_n_s_per_mm = 0.0;         // of the wall, from the windowed estimator
    double press_n = 0.5;                      // of a hand that only leans on the tool
    // A hand that holds the tool: a mass on spring and damper. 0: none.
    double hand_mass_kg = 0.0;
    double hand_stiffness_n_per_mm = 0.0;
    double hand_damping_n_s_per_mm = 0.0;
};

struct LoopMotion {
    double earlier_swing_mm = 0.0;  // from one end to the other, in the third quarter
    double swing_mm = 0.0;          // in the last quarter
    double deepest_mm = 0.0;        // below the wall's surface, ever
    double largest_force_n = 0.0;   // ever
    double energy_mj = 0.0;  // that the held force has given the tool in the last quarter; below 0: taken
};

// The loop for so many seconds of its own time, the tool beginning at the surface with that speed inwards.
[[nodiscard]] LoopMotion run_loop(const DeviceCapabilities& device, const LoopSetting& setting,
                                  double stiffness_n_per_mm, double speed_mm_s, double seconds = 3.0);

// After a touch and after a knock the motion dies away, or is no more than two steps of the encoder.
[[nodiscard]] bool is_stable(const DeviceCapabilities& device, const LoopSetting& setting,
                             double stiffness_n_per_mm);

// The largest stiffness below which every one tried is stable, in steps of 5 %; `most` where none was found
// unstable up to there. Precondition: the device's moving mass is known.
[[nodiscard]] double largest_stable_stiffness_n_per_mm(const DeviceCapabilities& device,
                                                       const LoopSetting& setting, double most = 5.8);
// The same for the wall's viscosity, at that stiffness.
[[nodiscard]] double largest_stable_viscosity_n_s_per_mm(const DeviceCapabilities& device,
                                                         const LoopSetting& setting,
                                                         double stiffness_n_per_mm, double most = 0.05);

// The loop as the device closes it when the haptic loop runs at that rate: no faster than the device is told,
// with the delay of its bus. The whole safety chain stands in it, but for a device with walls of its own:
// what its other axes are told goes over a bus whose moments the passivity controller does not know.
[[nodiscard]] LoopSetting loop_of(const DeviceCapabilities& device, double rate_hz);

// The same in that loop, in one call and coarser steps: what it may be shown, together with work of that
// viscosity and without it. 0: nothing.
[[nodiscard]] double stiffest_for(const DeviceCapabilities& device, double rate_hz, double most,
                                  double viscosity_n_s_per_mm = 0.0);

// Whether the device may show work of that stiffness and viscosity at that rate, judged before anybody
// holds it. Error: kBadInput, one line with the number found and the largest that is allowed. A device that
// cannot push back may show anything, and so may one with walls of its own: what goes over its bus is shown
// softer instead (device_force.h). One whose mass is unknown is taken for the hardest to steady that the
// bench has: 45 g, 0.1 N s/m, no friction.
[[nodiscard]] Result<void> check_work_on_device(const DeviceCapabilities& device, double rate_hz,
                                                double stiffness_n_per_mm, double viscosity_n_s_per_mm);

}  // namespace onggi::haptics
