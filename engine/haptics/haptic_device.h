// The interface of every device: simulated, replayed and real.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/haptics/hand_sample.h"

namespace onggi::haptics {

// The abilities of a device. Zero means "none", not "unknown". mm, N, s, kg, Hz.
struct DeviceCapabilities {
    std::string name;
    int force_axes = 0;               // 0: a device without force
    double peak_force_n = 0.0;        // for a short time
    double continuous_force_n = 0.0;  // for minutes
    double max_stiffness_n_per_mm = 0.0;
    double position_resolution_mm = 0.0;
    bool has_motors = true;  // false: the force only moves a drawn tool
    // The device renders walls by itself along the radius from the forces that it gets, so the work's
    // stiffness closes no loop there (while DeviceSigns::shows_wall).
    bool has_own_walls = false;
    double report_rate_hz = 0.0;  // rate of position reports; 0: a new position at every read
    // The rate at which forces are sent to an axis that does not render walls by itself. 0: the report rate;
    // for a device with own walls, 0 means that it has no such axis.
    double wire_rate_hz = 0.0;
    double wire_delay_s = 0.0;  // from a position to the force computed for it, plus one period of the loop
    // The moving parts, if known (used by stability.h); mass 0: unknown, assumed light.
    double moving_mass_kg = 0.0;
    double damping_n_s_per_mm = 0.0;
    double coulomb_friction_n = 0.0;
};

// The status of the last read(), besides the sample.
struct DeviceSigns {
    bool position_is_new = true;  // the device has reported since the previous read
    bool hand_is_there = true;    // as far as the device can tell
    bool shows_wall = false;      // the device plugged in now renders a spring of its own along the radius
    std::size_t device = 0;       // index of the tool's holder in capabilities_of_devices()
    bool is_alone = true;         // no device other than the first is plugged in
    // The fraction of the last written force that reached the motors, 0 to 1. A device may have its own ramps
    // and limits, and the passivity observer needs the work of the applied force.
    double force_fraction = 1.0;
};

// The contact of tool and work, for devices that render more than a force. 0: unknown.
struct WorkFelt {
    bool touches = false;
    double stiffness_n_per_mm = 0.0;  // of the work at the contact
    double wall_mm = 0.0;             // thickness of the work there; 0: solid
    double most_force_n = 0.0;        // the force at which such a wall bends; 0: it does not bend
    double load = 0.0;                // 0 to 1, at which the work yields

    friend bool operator==(const WorkFelt&, const WorkFelt&) = default;
};

class HapticDevice {
  public:
    virtual ~HapticDevice() = default;

    // Main thread, before the haptic thread starts or after it has stopped. May block and allocate.
    virtual Result<void> open() = 0;
    virtual void close() noexcept = 0;
    [[nodiscard]] virtual DeviceCapabilities capabilities() const = 0;
    // One entry for each device that may get the tool; each is held to its own limits.
    [[nodiscard]] virtual std::vector<DeviceCapabilities> capabilities_of_devices() const {
        return {capabilities()};
    }

    // Haptic thread, once per tick, in this order. Wait-free: no lock, allocation or system call. read: the
    // hand's current position. tick counts from 0 without gaps; dt_s is the time since the last read: one
    // step, or at most two, even if the loop skipped more periods.
    [[nodiscard]] virtual HandSample read(std::uint64_t tick, double dt_s) noexcept = 0;
    // The status of the last read(); call it after read().
    [[nodiscard]] virtual DeviceSigns signs() const noexcept { return {}; }
    // Whether the device is plugged in and reports. Samples of an absent device are ignored.
    [[nodiscard]] virtual bool is_here() const noexcept { return true; }
    // Whether the person moves the device or presses a button, beyond the device's noise and the tremor of
    // holding it. A recording always moves.
    [[nodiscard]] virtual bool is_moving() const noexcept { return true; }
    // Whether the person changed a control, which is a sign of life. A stick that is held still moves the
    // tool but is no sign of life.
    [[nodiscard]] virtual bool lives() const noexcept { return is_moving(); }
    // Whether one of the controls does not come to rest (control_sense.h): it is worn, or an object lies on
    // it.
    [[nodiscard]] virtual bool never_rests() const noexcept { return false; }
    // Another device has moved the tool here; continue from there if the device can.
    virtual void take_over(const dvec3& /*position_mm*/) noexcept {}
    // write: the limited force on the tool, N, in the wheel's frame. The device applies it until the next
    // tick.
    virtual void write(const dvec3& force_n) noexcept = 0;

    // Watchdog thread, any time while the device is open, wait-free. The haptic thread hangs: apply no force
    // until it writes again. Every device with motors must implement it.
    virtual void silence() noexcept {}
    // feel: the contact behind the force, called before write. Most devices ignore it.
    virtual void feel(const WorkFelt& /*work*/) noexcept {}
};

}  // namespace onggi::haptics
