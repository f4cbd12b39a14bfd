#include "game/app/devices/gamepad_finger.h"

#include <algorithm>
#include <cmath>

namespace onggi::app {
namespace {

using window::Gamepad;

// A trigger at rest seldom reads exactly 0.
constexpr float kTriggerPulled = 0.1F;
constexpr std::uint32_t kRingButtons = Gamepad::kLeft | Gamepad::kRight | Gamepad::kX;

// The cube of the stick's deflection beyond its dead band, for fine control with a light push. The band is
// radial, so that it has no corners.
dvec2 shaped(dvec2 stick, double dead_band) {
    const double length = std::sqrt(glm::dot(stick, stick));
    if (!(length > dead_band)) return dvec2(0.0);
    const double beyond = std::min((length - dead_band) / (1.0 - dead_band), 1.0);
    return stick * (beyond * beyond * beyond / length);
}

}  // namespace

bool GamepadFinger::presses(bool button, double trigger, bool is_moving, double dt_s) {
    trigger_presses_ = trigger > (trigger_presses_ ? mapping_.released_at : mapping_.pressed_at);
    const bool is_held = button || trigger_presses_;
    // A stuck button must be released before it presses again.
    const bool is_stuck = still_s_ >= mapping_.longest_still_s;
    if (!is_held || (is_moving && !is_stuck)) still_s_ = 0.0;
    if (is_held) still_s_ += dt_s;
    return is_held && !is_stuck;
}

GamepadRequest GamepadFinger::request(std::span<const Gamepad> pads, double dt_s) {
    GamepadRequest request;
    std::uint32_t buttons = 0;
    dvec2 push(0.0);
    float trigger = 0.0F;
    for (const Gamepad& pad : pads) {
        push += shaped({pad.left_x, -pad.left_y}, mapping_.dead_band);
        push += mapping_.finer * shaped({pad.right_x, -pad.right_y}, mapping_.dead_band);
        trigger = std::max(trigger, pad.right_trigger);
        buttons |= pad.buttons;
    }
    const std::uint32_t pressed = buttons & ~last_buttons_;
    const std::uint32_t changed = buttons ^ last_buttons_;
    const bool moves = push != dvec2(0.0) || trigger > kTriggerPulled;
    request.is_used = moves || changed != 0;
    request.is_for_clay = moves || (changed & ~kRingButtons) != 0;
    last_buttons_ = buttons;

    request.step_mm = glm::clamp(push, -1.0, 1.0) * (mapping_.fastest_mm_s * dt_s);
    request.presses = presses((buttons & Gamepad::kA) != 0, double{trigger}, push != dvec2(0.0), dt_s);
    if ((pressed & Gamepad::kRightBumper) != 0) request.speed_steps += 1.0;
    if ((pressed & Gamepad::kLeftBumper) != 0) request.speed_steps -= 1.0;
    if ((pressed & Gamepad::kUp) != 0) request.radius_steps += 1.0;
    if ((pressed & Gamepad::kDown) != 0) request.radius_steps -= 1.0;
    if ((pressed & Gamepad::kRight) != 0) request.ring_steps += 1;
    if ((pressed & Gamepad::kLeft) != 0) request.ring_steps -= 1;
    request.takes = (pressed & Gamepad::kX) != 0;
    request.fresh_lump = (pressed & Gamepad::kStart) != 0;
    return request;
}

std::vector<window::KeyEvent> keys_of(const GamepadRequest& request) {
    using window::Key;
    std::vector<window::KeyEvent> keys;
    if (request.ring_steps != 0)
        keys.push_back(
            {.key = request.ring_steps > 0 ? Key::kRightBracket : Key::kLeftBracket, .pressed = true});
    if (request.takes) keys.push_back({.key = Key::kEnter, .pressed = true});
    return keys;
}

}  // namespace onggi::app
