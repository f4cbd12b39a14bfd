// One call of advance() in progress, as the steps of a visit see it. Any thread.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "game/kiosk/rules.h"
#include "game/visit/flow/step.h"

namespace onggi::visit {

struct Turn {
    State& state;
    double now_s;
    const Rules& rules;
    std::vector<Effect> effects{};

    void add(const Effect& effect) { effects.push_back(effect); }
    // Leaves the step, and enters the one of that screen.
    void show(Screen screen);
    void lay_over(Panel panel);
    // Hands an event to the step.
    void take(const Event& event);
    // From attract to the choice of a pot, or to the pot that a power cut left.
    void begin_visit();
    // Puts a fresh lump on the wheel and resets the settings of throwing.
    void put_on_clay(std::optional<int> target);
    // Changes the volume by `by` steps, within its range.
    void change_volume(int by);
    // Returns to attract and drops everything of the visitor.
    void end_visit();
    // Closes the staff's panel.
    void leave_staff();
};

// Whether the button moves the hand or the brush.
[[nodiscard]] constexpr bool moves_hand(Button button) {
    return button == Button::kHandUp || button == Button::kHandDown || button == Button::kHandLeft ||
           button == Button::kHandRight;
}

// Adds `by`, clamped from 1 to `most`.
inline void change(int& value, int by, int most) {
    value = std::clamp(value + by, 1, most);
}

}  // namespace onggi::visit
