// The visitor's hand as pointer, keys and buttons make it: where the tool is wanted, which way it should come
// to the clay, and what the settings on the ledge make of it. Pure state, no window and no clock, so that
// tests play the visitor. Main thread. mm, s.
#pragma once

#include <optional>

#include "engine/haptics/tool_state.h"
#include "game/haptic/pot_shape.h"

namespace onggi::app {

// Where a hand that does nothing waits: off the clay, before it.
constexpr dvec3 kRestingMm{170.0, 220.0, 120.0};

struct HandSettings {
    int tool = 2;   // 1 to 3: how large
    int water = 3;  // 1 to 5
    int speed = 3;  // 1 to 5
};

class KioskHand {
  public:
    // A finger or a pressed mouse at a place on the upright plane through the axis.
    void press(const dvec3& place_mm, const haptic::PotShape& shape);
    void drag(const dvec3& place_mm);
    void release();
    // A mouse that only hovers: the hand waits in front of the clay, towards the eye.
    void hover(const dvec3& place_mm, const dvec3& towards_eye);
    // One press of the pad's buttons, or of a key: the hand works for a moment where it is. The first on new
    // clay brings it beside the clay, low on that side: +1 right, -1 left. Who has one switch alone would
    // have to press it two dozen times to get there.
    void nudge(const dvec3& step_mm, const haptic::PotShape& shape, double side);
    // New clay: it has not come to it yet.
    void leave_clay() { has_come_ = false; }

    // What the tool should do now, dt_s after the last call.
    [[nodiscard]] haptics::ToolState wish(const HandSettings& settings, const haptic::PotShape& shape,
                                          double dt_s);

    [[nodiscard]] bool works() const { return pressed_ || nudged_s_ > 0.0; }

  private:
    void come_beside(const haptic::PotShape& shape, double side);
    void come(const dvec3& place_mm, const haptic::PotShape& shape);

    dvec3 place_mm_{170.0, 150.0, 0.0};
    dvec3 waiting_mm_ = kRestingMm;
    double radius_mm_ = 12.0;  // of the tool, when it was last asked for
    bool has_come_ = false;    // to the clay that is on the wheel
    bool pressed_ = false;
    bool inside_ = false;    // this touch works inside the pot
    double above_s_ = 0.0;   // time left above the rim before it goes down inside
    double nudged_s_ = 0.0;  // time left of a nudge
};

// Outer and inner radius of the shape at a height; inner 0 where it is solid, both 0 above it.
struct Wall {
    double outer_mm = 0.0;
    double inner_mm = 0.0;
};
[[nodiscard]] Wall wall_at(const haptic::PotShape& shape, double y_mm);

}  // namespace onggi::app
