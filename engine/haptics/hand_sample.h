// What a device reads of the hand that holds it at one instant, and whether that hand does something. What
// the hand works with, and on what, only the program knows. mm.
#pragma once

#include <utility>

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

// Tells a hand at work from one that rests: by how far it has come, not by how fast, so that slow work counts
// and a sensor's tremble does not.
class MotionSense {
  public:
    explicit MotionSense(double noise_mm) : noise_mm_(noise_mm) {}

    // Whether the place is another than when the hand was last seen to move.
    [[nodiscard]] bool moved_to(const dvec3& place_mm) noexcept {
        const dvec3 way = place_mm - last_mm_;
        const bool moved = glm::dot(way, way) > noise_mm_ * noise_mm_;
        if (moved) last_mm_ = place_mm;
        return moved && std::exchange(knows_a_place_, true);
    }

  private:
    double noise_mm_;
    dvec3 last_mm_{0.0};
    bool knows_a_place_ = false;  // the first place is no motion
};

}  // namespace onggi::haptics
