// The one interface behind which every device sits: simulated, replayed, and real ones.
#pragma once

#include <cstdint>
#include <string>

#include "engine/core/result.h"
#include "engine/haptics/tool_state.h"

namespace onggi::haptics {

// What a device can do, in SI-near units. Zero means "none", not "unknown".
struct DeviceCapabilities {
    std::string name;
    int force_axes = 0;               // 0: cannot push back
    double peak_force_n = 0.0;        // what it can give for a moment
    double continuous_force_n = 0.0;  // what it can give for minutes
    double max_stiffness_n_per_mm = 0.0;
    double position_resolution_mm = 0.0;
};

class HapticDevice {
  public:
    virtual ~HapticDevice() = default;

    // Main thread, before the haptic thread runs and after it has stopped. May block and allocate.
    virtual Result<void> open() = 0;
    virtual void close() noexcept = 0;
    [[nodiscard]] virtual DeviceCapabilities capabilities() const = 0;

    // Haptic thread, once a tick each, in this order. Wait-free: no lock, allocation or system call.
    // read: where the tool is now. tick counts from 0, none left out; dt_s is the time since the last read:
    // one step, two at most however many periods the loop had to skip.
    [[nodiscard]] virtual ToolState read(std::uint64_t tick, double dt_s) noexcept = 0;
    // write: the limited force on the tool, N, wheel frame. Held until the next tick.
    virtual void write(const dvec3& force_n) noexcept = 0;
};

}  // namespace onggi::haptics
