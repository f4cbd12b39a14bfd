// The handlers of each screen's buttons; step.cpp chooses the handler. Any thread.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "game/kiosk/step.h"

namespace onggi::kiosk {

// One call of step() in progress.
struct Turn {
    State& state;
    double now_s;
    const Rules& rules;
    std::vector<Effect> effects{};

    void add(const Effect& effect) { effects.push_back(effect); }
    void show(Screen screen);
    void lay_over(Panel panel);
    void leave_staff();
    void begin_visit(Screen screen);
    // Puts a fresh lump on the wheel and resets the settings of throwing.
    void put_on_clay(std::optional<int> target);
    // Changes the volume by `by` steps, within its range.
    void change_volume(int by);
    // Returns to attract and drops everything of the visitor.
    void end_visit();
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

void press_screen(Turn& turn, const event::Pressed& event);
void press_idle(Turn& turn, const event::Pressed& event);
void press_language(Turn& turn, const event::Pressed& event);
// The card of a heritage pot.
void press_card(Turn& turn, const event::Pressed& event);
// PIN and panel; in step_staff.cpp.
void press_staff(Turn& turn, const event::Pressed& event);
// Demonstrations by the wheel's own hands, on the throwing screen; in step_show.cpp. begin_show() shows the
// next step, or the last one if all are done. end_show() may be called when nothing is shown.
void begin_show(Turn& turn);
void end_show(Turn& turn);
void pass_show(Turn& turn);
// A jar of two bowls; in step_jar.cpp. The throwing screen calls press_jar() first, which returns whether it
// handled the button.
void begin_jar(Turn& turn, int target);
void press_jar_start(Turn& turn, const event::Pressed& event);
[[nodiscard]] bool press_jar(Turn& turn, const event::Pressed& event);
// Continues the jar of an interrupted visit, if there is one.
void resume_jar(Turn& turn);
void press_join(Turn& turn, const event::Pressed& event);
void take_jar(Turn& turn, const event::Bowl& bowl);
void take_jar(Turn& turn, const event::SetAside& event);
void take_jar(Turn& turn, const event::Rims& rims);
void take_jar(Turn& turn, const event::RimsApart& event);
void take_jar(Turn& turn, const event::Joined& event);
void take_jar(Turn& turn, const event::JarStays& event);
void take_jar(Turn& turn, const event::UndoneAll& event);
// pass_aside() begins the second bowl after Rules::aside_s, end_aside() at once.
void pass_aside(Turn& turn);
void end_aside(Turn& turn);
// Replaces the clay on the wheel. A bowl that was set aside stays.
void put_on_new_clay(Turn& turn);
// Keeping a pot and sharing it with a phone; in step_keep.cpp.
void press_keep(Turn& turn, const event::Pressed& event);
// number: empty where the pot could not be saved.
void take_saved(Turn& turn, std::optional<int> number);
void take_shared(Turn& turn, const event::Shared& shared);
// Trimming the foot; in step_trim.cpp. end_drying() offers it, or begins decorating.
void end_drying(Turn& turn);
void press_trim(Turn& turn, const event::Pressed& event);
void take_thick_foot(Turn& turn);
void take_trimmed(Turn& turn, const event::Trimmed& trimmed);
// Decorating; in step_decorate.cpp. The kiln follows.
void begin_decorating(Turn& turn);
void press_decorate(Turn& turn, const event::Pressed& event);
void take_drawn(Turn& turn, const event::Drawn& drawn);
// Advances cutting, drying and firing by time.
void pass_firing(Turn& turn);

}  // namespace onggi::kiosk
