// What a hand does at one instant: the one form in which every device, gesture, session and tick speaks of
// it.
#pragma once

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

}  // namespace onggi::haptics
