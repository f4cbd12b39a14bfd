// The one interface behind which every device sits: simulated, replayed, and real ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/haptics/hand_sample.h"

namespace onggi::haptics {

// What a device can do, in SI-near units. Zero means "none", not "unknown".
struct DeviceCapabilities {
    std::string name;
    int force_axes = 0;               // 0: cannot push back
    double peak_force_n = 0.0;        // what it can give for a moment
    double continuous_force_n = 0.0;  // what it can give for minutes
    double max_stiffness_n_per_mm = 0.0;
    double position_resolution_mm = 0.0;
    bool has_motors = true;  // false: its force moves a picture of a tool, and heats nothing
    // true: along the radius it is told forces and makes walls of its own of them, so that the work's
    // stiffness closes no loop there (while DeviceSigns::shows_wall)
    bool has_own_walls = false;
    double report_rate_hz = 0.0;  // how often it says where it is; 0: at every read
    // How often an axis without such a wall is told its force. 0: as often as it reports, or of a device with
    // walls of its own that it has no such axis.
    double wire_rate_hz = 0.0;
    double wire_delay_s = 0.0;  // from its place to the force of that place, besides one period of the loop
    // What moves, where it is known (stability.h judges by it); mass 0: unknown, and taken to be light.
    double moving_mass_kg = 0.0;
    double damping_n_s_per_mm = 0.0;
    double coulomb_friction_n = 0.0;
};

// What the last read() found besides the sample.
struct DeviceSigns {
    bool position_is_new = true;  // heard from the device since the read before
    bool hand_is_there = true;    // as far as the device can tell
    bool shows_wall = false;      // along the radius by a wall of its own, as it is plugged in now
    std::size_t device = 0;       // which of capabilities_of_devices() has the tool
    // Of the force written last, what went out to the motors, 0 to 1: a device may have ramps and limits of
    // its own, and the work that a force does is judged by what really went out.
    double force_fraction = 1.0;
};

// What the tool is at, besides the force: for devices that show more than a force. 0 where it is unknown.
struct WorkFelt {
    bool touches = false;
    double stiffness_n_per_mm = 0.0;  // of the work where it is touched
    double wall_mm = 0.0;             // its thickness there; 0: solid
    double most_force_n = 0.0;        // with which such a wall bends aside; 0: it does not
    double load = 0.0;                // 0: at rest; 1: it gives way

    friend bool operator==(const WorkFelt&, const WorkFelt&) = default;
};

class HapticDevice {
  public:
    virtual ~HapticDevice() = default;

    // Main thread, before the haptic thread runs and after it has stopped. May block and allocate.
    virtual Result<void> open() = 0;
    virtual void close() noexcept = 0;
    [[nodiscard]] virtual DeviceCapabilities capabilities() const = 0;
    // Of each device that may get the tool, where there are several: each is held to its own limits.
    [[nodiscard]] virtual std::vector<DeviceCapabilities> capabilities_of_devices() const {
        return {capabilities()};
    }

    // Haptic thread, once a tick each, in this order. Wait-free: no lock, allocation or system call.
    // read: where the hand is now. tick counts from 0, none left out; dt_s is the time since the last read:
    // one step, two at most however many periods the loop had to skip.
    [[nodiscard]] virtual HandSample read(std::uint64_t tick, double dt_s) noexcept = 0;
    // after read, and about what it read:
    [[nodiscard]] virtual DeviceSigns signs() const noexcept { return {}; }
    // Plugged in and heard. What a device that is not here read does not count.
    [[nodiscard]] virtual bool is_here() const noexcept { return true; }
    // The person does something with it: beyond the device's noise, not merely holding it. A recording always
    // does.
    [[nodiscard]] virtual bool is_moving() const noexcept { return true; }
    // The person has changed something, so somebody is there. A hand that holds a stick still moves the tool
    // and gives no such sign.
    [[nodiscard]] virtual bool lives() const noexcept { return is_moving(); }
    // One of its controls does not come to rest (control_sense.h): it is worn, or something leans on it.
    [[nodiscard]] virtual bool never_rests() const noexcept { return false; }
    // Another device has brought the tool here; go on from there where the device can.
    virtual void take_over(const dvec3& /*position_mm*/) noexcept {}
    // write: the limited force on the tool, N, wheel frame. Held until the next tick.
    virtual void write(const dvec3& force_n) noexcept = 0;

    // The watchdog's thread, any time while open, wait-free: the haptic thread stands still; no force until
    // it writes again. A device whose force goes anywhere else than to its own read() must obey.
    virtual void silence() noexcept {}
    // feel: what the force came from, before write. Most devices have no use for it.
    virtual void feel(const WorkFelt& /*work*/) noexcept {}
};

}  // namespace onggi::haptics
