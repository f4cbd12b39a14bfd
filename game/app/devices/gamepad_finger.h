// Interprets the sticks and buttons of a gamepad at the wheel. Pure state, no window and no clock. Main
// thread, once a frame. mm, s.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/haptics/control_sense.h"
#include "engine/math/math.h"
#include "engine/window/events.h"
#include "engine/window/gamepad.h"

namespace onggi::app {

struct GamepadMapping {
    double dead_band = 0.15;  // fraction of a stick's travel: worn sticks do not return to the middle
    double fastest_mm_s = 160.0;
    double finer = 0.35;  // speed of the right stick as a fraction of the left one's
    // The trigger presses beyond pressed_at and releases below released_at.
    double pressed_at = 0.5;
    double released_at = 0.3;
    // A button held for longer without motion counts as stuck.
    double longest_still_s = haptics::kControlRestsS;
    double noise = 0.05;  // fraction of a stick's or trigger's travel; a smaller change is no sign of life
};

// The request of the gamepads in one frame.
struct GamepadRequest {
    dvec2 step_mm{0.0};         // motion of the finger on its plane
    bool is_used = false;       // a person changed any control
    bool is_for_clay = false;   // a person changed a control other than those of the focus ring
    bool presses = false;       // the finger touches the clay
    double speed_steps = 0.0;   // change of the wheel's speed
    double radius_steps = 0.0;  // change of the tool's size
    bool fresh_lump = false;    // set in the frame of the press, like ring_steps and takes
    int ring_steps = 0;         // steps of the focus ring, forwards or backwards
    bool takes = false;         // presses the button with the ring
};

// Converts the request's steps of the ring to the equivalent key events.
[[nodiscard]] std::vector<window::KeyEvent> keys_of(const GamepadRequest& request);

class GamepadFinger {
  public:
    explicit GamepadFinger(const GamepadMapping& mapping = {}) : mapping_(mapping) {}

    // Combines all gamepads into one request, dt_s after the last. Left stick: moves the finger; right stick:
    // moves it finely. A or the right trigger: presses. Bumpers: a slower or faster wheel. D-pad up and down:
    // the tool's size. Start: a fresh lump. D-pad left and right: moves the focus ring; X: presses the button
    // with the ring.
    [[nodiscard]] GamepadRequest request(std::span<const window::Gamepad> pads, double dt_s);
    // The names of the pads of the last request that do not come to rest (control_sense.h).
    [[nodiscard]] std::vector<std::string> restless() const;

  private:
    // The senses of a pad's controls.
    struct Watched {
        std::string name;
        bool is_here;
        haptics::ControlSense left;
        haptics::ControlSense right;
        haptics::ControlSense trigger;
        haptics::ControlSense buttons;
    };
    struct Lives {
        bool sticks = false;
        bool trigger = false;
        bool buttons = false;
    };
    [[nodiscard]] Lives watch(const window::Gamepad& pad, double dt_s);
    [[nodiscard]] bool presses(bool button, double trigger, bool is_moving, double dt_s);

    GamepadMapping mapping_;
    std::map<int, Watched> watched_;  // by slot; keeps pads that were unplugged
    bool trigger_presses_ = false;
    double still_s_ = 0.0;            // time since the pressing finger last moved
    std::uint32_t last_buttons_ = 0;  // of all gamepads
};

}  // namespace onggi::app
