#include "game/visit/flow/flow.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/visit/flow/turn.h"

namespace onggi::visit {

int seconds_left(const State& state, double countdown_s, double now_s) {
    return std::max(0, static_cast<int>(std::ceil(countdown_s - (now_s - state.panel_s) - 1e-9)));
}

State first_state(const Rules& rules, double now_s) {
    State state;
    state.comfort.language = state.house_language = rules.default_language;
    state.comfort.volume = state.house_volume = rules.default_volume;
    state.comfort.text_size = rules.default_text_size;
    state.comfort.speech = rules.speaks;
    state.screen_s = state.panel_s = state.input_s = state.visit_s = now_s;
    return state;
}

int pin_seconds_left(const State& state, double now_s) {
    return std::max(0, static_cast<int>(std::ceil(state.pin_guard.opens_s - now_s - 1e-9)));
}

namespace {

// Before a visitor has switched it on or off.
bool speaks_at_first(const State& state, const Rules& rules) {
    return rules.speaks || (rules.offers_speech && state.headphones);
}

}  // namespace

void Turn::show(Screen screen) {
    const auto leave = step_of(state.screen).leave;
    if (leave != nullptr && screen != state.screen) leave(*this);
    state.screen = screen;
    state.screen_s = now_s;
    if (const auto enter = step_of(screen).enter) enter(*this);
}

void Turn::lay_over(Panel panel) {
    const auto leave = step_of(state.screen).leave;
    if (leave != nullptr && panel != Panel::kNone) leave(*this);
    state.panel = panel;
    state.panel_s = now_s;
}

void Turn::take(const Event& event) {
    if (const auto take_it = step_of(state.screen).take) take_it(*this, event);
}

void Turn::leave_staff() {
    lay_over(Panel::kNone);
    // Outside a visit, settings that the staff tried out must not remain for the next visitor.
    if (step_of(state.screen).whose == Whose::kNobody) end_visit();
}

void Turn::begin_visit() {
    state.visit_s = now_s;
    add(effect::VisitBegan{});
    show(state.interrupted_session ? Screen::kResume : Screen::kChoose);
}

void Turn::put_on_clay(std::optional<int> target) {
    state.throwing = Throwing{.target = target};
    state.thick_mm = 0;
    state.was_cut_off = false;
    state.pace = {.progress_s = now_s};
    add(effect::ForgetPot{});
    add(effect::FreshClay{target});
}

void Turn::change_volume(int by) {
    const int changed = std::clamp(state.comfort.volume + by, 0, kMostVolume);
    if (changed == state.comfort.volume) return;
    state.comfort.volume = changed;
    add(effect::SetVolume{changed});
}

void Turn::end_visit() {
    if (step_of(state.screen).whose == Whose::kVisitor) {
        add(effect::VisitEnded{.dwell_s = static_cast<int>(now_s - state.visit_s), .last = state.screen});
    }
    const State before = state;
    state = first_state(rules, now_s);
    // Keep the state that belongs to the kiosk and not to the visitor.
    state.device_lost = before.device_lost;
    state.pin_guard = before.pin_guard;
    state.comfort.volume = state.house_volume = before.house_volume;
    state.comfort.language = state.house_language = before.house_language;
    state.force_rests = before.force_rests;
    state.headphones = before.headphones;
    state.comfort.speech = speaks_at_first(state, rules);
    state.speaks = before.speaks;
    state.interrupted_jar = before.interrupted_jar;
    state.interrupted_pot = before.interrupted_pot;
    state.interrupted_session = before.interrupted_session;  // until a visitor accepts or declines it
    add(effect::ForgetPot{});
    add(effect::SetVolume{state.house_volume});
    add(effect::StartDemo{});
}

namespace {

// A voice takes longer than reading does: its time does not count as idle, within bounds.
bool is_idle(const Turn& turn, double idle_s) {
    const double heard_s = std::min(turn.state.listened_s, turn.rules.listens_most_s);
    return turn.now_s - turn.state.input_s - heard_s >= idle_s;
}

void pass_time(Turn& turn) {
    State& state = turn.state;
    const double since_s = turn.now_s - std::exchange(state.ticked_s, turn.now_s);
    if (state.speaks) state.listened_s += since_s;
    if (const auto tick = overlay_of(state.panel).tick) return tick(turn);
    if (const auto tick = step_of(state.screen).tick) tick(turn);
    const Step& step = step_of(state.screen);  // the tick may have changed the screen
    if (step.whose != Whose::kVisitor) return;
    // A work that never ends must not keep the kiosk from the next visitor.
    if (step.works == nullptr || !step.works(state)) state.works_s = turn.now_s;
    if (state.works_s < turn.now_s && turn.now_s - state.works_s < turn.rules.works_most_s)
        state.input_s = turn.now_s;
    const bool makes_jar = step.has_wet_clay && state.throwing.jar.step != JarStep::kNone;
    const double idle_s = makes_jar ? turn.rules.jar_idle_s : turn.rules.idle_s;
    if (is_idle(turn, idle_s)) turn.lay_over(Panel::kIdle);
}

void take_input(Turn& turn) {
    turn.state.input_s = turn.now_s;
    turn.state.listened_s = 0.0;
}

// Handles input from a visitor: passes it to the step. During the idle countdown the visit continues.
void wake(Turn& turn, const Event& event) {
    State& state = turn.state;
    take_input(turn);
    if (overlay_of(state.panel).is_staffs) state.staff_used_s = turn.now_s;
    if (state.panel == Panel::kIdle) turn.lay_over(Panel::kNone);
    if (state.panel == Panel::kNone) turn.take(event);
}

void press(Turn& turn, const event::Pressed& event) {
    State& state = turn.state;
    take_input(turn);
    if (const auto press_it = overlay_of(state.panel).press) return press_it(turn, event);
    const Step& step = step_of(state.screen);
    if (event.button == Button::kLanguages && step.whose != Whose::kStaff) {
        turn.lay_over(Panel::kLanguage);
        return;
    }
    // In attract this button begins a visit, as any key does.
    if (event.button == Button::kForces && step.whose != Whose::kNobody) {
        state.comfort.forces = !state.comfort.forces;
        return;
    }
    if (step.press != nullptr) step.press(turn, event);
}

// The wheel has failed.
void enter_fault(Turn& turn) {
    State& state = turn.state;
    if (step_of(state.screen).whose == Whose::kStaff) return;
    // Keep the staff's panel open: they may be looking into the fault.
    const bool is_staffs = overlay_of(state.panel).is_staffs;
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

// Handles the events that are common to all steps; passes the others to the current step.
struct Taking {
    Turn& turn;
    const Event& event;
    State& state = turn.state;

    void operator()(const event::Tick& /*tick*/) { pass_time(turn); }
    void operator()(const event::Input& /*input*/) { wake(turn, event); }
    void operator()(const event::ClayTouched& /*touched*/) { wake(turn, event); }
    void operator()(const event::Pressed& pressed) { press(turn, pressed); }
    void operator()(const event::Held& held) {
        // After letting go, a visitor gets no demonstration at once.
        if (state.pace.held && !held.holds) state.pace.touched_s = turn.now_s;
        state.pace.held = held.holds;
    }
    void operator()(const event::Device& device) { state.device_lost = !device.is_there; }
    void operator()(const event::Force& force) { state.force_rests = force.rests; }
    // Plugging them in asks for speech; whoever pulls them out leaves, or the loudspeakers would go on.
    void operator()(const event::Headphones& headphones) {
        state.headphones = headphones.are_in;
        state.comfort.speech = speaks_at_first(state, turn.rules);
    }
    void operator()(const event::Spoken& spoken) { state.speaks = spoken.speaks; }
    void operator()(const event::Fault& /*fault*/) { enter_fault(turn); }
    void operator()(const event::InterruptedSession& found) {
        state.interrupted_session = true;
        state.interrupted_jar = found.jar;
        state.interrupted_pot = found.pot;
    }
    void operator()(const event::CornerHeld& /*held*/) { ask_for_pin(turn); }
    void operator()(const event::CloseAsked& /*asked*/) {
        if (!turn.rules.locked) turn.add(effect::Quit{});
    }
    template <typename Other>
    void operator()(const Other& /*other*/) {
        turn.take(event);
    }
};

}  // namespace

std::vector<Effect> advance(State& state, const Event& event, double now_s, const Rules& rules) {
    Turn turn{.state = state, .now_s = now_s, .rules = rules};
    const bool showed = state.throwing.shown.has_value();
    std::visit(Taking{turn, event}, event);
    // The demonstration stops before other effects touch the clay.
    if (showed && !state.throwing.shown) turn.effects.insert(turn.effects.begin(), effect::StopShow{});
    return std::move(turn.effects);
}

}  // namespace onggi::visit
