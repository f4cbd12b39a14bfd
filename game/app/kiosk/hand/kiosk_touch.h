// A touch that nobody's finger makes: a path over the upright plane through the axis, walked in time. With it
// the lesson shows a step on the visitor's own clay, and keys and a single switch do what a finger does. Pure
// state, no clock: stepped by dt_s. Main thread. mm, s; x is signed, y up from the wheel head.
#pragma once

#include <vector>

#include "engine/math/math.h"
#include "game/pot/pot.h"

namespace onggi::app {

// Of the height: where the lesson presses first and pulls.
constexpr double kLowFraction = 0.3;

// Outer and inner radius of the shape at a height; inner 0 where it is solid, both 0 above it.
struct Wall {
    double outer_mm = 0.0;
    double inner_mm = 0.0;
};
[[nodiscard]] Wall wall_at(const pot::Pot& shape, double y_mm);
// Of its uppermost ring.
[[nodiscard]] Wall rim_of(const pot::Pot& shape);
// As good as without a hollow.
[[nodiscard]] bool is_solid(const pot::Pot& shape);

// A step of the lesson; behind them, a rib or a sponge drawn up along the wall.
enum class ShownStep { kPress, kOpen, kRaise, kDrawTool };

struct TouchPoint {
    double at_s = 0.0;  // since the path began
    dvec2 place_mm{0.0};
};
struct TouchPath {
    std::vector<TouchPoint> points;  // at least one, in time
    double presses_from_s = 0.0;     // until then the finger hovers
};

// What plays a step of the lesson on that clay, on the right (+1) or on the left (-1).
[[nodiscard]] TouchPath path_of_step(ShownStep step, const pot::Pot& shape, double side);
// Moves the wall there by so much: positive to the right, as seen.
[[nodiscard]] TouchPath sideways_path(const dvec2& place_mm, double step_mm);
// Takes the wall below the rim and goes past it, so far. Solid clay is opened on the way.
[[nodiscard]] TouchPath pull_path(const pot::Pot& shape, double side, double rise_mm);
// Over the middle: deepens the hollow by so much, or widens it where it is as deep as it gets.
[[nodiscard]] TouchPath open_path(const pot::Pot& shape, double side, double step_mm);
// Presses the rim down by so much.
[[nodiscard]] TouchPath lower_path(const pot::Pot& shape, double side, double step_mm);

class KioskTouch {
  public:
    void begin(TouchPath path);
    void stop() { path_.points.clear(); }
    void pass_time(double dt_s);

    [[nodiscard]] bool runs() const { return !path_.points.empty(); }
    [[nodiscard]] bool presses() const { return runs() && since_s_ >= path_.presses_from_s; }
    // Of the finger; where it was last, when it is done.
    [[nodiscard]] const dvec2& place_mm() const { return place_mm_; }

  private:
    TouchPath path_;
    double since_s_ = 0.0;
    dvec2 place_mm_{0.0};
};

}  // namespace onggi::app
