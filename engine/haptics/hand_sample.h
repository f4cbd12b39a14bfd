// What a device reads of the hand that holds it at one instant. What the hand works with, and on what, only
// the program knows. mm.
#pragma once

#include "engine/math/math.h"

namespace onggi::haptics {

constexpr double kWorkspaceMm = 1000.0;  // each coordinate of a place lies within +-

struct HandSample {
    dvec3 position_mm{0.0};  // the haptic interface point; wheel frame, +Y up
    bool button = false;     // held: the work turns
    double rev_min = 120.0;  // the pedal's axis: how fast it turns then
    // The place is that of a finger on the upright plane through the axis (x, y), not that of a ball in the
    // work.
    bool on_screen = false;
    bool presses = true;  // a finger may hover

    friend bool operator==(const HandSample&, const HandSample&) = default;
};

}  // namespace onggi::haptics
