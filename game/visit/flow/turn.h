// One call of advance() in progress, passed to the steps' functions. Any thread.
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
    // Leaves the current step and enters that of `screen`.
    void show(Screen screen);
    void lay_over(Panel panel);
    // Passes an event to the current step.
    void take(const Event& event);
    // Goes from attract to the choice of a pot, or to the offer to continue the interrupted pot.
    void begin_visit();
    // Puts a fresh lump on the wheel and resets the settings of throwing.
    void put_on_clay(std::optional<int> target);
    // Changes the volume by `by` steps, within its range.
    void change_volume(int by);
    // Returns to attract and drops the visitor's state.
    void end_visit();
    // Closes the staff's panel.
    void leave_staff();
};

// Whether the button moves the hand or the brush.
[[nodiscard]] constexpr bool moves_hand(Button button) {
    return button == Button::kHandUp || button == Button::kHandDown || button == Button::kHandLeft ||
           button == Button::kHandRight;
}

// Adds `by` and clamps the result to 1 ... most.
inline void change(int& value, int by, int most) {
    value = std::clamp(value + by, 1, most);
}

}  // namespace onggi::visit
