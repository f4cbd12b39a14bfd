// The input of a device from the hand that holds it, at one instant. The program knows what tool the hand
// has, and on what it works. mm.
#pragma once

#include <utility>

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

// Distinguishes a working hand from an idle one by distance and not by speed, so that slow work counts and
// sensor noise does not.
class MotionSense {
  public:
    explicit MotionSense(double noise_mm) : noise_mm_(noise_mm) {}

    // Whether the hand has moved beyond the noise since the last position that counted as motion.
    [[nodiscard]] bool moved_to(const dvec3& place_mm) noexcept {
        const dvec3 way = place_mm - last_mm_;
        const bool moved = glm::dot(way, way) > noise_mm_ * noise_mm_;
        if (moved) last_mm_ = place_mm;
        return moved && std::exchange(knows_a_place_, true);
    }

  private:
    double noise_mm_;
    dvec3 last_mm_{0.0};
    bool knows_a_place_ = false;  // the first position does not count as motion
};

}  // namespace onggi::haptics
