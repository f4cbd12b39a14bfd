// Throwing: the lesson, the tools, and the demonstrations. The wheel's own hands demonstrate a step on the
// visitor's clay on request, or by themselves when the visitor makes no progress.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "game/visit/jar/jar.h"
#include "game/visit/throw/throw.h"

namespace onggi::visit {
namespace {

constexpr int kRaiseStep = 2;  // steps done before it; raising goes on as long as the visitor likes
constexpr int kThinnerMm = 2;  // a visitor who took the advice has thinned the wall by this

// The next step of the lesson; the last one if all are done.
ShownStep next_step(const Throwing& throwing) {
    return static_cast<ShownStep>(std::min(throwing.steps_done, kTeachingSteps - 1));
}

void begin_show(Turn& turn) {
    Throwing& throwing = turn.state.throwing;
    const bool is_tool = throwing.held == tool::Tool::kRib || throwing.held == tool::Tool::kSponge;
    const ShownStep step = is_tool ? ShownStep::kDrawTool : next_step(throwing);
    if (!is_tool) throwing.held = tool::Tool::kHand;
    throwing.tray = false;
    throwing.shown = step;
    turn.state.pace.shown_s = turn.now_s;
    turn.state.pace.seen_since_touch = step;
    turn.add(effect::ShowStep{step});
}

void end_show(Turn& turn) {
    Throwing& throwing = turn.state.throwing;
    if (!throwing.shown) return;
    throwing.shown.reset();
    turn.state.pace.show_over_s = turn.now_s;
}

void pass_show(Turn& turn) {
    const Throwing& throwing = turn.state.throwing;
    const Pace& pace = turn.state.pace;
    const Rules& rules = turn.rules;
    const double now_s = turn.now_s;
    if (throwing.shown) {
        if (now_s - pace.shown_s >= rules.show_most_s) end_show(turn);
        return;
    }
    // Demonstrate each step once, but never while the visitor holds a tool, nor when the clay is near
    // collapse.
    const bool is_wanted = rules.shows_by_itself && throwing.steps_done < kTeachingSteps &&
                           throwing.held == tool::Tool::kHand && !throwing.tray &&
                           pace.seen_since_touch != next_step(throwing) && throwing.warning == Warning::kNone;
    const double quiet_s = now_s - std::max(pace.touched_s, pace.show_over_s);
    const bool rests = !pace.held && quiet_s >= rules.show_rests_s;
    // Who works on without a rest, or holds still, sees the step too once nothing has come of it for long.
    const double in_vain_s = now_s - std::max({pace.works_s, pace.progress_s, pace.show_over_s});
    const bool is_stuck = !rests && pace.touched_s >= 0.0 && throwing.steps_done < kRaiseStep &&
                          in_vain_s >= rules.show_stuck_s;
    if (is_wanted && (is_stuck || (rests && now_s - pace.progress_s >= rules.show_after_s))) begin_show(turn);
}

// A wall that is about to sink somewhere is not drawn any higher. Who takes the advice gets the next one, and
// who keeps the wall as it is, is asked once.
DoneQuestion question_of(const State& state) {
    const Throwing& throwing = state.throwing;
    if (throwing.is_solid) return DoneQuestion::kSolid;
    const bool is_thick = state.thick_mm > 0 && throwing.warning == Warning::kNone;
    const bool is_news = throwing.asked_mm == 0 || state.thick_mm <= throwing.asked_mm - kThinnerMm;
    return is_thick && is_news && throwing.jar.step == JarStep::kNone ? DoneQuestion::kThick
                                                                      : DoneQuestion::kNone;
}

void press_throw(Turn& turn, const event::Pressed& event) {
    Throwing& throwing = turn.state.throwing;
    const bool was_shown = throwing.shown.has_value();
    if (event.button != Button::kLookIn) end_show(turn);  // any other button ends the demonstration
    const DoneQuestion asked = std::exchange(throwing.asks, DoneQuestion::kNone);
    if (press_jar(turn, event)) return;
    switch (event.button) {
        case Button::kShowMe:
            if (!was_shown) begin_show(turn);
            break;
        case Button::kBack:
            turn.show(Screen::kChoose);
            break;
        case Button::kNewClay:
            put_on_new_clay(turn);
            break;
        case Button::kUndo:
            turn.add(effect::Undo{});
            break;
        case Button::kTools:
            throwing.tray = !throwing.tray;
            break;
        case Button::kTakeTool:
            if (event.value < 0 || event.value >= static_cast<int>(kTray.size())) break;
            throwing.held = kTray[static_cast<std::size_t>(event.value)].tool;
            throwing.tray = false;
            break;
        case Button::kCut:
            if (throwing.held != tool::Tool::kWire) break;
            throwing.held = tool::Tool::kHand;  // after one cut the wire is put back
            turn.add(effect::CutRim{});
            break;
        case Button::kToolLess:
        case Button::kToolMore:
            change(throwing.tool, event.button == Button::kToolMore ? 1 : -1, kMostTool);
            break;
        case Button::kWaterLess:
        case Button::kWaterMore:
            change(throwing.water, event.button == Button::kWaterMore ? 1 : -1, kMostWater);
            break;
        case Button::kSpeedLess:
        case Button::kSpeedMore:
            change(throwing.speed, event.button == Button::kSpeedMore ? 1 : -1, kMostSpeed);
            break;
        case Button::kLookIn:
            throwing.looks_in = !throwing.looks_in;
            break;
        case Button::kDone:
            throwing.asks = asked == DoneQuestion::kNone ? question_of(turn.state) : DoneQuestion::kNone;
            if (throwing.asks == DoneQuestion::kNone) finish_throwing(turn);
            if (throwing.asks == DoneQuestion::kThick) throwing.asked_mm = turn.state.thick_mm;
            break;
        default:
            if (moves_hand(event.button)) turn.add(effect::MoveHand{event.button});
            break;
    }
}

void touch_clay(Turn& turn, bool goes_on) {
    State& state = turn.state;
    end_show(turn);
    end_aside(turn);
    state.throwing.asks = DoneQuestion::kNone;
    // Work by guided hands that a key started some time ago does not close cards opened since.
    if (!goes_on) state.throwing.tray = state.throwing.jar.is_low = state.throwing.jar.rims_apart = false;
    state.throwing.jar.touched = state.throwing.jar.step != JarStep::kNone;
    const bool rested = !state.pace.held && turn.now_s - state.pace.touched_s >= turn.rules.show_rests_s;
    if (rested || state.pace.touched_s < 0.0) state.pace.works_s = turn.now_s;
    state.pace.touched_s = turn.now_s;
    state.pace.seen_since_touch.reset();
}

// Handles the events of throwing; other events may be the jar's.
struct ThrowTaking {
    Turn& turn;
    const Event& event;
    Throwing& throwing = turn.state.throwing;

    void operator()(const event::Input& input) {
        if (input.by_key) end_show(turn);
    }
    void operator()(const event::ClayTouched& touched) { touch_clay(turn, touched.goes_on); }
    void operator()(const event::ShowOver& /*over*/) { end_show(turn); }
    void operator()(const event::Soaked& /*soaked*/) { throwing.water = std::max(1, throwing.water - 1); }
    void operator()(const event::Progress& progress) {
        if (std::exchange(turn.state.was_cut_off, false)) return finish_throwing(turn);
        throwing.is_solid = progress.is_solid;
        turn.state.thick_mm = progress.thick_mm;
        if (progress.steps_done <= throwing.steps_done) return;
        throwing.steps_done = std::min(progress.steps_done, kTeachingSteps);
        turn.state.pace.progress_s = turn.now_s;
    }
    void operator()(const event::Warned& warned) { throwing.warning = warned.warning; }
    void operator()(const event::Collapsed& collapsed) {
        if (turn.state.panel == Panel::kLanguage) turn.lay_over(Panel::kNone);
        throwing.collapse = collapsed.cause;
        turn.show(Screen::kFailure);
    }
    template <typename Other>
    void operator()(const Other& /*other*/) {
        take_jar(turn, event);
    }
};

void take_throw(Turn& turn, const Event& event) {
    std::visit(ThrowTaking{turn, event}, event);
}

void pass_throw(Turn& turn) {
    if (turn.state.panel != Panel::kNone) return;
    pass_aside(turn);
    pass_show(turn);
}

std::string_view warning_key(Warning warning) {
    switch (warning) {
        case Warning::kThin:
            return "warn.thin";
        case Warning::kWet:
            return "warn.wet";
        case Warning::kFast:
            return "warn.fast";
        case Warning::kNone:
            break;
    }
    return {};
}

std::string_view spoken_while_throwing(const State& state) {
    if (state.device_lost) return "dev.lost";
    if (state.throwing.warning != Warning::kNone) return warning_key(state.throwing.warning);
    if (state.throwing.shown) return "show.on";
    if (state.throwing.tray) return "tool.title";
    if (state.throwing.asks != DoneQuestion::kNone) return question_key(state.throwing.asks);
    if (state.throwing.jar.is_low) return "moon.low";
    if (state.throwing.jar.rims_apart) return "moon.more";
    if (state.throwing.jar.step == JarStep::kAside) return "moon.s2";
    if (state.throwing.jar.step == JarStep::kSeam) return "moon.s5";
    if (state.throwing.jar.step != JarStep::kNone && state.throwing.steps_done == 0)
        return state.throwing.jar.step == JarStep::kFirstBowl ? "moon.s1" : "moon.s3";
    if (state.throwing.held != tool::Tool::kHand) return tray_tool(state.throwing.held).held_key;
    constexpr std::array<std::string_view, kTeachingSteps + 1> kSteps{"step.press", "step.open", "step.raise",
                                                                      "step.own"};
    return kSteps[static_cast<std::size_t>(state.throwing.steps_done)];
}

// Adds the progress of the lesson and the clay's height, then the held tool, the tray, a demonstration.
std::string title_of_throwing(const TitleFacts& facts) {
    const Throwing& throwing = facts.shown.throwing;
    std::string title =
        fmt::format(" - {} of {}, {:.0f} mm", throwing.steps_done, kTeachingSteps, facts.clay_mm);
    for (const std::string_view more :
         {tray_tool(throwing.held).title, std::string_view(throwing.tray ? "tools" : ""),
          std::string_view(throwing.shown ? "shown" : ""),
          std::string_view(throwing.asks != DoneQuestion::kNone ? "asks" : "")})
        if (!more.empty()) title += ", " + std::string(more);
    return title;
}

}  // namespace

void finish_throwing(Turn& turn) {
    turn.state.throwing.held = tool::Tool::kHand;
    turn.state.throwing.tray = false;
    // A bowl that is cut off before the joining is an ordinary pot.
    if (turn.state.throwing.jar.step != JarStep::kSeam) turn.state.throwing.jar = {};
    turn.add(effect::CutOff{});
    turn.state.firing = FiringStage::kCut;
    turn.state.trimming = {};
    turn.state.throwing.warning = Warning::kNone;
    turn.show(Screen::kFiring);
}

bool shows_hint(const State& state, double now_s, const Rules& rules) {
    if (open_finger(state) != Finger::kClay) return false;
    const Throwing& throwing = state.throwing;
    if (throwing.steps_done >= kTeachingSteps || throwing.shown || state.pace.held) return false;
    if (state.pace.touched_s < 0.0) return true;
    return now_s - std::max(state.pace.progress_s, state.pace.touched_s) >= rules.hint_again_s;
}

extern constinit const Step kThrowStep{.screen = Screen::kThrow,
                                       .name = "throw",
                                       .leave = end_show,
                                       .press = press_throw,
                                       .take = take_throw,
                                       .tick = pass_throw,
                                       .draw = draw_throw,
                                       .spoken = spoken_while_throwing,
                                       .title = title_of_throwing,
                                       .camera = Camera::kThrowing,
                                       .shows_scene = true,
                                       .finger = Finger::kClay,
                                       .turns_wheel = true,
                                       .has_wet_clay = true};

}  // namespace onggi::visit
