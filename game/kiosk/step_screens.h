// What the buttons of each screen do; step.cpp decides which screen is asked. Any thread.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "game/kiosk/step.h"

namespace onggi::kiosk {

// One step in the making.
struct Turn {
    State& state;
    double now_s;
    const Rules& rules;
    std::vector<Effect> effects{};

    void add(Effect::Kind kind, int value = 0) { effects.push_back({kind, value}); }
    void show(Screen screen);
    void lay_over(Panel panel);
    void leave_staff();
    void begin_visit(Screen screen);
    // A fresh lump and the settings that go with it.
    void put_on_clay(std::optional<int> target);
    // A step louder or softer, where there is one.
    void change_volume(int by);
    // Attract again, with nothing left of the visitor.
    void end_visit();
};

// One of the four that move the hand, or the brush.
[[nodiscard]] constexpr bool moves_hand(Button button) {
    return button == Button::kHandUp || button == Button::kHandDown || button == Button::kHandLeft ||
           button == Button::kHandRight;
}

// More or less by so much, from 1 to the most.
inline void change(int& value, int by, int most) {
    value = std::clamp(value + by, 1, most);
}

void press_screen(Turn& turn, const Event& event);
void press_idle(Turn& turn, const Event& event);
void press_language(Turn& turn, const Event& event);
// What is told of a museum's pot.
void press_card(Turn& turn, const Event& event);
// PIN and panel; in step_staff.cpp.
void press_staff(Turn& turn, const Event& event);
// The wheel's own hands, on the throwing screen; in step_show.cpp. They begin with the next step, or where
// all are known with the last, and end where nothing is shown as they end anywhere.
void begin_show(Turn& turn);
void end_show(Turn& turn);
void pass_show(Turn& turn);
// A jar of two bowls; in step_jar.cpp. press_jar() is asked first on the throwing screen, and says whether
// the button was its.
void begin_jar(Turn& turn, int target);
void press_jar_start(Turn& turn, const Event& event);
[[nodiscard]] bool press_jar(Turn& turn, const Event& event);
// Where an interrupted visit made one, it goes on with it.
void resume_jar(Turn& turn);
void press_join(Turn& turn, const Event& event);
void take_jar(Turn& turn, const Event& event);
// The second bowl begins, where the first was looked at for long enough or somebody wants to go on.
void pass_aside(Turn& turn);
void end_aside(Turn& turn);
// New clay for what is being thrown; over a jar the bowl that was set aside stays.
void put_on_new_clay(Turn& turn);
// Keeping, and the way home by phone; in step_keep.cpp.
void press_keep(Turn& turn, const Event& event);
void take_saved(Turn& turn, const Event& event);
void take_shared(Turn& turn, const Event& event);
// Turning the foot; in step_trim.cpp. After the drying: it is offered, or decorating begins.
void end_drying(Turn& turn);
void press_trim(Turn& turn, const Event& event);
void take_trim(Turn& turn, const Event& event);
// Decorating; in step_decorate.cpp. Whoever was offered it goes on to the kiln.
void begin_decorating(Turn& turn);
void press_decorate(Turn& turn, const Event& event);
void take_drawn(Turn& turn, const Event& event);
// Cutting, drying and firing go on by themselves.
void pass_firing(Turn& turn);

}  // namespace onggi::kiosk
