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
            add(Effect::Kind::kVisitBegan);
        }
    }
    show(screen);
}

void Turn::put_on_clay(std::optional<int> target) {
    state.throwing = Throwing{.target = target};
    state.pace = {.progress_s = now_s};
    add(Effect::Kind::kForgetPot);
    add(Effect::Kind::kFreshClay, target ? *target : -1);
}

void Turn::end_visit() {
    if (state.screen != Screen::kAttract && state.screen != Screen::kFault) {
        add(Effect::Kind::kVisitEnded, static_cast<int>(now_s - state.visit_s));
    }
    const State before = state;
    state = first_state(rules, now_s);
    // State of the kiosk, not of the visitor.
    state.device_lost = before.device_lost;
    state.pin_guard = before.pin_guard;
    state.comfort.volume = state.house_volume = before.house_volume;
    state.comfort.language = state.house_language = before.house_language;
    state.force_rests = before.force_rests;
    state.interrupted_jar = before.interrupted_jar;
    state.interrupted_session = before.interrupted_session;  // until somebody has decided
    add(Effect::Kind::kForgetPot);
    add(Effect::Kind::kSetVolume, state.house_volume);
    add(Effect::Kind::kStartDemo);
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

void press(Turn& turn, const Event& event) {
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
    // Guided hands that a key started work on for a while; requests and cards of that time stay.
    if (!goes_on) state.throwing.tray = state.throwing.jar.is_low = state.throwing.jar.rims_apart = false;
    state.throwing.jar.touched = state.throwing.jar.step != JarStep::kNone;
    state.pace.touched_s = turn.now_s;
    state.pace.seen_since_touch.reset();
}

// Events of the clay on the wheel and of the hand on it.
void take_throwing(Turn& turn, const Event& event) {
    State& state = turn.state;
    switch (event.kind) {
        case Event::Kind::kHeld:
            // Who has just let go is not shown anything at once.
            if (state.pace.held && event.value != 1) state.pace.touched_s = turn.now_s;
            state.pace.held = event.value == 1;
            break;
        case Event::Kind::kSoaked:
            if (state.screen == Screen::kThrow) state.throwing.water = std::max(1, state.throwing.water - 1);
            break;
        case Event::Kind::kProgress:
            if (state.screen == Screen::kThrow && event.value > state.throwing.steps_done) {
                state.throwing.steps_done = std::min(event.value, kTeachingSteps);
                state.pace.progress_s = turn.now_s;
            }
            break;
        case Event::Kind::kWarned:
            if (state.screen == Screen::kThrow && event.value >= 0 &&
                event.value <= static_cast<int>(Warning::kFast) &&
                state.throwing.warning != static_cast<Warning>(event.value)) {
                state.throwing.warning = static_cast<Warning>(event.value);
            }
            break;
        case Event::Kind::kCollapsed:
            if (state.screen == Screen::kThrow) {
                if (state.panel == Panel::kLanguage) turn.lay_over(Panel::kNone);
                state.throwing.collapse =
                    static_cast<Warning>(std::clamp(event.value, 0, static_cast<int>(Warning::kFast)));
                turn.show(Screen::kFailure);
            }
            break;
        default:
            break;
    }
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

void take(Turn& turn, const Event& event) {
    State& state = turn.state;
    switch (event.kind) {
        case Event::Kind::kTick:
            pass_time(turn);
            break;
        case Event::Kind::kInput:
            wake(turn);
            if (event.value == 1) end_show(turn);
            break;
        case Event::Kind::kPressed:
            press(turn, event);
            break;
        case Event::Kind::kClayTouched:
            touch_clay(turn, event.value == 1);
            break;
        case Event::Kind::kShowOver:
            end_show(turn);
            break;
        case Event::Kind::kHeld:
        case Event::Kind::kSoaked:
        case Event::Kind::kProgress:
        case Event::Kind::kWarned:
        case Event::Kind::kCollapsed:
            take_throwing(turn, event);
            break;
        case Event::Kind::kBowl:
        case Event::Kind::kSetAside:
        case Event::Kind::kRims:
        case Event::Kind::kRimsApart:
        case Event::Kind::kJoined:
        case Event::Kind::kJarStays:
        case Event::Kind::kUndoneAll:
            take_jar(turn, event);
            break;
        case Event::Kind::kThickFoot:
        case Event::Kind::kTrimmed:
            take_trim(turn, event);
            break;
        case Event::Kind::kDrawn:
            take_drawn(turn, event);
            break;
        case Event::Kind::kSaved:
        case Event::Kind::kSaveFailed:
            take_saved(turn, event);
            break;
        case Event::Kind::kShared:
        case Event::Kind::kShareFailed:
        case Event::Kind::kShareOver:
            take_shared(turn, event);
            break;
        case Event::Kind::kDeviceLost:
        case Event::Kind::kDeviceBack:
            state.device_lost = event.kind == Event::Kind::kDeviceLost;
            break;
        case Event::Kind::kForceRests:
        case Event::Kind::kForceBack:
            state.force_rests = event.kind == Event::Kind::kForceRests;
            break;
        case Event::Kind::kFault:
            enter_fault(turn);
            break;
        case Event::Kind::kFaultOver:
            if (state.screen == Screen::kFault) turn.end_visit();
            break;
        case Event::Kind::kInterruptedSession:
            state.interrupted_session = true;
            state.interrupted_jar = event.value;
            break;
        case Event::Kind::kCornerHeld:
            ask_for_pin(turn);
            break;
        case Event::Kind::kCloseAsked:
            if (!turn.rules.locked) turn.add(Effect::Kind::kQuit);
            break;
    }
}

}  // namespace

std::vector<Effect> step(State& state, const Event& event, double now_s, const Rules& rules) {
    Turn turn{.state = state, .now_s = now_s, .rules = rules};
    const bool showed = state.throwing.shown.has_value();
    take(turn, event);
    if (state.screen != Screen::kThrow || state.panel != Panel::kNone) end_show(turn);
    // Before whatever else is done to the clay.
    if (showed && !state.throwing.shown)
        turn.effects.insert(turn.effects.begin(), Effect{Effect::Kind::kStopShow, 0});
    return std::move(turn.effects);
}

}  // namespace onggi::kiosk
