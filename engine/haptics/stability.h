// Simulates the one-axis closed loop to find stable stiffnesses: the device's mass with damping and Coulomb
// friction, a quantised encoder, a spring-damper wall sampled once a tick and held, and one tick of delay.
// Any thread but the haptic one: a check takes some ms. mm, N, s, kg.
//
// The passivity condition b > K T (1/2 + d) is too strict: friction and the passivity controller keep real
// devices stable beyond it. So the simulation tries a stiffness with a light touch and with a knock, and
// rejects it if the motion grows or does not come to rest. Source of the model: J. J. Abbott and A. M.
// Okamura, "Effects of position quantization and sampling rate on virtual-wall passivity", IEEE Trans. on
// Robotics 21(5), 2005; N. Diolaiti, G. Niemeyer, F. Barbagli and J. K. Salisbury, "Stability of haptic
// rendering: discretization, quantization, time delay, and Coulomb effects", IEEE Trans. on Robotics 22(2),
// 2006.
#pragma once

#include <span>

#include "engine/core/result.h"
#include "engine/haptics/haptic_device.h"
#include "engine/haptics/safety_chain.h"

namespace onggi::haptics {

// The settings of a simulated loop.
struct LoopSetting {
    double rate_hz = 1000.0;
    int delay_ticks = 1;                       // from the encoder's reading to the force it causes
    std::span<const SafetyStage> stages = {};  // empty: the bare wall, with the device's own limit
    double viscosity_n_s_per_mm = 0.0;         // of the wall, from the windowed estimator
    double press_n = 0.5;                      // of a hand that leans on the tool
    // A hand that holds the tool: a mass on spring and damper. 0: no hand.
    double hand_mass_kg = 0.0;
    double hand_stiffness_n_per_mm = 0.0;
    double hand_damping_n_s_per_mm = 0.0;
};

struct LoopMotion {
    double earlier_swing_mm = 0.0;  // peak to peak, in the third quarter
    double swing_mm = 0.0;          // in the last quarter
    double deepest_mm = 0.0;        // greatest depth below the wall's surface
    double largest_force_n = 0.0;   // over the whole run
    // energy that the held force added to the tool in the last quarter; below 0: removed
    double energy_mj = 0.0;
};

// Simulates the loop for `seconds`; the tool starts at the surface, moving inwards at speed_mm_s.
[[nodiscard]] LoopMotion run_loop(const DeviceCapabilities& device, const LoopSetting& setting,
                                  double stiffness_n_per_mm, double speed_mm_s, double seconds = 3.0);

// Whether the motion decays after a touch and after a knock, or stays within two encoder steps.
[[nodiscard]] bool is_stable(const DeviceCapabilities& device, const LoopSetting& setting,
                             double stiffness_n_per_mm);

// The largest stiffness, in steps of 5 %, below which every tried one is stable; `most` if none was unstable.
// Precondition: the device's moving mass is known.
[[nodiscard]] double largest_stable_stiffness_n_per_mm(const DeviceCapabilities& device,
                                                       const LoopSetting& setting, double most = 5.8);
// The same for the wall's viscosity, at the given stiffness.
[[nodiscard]] double largest_stable_viscosity_n_s_per_mm(const DeviceCapabilities& device,
                                                         const LoopSetting& setting,
                                                         double stiffness_n_per_mm, double most = 0.05);

// The loop settings for a device when the haptic loop runs at rate_hz: no faster than the device is sent
// forces, with the delay of its bus. It includes the safety chain, except for a device that renders springs
// itself: its other axes get forces over a bus whose timing the passivity controller does not know.
[[nodiscard]] LoopSetting loop_of(const DeviceCapabilities& device, double rate_hz);

// The largest stiffness that is stable in loop_of(), with and without the given viscosity, searched in
// coarser steps. 0 if no stiffness is stable.
[[nodiscard]] double stiffest_for(const DeviceCapabilities& device, double rate_hz, double most,
                                  double viscosity_n_s_per_mm = 0.0);

// Checks that the device can render this stiffness and viscosity stably at this rate. Error: kBadInput, one
// line with the number found and the largest allowed. Always passes for a device without force and for one
// that renders springs itself, whose other forces are softened instead (device_force.h). A device of unknown
// mass is assumed to be the least stable of the bench: 45 g, 0.1 N s/m, no friction.
[[nodiscard]] Result<void> check_work_on_device(const DeviceCapabilities& device, double rate_hz,
                                                double stiffness_n_per_mm, double viscosity_n_s_per_mm);

}  // namespace onggi::haptics
