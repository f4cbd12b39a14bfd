// Strokes of a device that a visitor by ear moves: to a side and back, up, away, or towards the visitor. They
// stand for the keys of the buttons. Pure state, no clock; main thread. mm, s; the wheel's frame.
#pragma once

#include <optional>

#include "engine/math/math.h"

namespace onggi::app {

enum class Stroke {
    kNone,
    kLeft,
    kRight,
    kPress,  // up, or away from the visitor
    kAsk,    // towards the visitor: where am I?
};

class DeviceStrokes {
  public:
    // The tip of the device, once a frame, dt_s after the last one; empty: it has other work. A stroke counts
    // when the tip is far enough from where it last rested; the next one counts from where the tip rests
    // after it has turned back, so that a hand may hold still at the end of a stroke to listen.
    [[nodiscard]] Stroke look(const std::optional<dvec3>& tip_mm, double dt_s);

  private:
    [[nodiscard]] bool rests(const dvec3& tip_mm, double dt_s);

    std::optional<dvec3> last_mm_;
    double rests_s_ = 0.0;
    std::optional<dvec3> middle_mm_;  // from where a stroke counts
    dvec3 way_{0.0};                  // unit length, of the stroke that is not over; 0: none
    double farthest_mm_ = 0.0;        // along it
    bool turned_back_ = false;
};

}  // namespace onggi::app
