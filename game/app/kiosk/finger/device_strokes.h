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
    // when the tip is far enough from where it last rested. It is over when the tip pauses where it began, or
    // rests. A hand may rest at the end of a stroke to listen, and go on from there: its way back is no
    // stroke to the other side, nor is a slow one.
    [[nodiscard]] Stroke look(const std::optional<dvec3>& tip_mm, double dt_s);

  private:
    [[nodiscard]] bool comes_to_rest(const dvec3& tip_mm, double dt_s);

    std::optional<dvec3> stayed_at_mm_;
    double stayed_s_ = 0.0;           // near there
    std::optional<dvec3> middle_mm_;  // from where a stroke counts
    dvec3 way_{0.0};                  // unit length, of the stroke that is not over; 0: none
    double farthest_mm_ = 0.0;        // along it
    bool turned_back_ = false;
    dvec3 held_{0.0};  // the way of a stroke at whose end the tip rests
};

}  // namespace onggi::app
