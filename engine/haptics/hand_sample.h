// The input of a device from the hand that holds it, at one instant. The program knows what tool the hand
// has, and on what it works. mm.
#pragma once

#include "engine/math/math.h"

namespace onggi::haptics {

constexpr double kWorkspaceMm = 1000.0;  // the range of each coordinate is +-kWorkspaceMm

struct HandSample {
    dvec3 position_mm{0.0};  // the haptic interface point; wheel frame, +Y up
    bool button = false;     // held: the work turns
    double rev_min = 120.0;  // the speed set by the pedal's axis
    // The position is that of a finger on the upright plane through the axis (x, y), and not that of a ball
    // in the work.
    bool on_screen = false;
    bool presses = true;  // false: the finger hovers

    friend bool operator==(const HandSample&, const HandSample&) = default;
};

}  // namespace onggi::haptics
