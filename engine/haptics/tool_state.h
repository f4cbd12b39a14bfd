// What a hand does at one instant: the one form in which every device, gesture, session and tick speaks of
// it.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/math/math.h"

namespace onggi::haptics {

struct ToolState {
    dvec3 position_mm{0.0};     // centre of the tool's sphere, the haptic interface point; wheel frame, +Y up
    double radius_mm = 10.0;    // 2 to 40
    bool wheel_button = false;  // held: the wheel turns

    friend bool operator==(const ToolState&, const ToolState&) = default;
};

// Limits of what a tool may be, everywhere a tool comes in (gestures, sessions, devices, keys).
constexpr double kMinToolRadiusMm = 2.0;
constexpr double kMaxToolRadiusMm = 40.0;
constexpr double kWorkspaceMm = 1000.0;  // each coordinate within +-

// The tool brought within those limits, so that a recording never holds one that no reader would take. What
// is not a finite number is replaced by the last good tool's. Any thread; fit for the tick.
[[nodiscard]] inline ToolState within_limits(const ToolState& tool, const ToolState& last_good) noexcept {
    const dvec3& at = tool.position_mm;
    ToolState good = tool;
    if (std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z)) {
        good.position_mm = glm::clamp(at, -kWorkspaceMm, kWorkspaceMm);
    } else {
        good.position_mm = last_good.position_mm;
    }
    good.radius_mm = std::isfinite(tool.radius_mm)
                         ? std::clamp(tool.radius_mm, kMinToolRadiusMm, kMaxToolRadiusMm)
                         : last_good.radius_mm;
    return good;
}

}  // namespace onggi::haptics
