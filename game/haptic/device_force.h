// Converts the clay's forces to the force for a device that a hand feels at every tick. Recordings, throws
// and replays hold F of Eq. (3) itself; nothing here affects the clay. Pure; fit for the tick. mm, N, s.
#pragma once

#include "engine/core/result.h"
#include "engine/haptics/haptic_device.h"
#include "engine/math/math.h"
#include "game/clay/paper_clay.h"

namespace onggi::haptic {

struct HapticParameters;

// Limits of the force for a device, computed by fit_to_device() from the device's capabilities.
struct DeviceFeel {
    double most_stiffness_n_per_mm = 0.0;  // 0: the clay's own
    // Limit for an axis whose force is sent over the bus to a device with walls of its own. 0: no such axis.
    double most_wire_stiffness_n_per_mm = 0.0;
    // The normal force from which the friction of Eq. (7) acts fully.
    double friction_reference_n = 0.1;
};

struct DeviceForce {
    dvec3 wanted_n{0.0};  // input of the safety chain
    dvec3 driven_n{0.0};  // the part that the wheel drives: its motor may do work on the hand
};

// Computes the device's force from the clay's forces in this tick and the tool's velocity from a windowed
// estimator.
//
// Differs: Eq. (6) takes the difference of two positions for v1. One step of an encoder of 0.055 mm between
//   two ticks at 4 kHz is 220 mm/s: a false half newton. A device gets F_v = -c2 v1 with v1 from a window.
// Differs: Eq. (7) as printed does not depend on the tool's pressure: at the lightest touch the whole
//   friction acts at once, as a kick along the wall. A device gets it times min(1, |F_s|/F_ref), so fully
//   only when the tool presses with F_ref.
// Differs: clay that is stiffer than the device can render stably gets the largest stable stiffness; its
//   friction follows the pressure and is reduced by the same fraction.
// Differs: a joystick's own spring answers the hand at the stick's speed. Its height, and without such a
//   spring (shows_wall false) its radius, are forces over a slow bus. On those axes all forces are multiplied
//   by the fraction that makes the clay's stiffness stable over that bus. The sum turns towards the spring.
[[nodiscard]] DeviceForce device_force(const clay::ContactForces& forces, const dvec3& velocity_mm_s,
                                       double viscosity_c2_n_s_per_mm, bool friction_follows_pressure,
                                       const DeviceFeel& feel, bool shows_wall = false) noexcept;

// Sets the limits and the feel to the device's abilities at the parameters' rate, before a person holds it.
// Takes some 100 ms for a device with motors. Error: kBadInput, one line, if the paper's constants cannot be
// rendered stably (they are refused, never changed), or if no clay can.
Result<void> fit_to_device(HapticParameters& parameters, const haptics::DeviceCapabilities& device,
                           bool is_paper);

}  // namespace onggi::haptic
