// What of the clay's forces goes on to a device: the same forces, made fit for a hand that feels every tick.
// What is recorded, thrown and replayed is F of Eq. (3) itself; nothing here reaches the clay. Pure; fit for
// the tick. mm, N, s.
#pragma once

#include "engine/core/result.h"
#include "engine/haptics/haptic_device.h"
#include "engine/math/math.h"
#include "game/clay/paper_clay.h"

namespace onggi::haptic {

struct HapticParameters;

// What a device may be shown; fit_to_device() works it out of its capabilities.
struct DeviceFeel {
    double most_stiffness_n_per_mm = 0.0;  // 0: as the clay is
    // Of an axis that a device with walls of its own is told the force of. 0: it has no such axis.
    double most_wire_stiffness_n_per_mm = 0.0;
    // The normal force at which the friction of Eq. (7) is there in full.
    double friction_reference_n = 0.1;
};

struct DeviceForce {
    dvec3 wanted_n{0.0};  // what the safety chain is given
    dvec3 driven_n{0.0};  // the wheel's fraction of it: its motor may do work on the hand
};

// Of the clay's forces in this tick and the tool's velocity from a windowed estimator.
//
// Differs: Eq. (6) takes the difference of two positions for v1; one step of an encoder of 0.055 mm from tick
//   to tick at 4 kHz is 220 mm/s, half a newton from nothing. A device gets F_v = -c2 v1, v1 from a window.
// Differs: Eq. (7) as printed does not ask how hard the tool presses: at the first touch, however light, the
//   whole friction is there at once, a kick along the wall. A device gets it times min(1, |F_s|/F_ref): in
//   full once the tool presses with F_ref.
// Differs: clay that is stiffer than the device can show stably is shown as stiff as it can; its friction
//   follows the pressure and is lessened by the same fraction.
// Differs: a joystick's own spring answers the hand at the stick's speed, but its height, and where it has no
//   such spring (shows_wall false) its radius, are forces over a slow bus: those axes get all their forces by
//   the fraction that makes the clay as stiff as is stable over that bus. The sum is bent towards the spring.
[[nodiscard]] DeviceForce device_force(const clay::ContactForces& forces, const dvec3& velocity_mm_s,
                                       double viscosity_c2_n_s_per_mm, bool friction_follows_pressure,
                                       const DeviceFeel& feel, bool shows_wall = false) noexcept;

// Sets limits and feel to what the device can do at the parameters' rate, before anybody holds it. Takes some
// 100 ms for a device that pushes. Error: kBadInput, one line, where the paper's constants could not be shown
// stably: they are the paper's, and are refused rather than changed; or where nothing could.
Result<void> fit_to_device(HapticParameters& parameters, const haptics::DeviceCapabilities& device,
                           bool is_paper);

}  // namespace onggi::haptic
