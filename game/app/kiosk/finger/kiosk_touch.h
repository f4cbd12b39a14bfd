// A synthetic touch: a timed path over the upright plane through the axis. The lesson uses it to demonstrate
// a step on the visitor's clay, and keys and a single switch to work like a finger. Pure state, no clock:
// stepped by dt_s. Main thread. mm, s; x is signed, y up from the wheel head.
#pragma once

#include <vector>

#include "engine/math/math.h"
#include "game/kiosk/state.h"
#include "game/pot/pot.h"

namespace onggi::app {

// Fraction of the height at which the lesson presses first and pulls.
constexpr double kLowFraction = 0.3;

struct TouchPoint {
    double at_s = 0.0;  // since the path began
    dvec2 place_mm{0.0};
};
struct TouchPath {
    std::vector<TouchPoint> points;  // at least one, in time
    double presses_from_s = 0.0;     // before this time the finger hovers
};

// Returns the path of a step of the lesson, or of drawing a rib or a sponge up along that clay's wall, on the
// right (+1) or left (-1) side.
[[nodiscard]] TouchPath path_of_step(kiosk::ShownStep step, const pot::Pot& shape, double side);
// Moves the wall at that place by `step_mm`; positive is to the right in the picture.
[[nodiscard]] TouchPath sideways_path(const dvec2& place_mm, double step_mm);
// Grips the wall below the rim and pulls `rise_mm` past it. Solid clay is opened first.
[[nodiscard]] TouchPath pull_path(const pot::Pot& shape, double side, double rise_mm);
// Deepens the hollow by `step_mm`, or widens it if it has its greatest depth.
[[nodiscard]] TouchPath open_path(const pot::Pot& shape, double side, double step_mm);
// Presses the rim down by `step_mm`.
[[nodiscard]] TouchPath lower_path(const pot::Pot& shape, double side, double step_mm);

class KioskTouch {
  public:
    void begin(TouchPath path);
    void stop() { path_.points.clear(); }
    void pass_time(double dt_s);

    [[nodiscard]] bool runs() const { return !path_.points.empty(); }
    [[nodiscard]] bool presses() const { return runs() && since_s_ >= path_.presses_from_s; }
    // The finger's place; after the end its last place.
    [[nodiscard]] const dvec2& place_mm() const { return place_mm_; }

  private:
    TouchPath path_;
    double since_s_ = 0.0;
    dvec2 place_mm_{0.0};
};

}  // namespace onggi::app
