// What the sticks and buttons of a gamepad mean at the wheel. Pure state, no window and no clock. Main
// thread, once a frame. mm, s.
#pragma once

#include <span>

#include "engine/math/math.h"
#include "engine/window/gamepad.h"

namespace onggi::app {

struct GamepadMapping {
    double dead_band = 0.15;  // of a stick's travel: worn sticks do not come back to the middle
    double fastest_mm_s = 160.0;
    double finer = 0.35;             // share of that for the right stick
    double fastest_rev_min = 240.0;  // the wheel with a trigger pulled all the way
};

// What a pad asks for in one frame.
struct GamepadWish {
    dvec3 step_mm{0.0};    // of the tool
    bool is_used = false;  // anything at all
    bool turns_wheel = false;
    double wheel_rev_min = 0.0;  // by how far a trigger is pulled; 0: a button holds it at its usual speed
    double radius_steps = 0.0;   // larger or smaller tool
    bool fresh_lump = false;     // asked once
    bool next_tool = false;
};

class GamepadHand {
  public:
    explicit GamepadHand(const GamepadMapping& mapping = {}) : mapping_(mapping) {}

    // The wish of the pads together, after dt_s. Left stick: out and in, up and down; right stick: the same,
    // finely. A trigger or A turns the wheel; bumpers and the cross up and down change the tool's size; X is
    // the next tool; Start is a fresh lump.
    [[nodiscard]] GamepadWish wish(std::span<const window::Gamepad> pads, double dt_s);

  private:
    GamepadMapping mapping_;
    std::uint32_t last_buttons_ = 0;  // of all pads
};

}  // namespace onggi::app
