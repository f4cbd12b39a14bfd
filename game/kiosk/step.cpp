#include "game/kiosk/step.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "game/kiosk/step_screens.h"

namespace onggi::kiosk {

std::string_view name_of(Screen screen) {
    constexpr std::array<std::string_view, kScreenCount> kNames{
        "attract", "choose",   "jar-start", "throw",    "join", "failure", "firing",
        "trim",    "decorate", "glaze",     "your-pot", "keep", "resume",  "fault"};
    return kNames[static_cast<std::size_t>(screen)];
}

std::string_view name_of(Panel panel) {
    constexpr std::array<std::string_view, kPanelCount> kNames{"",    "language", "idle",
                                                               "pin", "staff",    "card"};
    return kNames[static_cast<std::size_t>(panel)];
}

std::string_view name_of(Held held) {
    constexpr std::array<std::string_view, kHeldCount> kNames{"", "rib", "sponge", "wire"};
    return kNames[static_cast<std::size_t>(held)];
}

int seconds_left(const State& state, double countdown_s, double now_s) {
    return std::max(0, static_cast<int>(std::ceil(countdown_s - (now_s - state.panel_s) - 1e-9)));
}

State first_state(const Rules& rules, double now_s) {
    State state;
    state.comfort.language = state.house_language = rules.default_language;
    state.comfort.volume = state.house_volume = rules.default_volume;
    state.comfort.text_size = rules.default_text_size;
    state.screen_s = state.panel_s = state.input_s = state.visit_s = now_s;
    return state;
}

int pin_seconds_left(const State& state, double now_s) {
    return std::max(0, static_cast<int>(std::ceil(state.pin_guard.opens_s - now_s - 1e-9)));
}

bool shows_hint(const State& state, double now_s, const Rules& rules) {
    if (state.screen != Screen::kThrow || state.panel != Panel::kNone) return false;
    const Throwing& throwing = state.throwing;
    if (throwing.steps_done >= kTeachingSteps || throwing.shown || state.pace.held) return false;
    if (state.pace.touched_s < 0.0) return true;
    return now_s - std::max(state.pace.progress_s, state.pace.touched_s) >= rules.hint_again_s;
}

void Turn::show(Screen screen) {
    if (screen == Screen::kChoose) state.shelf_first = 0;
    state.screen = screen;
    state.screen_s = now_s;
}

void Turn::lay_over(Panel panel) {
    state.panel = panel;
    state.panel_s = now_s;
}

void Turn::leave_staff() {
    lay_over(Panel::kNone);
    // What the staff tried out is not the next visitor's wish.
    if (state.screen == Screen::kAttract) end_visit();
}

void Turn::begin_visit(Screen screen) {
    if (screen == Screen::kThrow || screen == Screen::kChoose || screen == Screen::kResume) {
        if (state.screen == Screen::kAttract) {
            state.visit_s = now_s;
            add(effect::VisitBegan{});
        }
    }
    show(screen);
}

void Turn::put_on_clay(std::optional<int> target) {
    state.throwing = Throwing{.target = target};
    state.pace = {.progress_s = now_s};
    add(effect::ForgetPot{});
    add(effect::FreshClay{target});
}

void Turn::end_visit() {
    if (state.screen != Screen::kAttract && state.screen != Screen::kFault) {
        add(effect::VisitEnded{.dwell_s = static_cast<int>(now_s - state.visit_s), .last = state.screen});
    }
    const State before = state;
    state = first_state(rules, now_s);
    // What is the kiosk's and not the visitor's.
    state.device_lost = before.device_lost;
    state.pin_guard = before.pin_guard;
    state.comfort.volume = state.house_volume = before.house_volume;
    state.comfort.language = state.house_language = before.house_language;
    state.force_rests = before.force_rests;
    state.interrupted_jar = before.interrupted_jar;
    state.interrupted_session = before.interrupted_session;  // until somebody has decided
    add(effect::ForgetPot{});
    add(effect::SetVolume{state.house_volume});
    add(effect::StartDemo{});
}

namespace {

void pass_time(Turn& turn) {
    State& state = turn.state;
    const double now_s = turn.now_s;
    switch (state.panel) {
        case Panel::kIdle:
            if (now_s - state.panel_s >= turn.rules.countdown_s) turn.end_visit();
            return;
        case Panel::kPin:
        case Panel::kStaff:
            if (now_s - state.staff_used_s >= turn.rules.staff_locks_s) turn.leave_staff();
            return;
        case Panel::kNone:
        case Panel::kLanguage:
        case Panel::kCard:
            break;
    }
    if (state.screen == Screen::kFault) return;
    if (state.screen == Screen::kAttract) {
        // Attract never ends by itself; somebody who only looked at the languages has gone again.
        if (state.panel == Panel::kLanguage && now_s - state.input_s >= turn.rules.idle_s) turn.end_visit();
        return;
    }
    if (state.screen == Screen::kFiring) pass_firing(turn);
    if (state.screen == Screen::kThrow && state.panel == Panel::kNone) {
        pass_aside(turn);
        pass_show(turn);
    }
    const bool makes_jar =
        state.throwing.jar.step != JarStep::kNone &&
        (state.screen == Screen::kThrow || state.screen == Screen::kJoin || state.screen == Screen::kFailure);
    const double idle_s = makes_jar ? turn.rules.jar_idle_s : turn.rules.idle_s;
    if (now_s - state.input_s >= idle_s) turn.lay_over(Panel::kIdle);
}

// Something that lives is there. In attract it begins; at the countdown it goes on.
void wake(Turn& turn) {
    State& state = turn.state;
    state.input_s = turn.now_s;
    if (state.panel == Panel::kPin || state.panel == Panel::kStaff) state.staff_used_s = turn.now_s;
    if (state.panel == Panel::kIdle) {
        turn.lay_over(Panel::kNone);
        return;
    }
    if (state.panel == Panel::kNone && state.screen == Screen::kAttract) {
        turn.begin_visit(state.interrupted_session ? Screen::kResume : Screen::kChoose);
    }
}

void press(Turn& turn, const event::Pressed& event) {
    State& state = turn.state;
    state.input_s = turn.now_s;
    switch (state.panel) {
        case Panel::kIdle:
            press_idle(turn, event);
            return;
        case Panel::kLanguage:
            press_language(turn, event);
            return;
        case Panel::kCard:
            press_card(turn, event);
            return;
        case Panel::kPin:
        case Panel::kStaff:
            state.staff_used_s = turn.now_s;
            press_staff(turn, event);
            return;
        case Panel::kNone:
            break;
    }
    if (event.button == Button::kLanguages && state.screen != Screen::kFault) {
        turn.lay_over(Panel::kLanguage);
        return;
    }
    // In attract it begins a visit, as any key does.
    if (event.button == Button::kForces && state.screen != Screen::kAttract) {
        state.comfort.forces = !state.comfort.forces;
        return;
    }
    press_screen(turn, event);
}

void touch_clay(Turn& turn, bool goes_on) {
    State& state = turn.state;
    wake(turn);
    if (state.panel != Panel::kNone) return;
    // Touching the clay beside the cards is choosing to throw as one likes.
    if (state.screen == Screen::kChoose) {
        turn.show(Screen::kThrow);
        turn.put_on_clay(std::nullopt);
    }
    if (state.screen != Screen::kThrow) return;
    end_show(turn);
    end_aside(turn);
    // Hands that a key sent work on for a while. What is asked for meanwhile, and what is said to it, stays.
    if (!goes_on) state.throwing.tray = state.throwing.jar.is_low = state.throwing.jar.rims_apart = false;
    state.throwing.jar.touched = state.throwing.jar.step != JarStep::kNone;
    state.pace.touched_s = turn.now_s;
    state.pace.seen_since_touch.reset();
}

// The wheel cannot work any more.
void enter_fault(Turn& turn) {
    State& state = turn.state;
    if (state.screen == Screen::kFault) return;
    // The staff looks into it: what they have before them stays.
    const bool is_staffs = state.panel == Panel::kPin || state.panel == Panel::kStaff;
    const Panel panel = is_staffs ? state.panel : Panel::kNone;
    const Staff staff = state.staff;
    const double used_s = state.staff_used_s;
    turn.end_visit();
    turn.show(Screen::kFault);
    if (is_staffs) {
        turn.lay_over(panel);
        state.staff = staff;
        state.staff_used_s = used_s;
    }
}

void ask_for_pin(Turn& turn) {
    State& state = turn.state;
    if (turn.rules.pin_digits <= 0 || state.panel == Panel::kStaff) return;
    state.staff = {};
    state.staff_used_s = turn.now_s;
    state.input_s = turn.now_s;
    turn.lay_over(Panel::kPin);
}

// What each event does to the visit.
struct Taking {
    Turn& turn;
    State& state = turn.state;

    void operator()(const event::Tick& /*event*/) { pass_time(turn); }
    void operator()(const event::Input& input) {
        wake(turn);
        if (input.by_key) end_show(turn);
    }
    void operator()(const event::Pressed& pressed) { press(turn, pressed); }
    void operator()(const event::ClayTouched& touched) { touch_clay(turn, touched.goes_on); }
    void operator()(const event::ShowOver& /*event*/) { end_show(turn); }
    void operator()(const event::Held& held) {
        // Who has just let go is not shown anything at once.
        if (state.pace.held && !held.holds) state.pace.touched_s = turn.now_s;
        state.pace.held = held.holds;
    }
    void operator()(const event::Soaked& /*event*/) {
        if (state.screen == Screen::kThrow) state.throwing.water = std::max(1, state.throwing.water - 1);
    }
    void operator()(const event::Progress& progress) {
        if (state.screen != Screen::kThrow || progress.steps_done <= state.throwing.steps_done) return;
        state.throwing.steps_done = std::min(progress.steps_done, kTeachingSteps);
        state.pace.progress_s = turn.now_s;
    }
    void operator()(const event::Warned& warned) {
        if (state.screen == Screen::kThrow) state.throwing.warning = warned.warning;
    }
    void operator()(const event::Collapsed& collapsed) {
        if (state.screen != Screen::kThrow) return;
        if (state.panel == Panel::kLanguage) turn.lay_over(Panel::kNone);
        state.throwing.collapse = collapsed.cause;
        turn.show(Screen::kFailure);
    }
    void operator()(const event::Bowl& bowl) { take_jar(turn, bowl); }
    void operator()(const event::SetAside& event) { take_jar(turn, event); }
    void operator()(const event::Rims& rims) { take_jar(turn, rims); }
    void operator()(const event::RimsApart& event) { take_jar(turn, event); }
    void operator()(const event::Joined& event) { take_jar(turn, event); }
    void operator()(const event::JarStays& event) { take_jar(turn, event); }
    void operator()(const event::UndoneAll& event) { take_jar(turn, event); }
    void operator()(const event::ThickFoot& /*event*/) { take_thick_foot(turn); }
    void operator()(const event::Trimmed& trimmed) { take_trimmed(turn, trimmed); }
    void operator()(const event::Drawn& drawn) { take_drawn(turn, drawn); }
    void operator()(const event::Saved& saved) { take_saved(turn, saved.number); }
    void operator()(const event::SaveFailed& /*event*/) { take_saved(turn, std::nullopt); }
    void operator()(const event::Shared& shared) { take_shared(turn, shared); }
    void operator()(const event::Device& device) { state.device_lost = !device.is_there; }
    void operator()(const event::Force& force) { state.force_rests = force.rests; }
    void operator()(const event::Fault& /*event*/) { enter_fault(turn); }
    void operator()(const event::FaultOver& /*event*/) {
        if (state.screen == Screen::kFault) turn.end_visit();
    }
    void operator()(const event::InterruptedSession& found) {
        state.interrupted_session = true;
        state.interrupted_jar = found.jar;
    }
    void operator()(const event::CornerHeld& /*event*/) { ask_for_pin(turn); }
    void operator()(const event::CloseAsked& /*event*/) {
        if (!turn.rules.locked) turn.add(effect::Quit{});
    }
};

}  // namespace

std::vector<Effect> step(State& state, const Event& event, double now_s, const Rules& rules) {
    Turn turn{.state = state, .now_s = now_s, .rules = rules};
    const bool showed = state.throwing.shown.has_value();
    std::visit(Taking{turn}, event);
    if (state.screen != Screen::kThrow || state.panel != Panel::kNone) end_show(turn);
    // Before whatever else is done to the clay.
    if (showed && !state.throwing.shown) turn.effects.insert(turn.effects.begin(), effect::StopShow{});
    return std::move(turn.effects);
}

}  // namespace onggi::kiosk
