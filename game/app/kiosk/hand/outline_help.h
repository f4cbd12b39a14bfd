// Helps a finger along a drawn outline: near it the finger is drawn to it a little, so that a hand that
// trembles still throws the pot that it was shown. Pure state, main thread. mm, s.
#pragma once

#include <span>
#include <vector>

#include "engine/math/math.h"

namespace onggi::app {

// How much a visitor is helped who has done so many steps of the lesson: less, the more they can. 0 to 1.
[[nodiscard]] double outline_help_after(int steps_done);

class OutlineHelp {
  public:
    // Radius and height from below, as app::wet_outline(); empty: none. strength: 0 none to 1 all the help.
    void set(std::span<const vec2> radius_height, double strength);
    // So that help which comes or goes is not felt to.
    void pass_time(double dt_s);
    // Where the finger is taken to be. Never farther from the outline than it is, nor on its other side.
    [[nodiscard]] dvec2 drawn(const dvec2& finger_mm) const;

  private:
    std::vector<vec2> outline_mm_;
    double strength_ = 0.0;  // as wished
    double now_ = 0.0;
};

}  // namespace onggi::app
