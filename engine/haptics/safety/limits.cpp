#include "engine/haptics/safety/limits.h"

#include <algorithm>

namespace onggi::haptics {

SafetyLimits limits_for(const DeviceCapabilities& device) {
    SafetyLimits limits;
    if (device.force_axes > 0) limits.peak_force_n = std::min(limits.peak_force_n, device.peak_force_n);
    limits.continuous_force_n = limits.peak_force_n;
    if (device.force_axes > 0 && device.has_motors) {
        limits.continuous_force_n =
            std::min({limits.peak_force_n, kKioskContinuousForceN, device.continuous_force_n});
    }
    if (!device.has_motors) {
        // A mouse may fly as fast as it likes: nobody's hand is thrown by a picture.
        constexpr double kAnySpeedMmS = 1e9;
        limits.brake_speed_mm_s = limits.stop_speed_mm_s = kAnySpeedMmS;
    }
    if (device.report_rate_hz > 0.0) limits.device_period_s = 1.0 / device.report_rate_hz;
    return limits;
}

}  // namespace onggi::haptics
