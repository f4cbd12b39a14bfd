// A visitor on a virtual clock: sends events to the state machine and stores its effects.
#pragma once

#include <algorithm>
#include <vector>

#include "game/visit/flow/flow.h"
#include "game/visit/flow/step.h"

namespace onggi::visit {

class Visitor {
  public:
    explicit Visitor(const Rules& given = {}) : rules(given), state(first_state(given, 0.0)) {}

    Visitor& does(const Event& event) {
        last = advance(state, event, now_s, rules);
        all.insert(all.end(), last.begin(), last.end());
        return *this;
    }
    Visitor& presses(Button button, int value = 0) { return does(event::Pressed{button, value}); }
    // Time passes as it does in the program: a tick a frame, here ten a second.
    Visitor& waits(double seconds) {
        const double until_s = now_s + seconds;
        while (now_s + 0.1 <= until_s + 1e-9) {
            now_s += 0.1;
            does(event::Tick{});
        }
        return *this;
    }
    template <typename Wanted>
    [[nodiscard]] bool caused() const {
        return count<Wanted>() > 0;
    }
    template <typename Wanted>
    [[nodiscard]] long count() const {
        return std::count_if(all.begin(), all.end(),
                             [](const Effect& effect) { return std::holds_alternative<Wanted>(effect); });
    }

    // The short ways to the screens.
    Visitor& starts_to_throw() { return does(event::Input{}).presses(Button::kFree); }
    Visitor& chooses_a_jar(int target) { return does(event::Input{}).presses(Button::kTarget, target); }
    Visitor& ends_a_bowl() { return does(event::Bowl{.is_bowl = true}).presses(Button::kDone); }
    // Starting from the jar's explanation.
    Visitor& sets_a_bowl_aside() {
        return presses(Button::kBegin).ends_a_bowl().does(event::SetAside{}).presses(Button::kDone);
    }
    Visitor& holds_two_bowls() { return sets_a_bowl_aside().ends_a_bowl().does(event::Rims{3}); }
    Visitor& joins_two_bowls() { return holds_two_bowls().presses(Button::kJoinBowls).does(event::Joined{}); }
    Visitor& fires() { return starts_to_throw().does(event::ClayTouched{}).presses(Button::kDone); }
    Visitor& decorates() { return fires().presses(Button::kSkip); }
    Visitor& chooses_a_glaze() { return decorates().presses(Button::kDone).presses(Button::kSkip); }
    Visitor& sees_the_pot() { return chooses_a_glaze().presses(Button::kTakeGlaze); }
    Visitor& keeps() { return sees_the_pot().presses(Button::kKeep); }

    Rules rules;
    State state;
    double now_s = 0.0;
    std::vector<Effect> last;
    std::vector<Effect> all;
};

}  // namespace onggi::visit
