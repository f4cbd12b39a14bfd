// A hand that may hold the tool: one of several, any of which may come, go, or lie still while another works.
// Hands (hands.h) lets one of them have the tool.
#pragma once

#include <cmath>
#include <utility>

#include "engine/haptics/haptic_device.h"

namespace onggi::haptics {

class Hand : public HapticDevice {
  public:
    // All of these: haptic thread, after read() and about what it read. Wait-free.
    // Plugged in and heard. A hand that is not here has no wishes: what it read does not count.
    [[nodiscard]] virtual bool is_here() const noexcept = 0;
    // The person does something with it: beyond the device's noise, not merely holding it.
    [[nodiscard]] virtual bool is_moving() const noexcept = 0;
    // Another hand has brought the tool here; go on from there where the device can.
    virtual void take_over(const ToolState& tool) noexcept = 0;
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
