#include "game/app/devices/gamepad_finger.h"

#include <algorithm>
#include <cmath>

namespace onggi::app {
namespace {

using window::Gamepad;

// A trigger at rest seldom reads exactly 0.
constexpr float kTriggerPulled = 0.1F;
constexpr std::uint32_t kRingButtons = Gamepad::kLeft | Gamepad::kRight | Gamepad::kX;

// The stick's deflection beyond its dead band. The band is radial, so that it has no corners.
dvec2 beyond_band(dvec2 stick, double dead_band) {
    const double length = std::sqrt(glm::dot(stick, stick));
    if (!(length > dead_band)) return dvec2(0.0);
    return stick * (std::min((length - dead_band) / (1.0 - dead_band), 1.0) / length);
}

// The cube of the deflection, for fine control with a light push.
dvec2 shaped(dvec2 beyond) {
    return beyond * glm::dot(beyond, beyond);
}

}  // namespace

GamepadFinger::Lives GamepadFinger::watch(const Gamepad& pad, double dt_s) {
    const haptics::ControlSense sense(mapping_.noise);
    auto [place, is_new] = watched_.try_emplace(
        pad.slot, Watched{pad.name, true, sense, sense, sense, haptics::ControlSense(0.5)});
    Watched& watched = place->second;
    watched.name = pad.name;
    watched.is_here = true;
    // A new pad counts as at rest before its first report, so that a control that is pressed then is a
    // change.
    if (is_new) {
        for (haptics::ControlSense* each :
             {&watched.left, &watched.right, &watched.trigger, &watched.buttons})
            static_cast<void>(each->moved_to(dvec3(0.0), 0.0));
    }
    const auto is_moved = [&](haptics::ControlSense& control, const dvec2& value) {
        return control.moved_to(dvec3(value, 0.0), dt_s, value != dvec2(0.0));
    };
    const bool left = is_moved(watched.left, beyond_band({pad.left_x, -pad.left_y}, mapping_.dead_band));
    const bool right = is_moved(watched.right, beyond_band({pad.right_x, -pad.right_y}, mapping_.dead_band));
    const float pulled = pad.right_trigger > kTriggerPulled ? pad.right_trigger : 0.0F;
    return {.sticks = left || right,
            .trigger = is_moved(watched.trigger, {pulled, 0.0}),
            .buttons = is_moved(watched.buttons, {static_cast<double>(pad.buttons), 0.0})};
}

std::vector<std::string> GamepadFinger::restless() const {
    std::vector<std::string> names;
    for (const auto& [slot, pad] : watched_) {
        if (pad.is_here && (pad.left.never_rests() || pad.right.never_rests() || pad.trigger.never_rests() ||
                            pad.buttons.never_rests()))
            names.push_back(pad.name);
    }
    return names;
}

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
    Lives lives;
    for (auto& [slot, watched] : watched_)
        watched.is_here = false;
    for (const Gamepad& pad : pads) {
        const Lives now = watch(pad, dt_s);
        lives = {lives.sticks || now.sticks, lives.trigger || now.trigger, lives.buttons || now.buttons};
        // A stick that rests away from the middle is worn and does not move the finger.
        const Watched& watched = watched_.at(pad.slot);
        if (watched.left.still_s() < mapping_.longest_still_s)
            push += shaped(beyond_band({pad.left_x, -pad.left_y}, mapping_.dead_band));
        if (watched.right.still_s() < mapping_.longest_still_s)
            push += mapping_.finer * shaped(beyond_band({pad.right_x, -pad.right_y}, mapping_.dead_band));
        trigger = std::max(trigger, pad.right_trigger);
        buttons |= pad.buttons;
    }
    // A button with chattering contacts is ignored.
    const std::uint32_t changed = lives.buttons ? buttons ^ last_buttons_ : 0U;
    const std::uint32_t pressed = buttons & changed;
    const bool moves = lives.sticks || lives.trigger;
    request.is_used = moves || changed != 0;
    request.is_for_clay = moves || (changed & ~kRingButtons) != 0;
    last_buttons_ = buttons;

    request.step_mm = glm::clamp(push, -1.0, 1.0) * (mapping_.fastest_mm_s * dt_s);
    request.presses = presses((buttons & Gamepad::kA) != 0, double{trigger}, lives.sticks, dt_s);
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
