// A jar of two bowls, made as moon jars are: throw a bowl and set it aside, throw the second bowl, put the
// first upside down on the second, close the seam. Undo works across the steps, and a collapse loses one bowl
// at most.
#include <algorithm>
#include <utility>

#include "game/kiosk/step_screens.h"

namespace onggi::kiosk {
namespace {

// The jar in the making, if its clay is before the visitor, at this step or at any; else null.
JarMaking* jar_at_work(Turn& turn, std::optional<JarStep> step = std::nullopt) {
    State& state = turn.state;
    JarMaking& jar = state.throwing.jar;
    const bool is_with_clay = state.screen == Screen::kThrow || state.screen == Screen::kJoin;
    const bool is_there = jar.step != JarStep::kNone && is_with_clay && jar.step == step.value_or(jar.step);
    return is_there ? &jar : nullptr;
}

// Goes to the step with the clay that is on the wheel.
void go_to(Turn& turn, JarStep step) {
    JarMaking& jar = turn.state.throwing.jar;
    jar = {.step = step, .is_bowl = jar.is_bowl};
    turn.state.throwing.tray = false;
    turn.state.pace = {.progress_s = turn.now_s};
    turn.show(step == JarStep::kJoin ? Screen::kJoin : Screen::kThrow);
}

// Water, speed and tool size stay as the visitor chose them.
void put_on_bowl_clay(Turn& turn, JarStep step) {
    Throwing& throwing = turn.state.throwing;
    throwing = {.target = throwing.target,
                .tool = throwing.tool,
                .water = throwing.water,
                .speed = throwing.speed,
                .jar = {.step = step}};
    turn.state.pace = {.progress_s = turn.now_s};
    turn.add(effect::FreshClay{throwing.target});
}

void ask(Turn& turn, const Effect& effect) {
    JarMaking& jar = turn.state.throwing.jar;
    if (jar.waits) return;
    jar.waits = true;
    turn.add(effect);
}

void end_bowl(Turn& turn, const Effect& with) {
    JarMaking& jar = turn.state.throwing.jar;
    jar.is_low = !jar.is_bowl;
    if (jar.is_bowl) ask(turn, with);
}

// Undoes the start of the current step: the clay is as it was at the end of the step before.
void step_back(Turn& turn) {
    turn.state.throwing.jar.is_bowl = false;  // until the bowl is back on the wheel
    switch (turn.state.throwing.jar.step) {
        case JarStep::kAside:
        case JarStep::kSecondBowl:
            turn.add(effect::TakeBack{.bowl = 1});
            turn.state.throwing.steps_done = kTeachingSteps;
            go_to(turn, JarStep::kFirstBowl);
            break;
        case JarStep::kSeam:
            turn.add(effect::TakeBack{.bowl = 2});
            turn.state.throwing.held = Held::kHand;
            go_to(turn, JarStep::kSecondBowl);
            break;
        case JarStep::kNone:
        case JarStep::kFirstBowl:
        case JarStep::kJoin:
            break;
    }
}

}  // namespace

void begin_jar(Turn& turn, int target) {
    turn.state.throwing = {.target = target};
    turn.show(Screen::kJarStart);
}

void press_jar_start(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kBack) {
        turn.show(Screen::kChoose);
    } else if (event.button == Button::kBegin) {
        turn.show(Screen::kThrow);
        turn.put_on_clay(turn.state.throwing.target);
        turn.state.throwing.jar.step = JarStep::kFirstBowl;
        turn.add(effect::BeginJar{*turn.state.throwing.target});
    }
}

void resume_jar(Turn& turn) {
    const auto [step, target] =
        std::exchange(turn.state.interrupted_jar, std::nullopt).value_or(InterruptedJar{});
    const std::vector<int>& jars = turn.rules.jars;
    const bool is_step =
        step == JarStep::kFirstBowl || step == JarStep::kSecondBowl || step == JarStep::kSeam;
    if (!is_step || std::find(jars.begin(), jars.end(), target) == jars.end()) return;
    turn.state.throwing.target = target;
    turn.state.throwing.jar.step = step;
    if (step != JarStep::kSeam) return;
    turn.state.throwing.steps_done = kTeachingSteps;
    turn.state.throwing.held = Held::kRib;
}

void put_on_new_clay(Turn& turn) {
    const Throwing& throwing = turn.state.throwing;
    switch (throwing.jar.step) {
        case JarStep::kNone:
        case JarStep::kJoin:
            return turn.put_on_clay(throwing.target);
        case JarStep::kFirstBowl:
            return put_on_bowl_clay(turn, JarStep::kFirstBowl);
        case JarStep::kAside:
        case JarStep::kSecondBowl:
        case JarStep::kSeam:
            return put_on_bowl_clay(turn, JarStep::kSecondBowl);
    }
}

bool press_jar(Turn& turn, const event::Pressed& event) {
    const JarMaking& jar = turn.state.throwing.jar;
    const bool is_over = event.button == Button::kDone;
    switch (jar.step) {
        case JarStep::kFirstBowl:
            if (is_over) end_bowl(turn, effect::SetAside{});
            return is_over;
        case JarStep::kAside:
            if (event.button == Button::kUndo) {
                step_back(turn);
                return true;
            }
            end_aside(turn);
            return is_over;
        case JarStep::kSecondBowl:
            if (is_over) end_bowl(turn, effect::HoldTogether{});
            return is_over;
        case JarStep::kNone:
        case JarStep::kJoin:
        case JarStep::kSeam:
            return false;
    }
    return false;
}

void press_join(Turn& turn, const event::Pressed& event) {
    JarMaking& jar = turn.state.throwing.jar;
    if (jar.waits) return;
    switch (event.button) {
        case Button::kUndo:
        case Button::kBack:
            go_to(turn, JarStep::kSecondBowl);
            break;
        case Button::kHandLeft:
        case Button::kHandRight:
            jar.shift_mm = std::clamp(jar.shift_mm + (event.button == Button::kHandRight ? 1 : -1),
                                      -kMostShiftMm, kMostShiftMm);
            break;
        case Button::kHandDown:
        case Button::kJoinBowls:
            ask(turn, effect::JoinBowls{jar.shift_mm});
            break;
        default:
            break;
    }
}

void take_jar(Turn& turn, const event::Bowl& bowl) {
    if (JarMaking* const jar = jar_at_work(turn)) jar->is_bowl = bowl.is_bowl;
}

void take_jar(Turn& turn, const event::SetAside& /*event*/) {
    if (jar_at_work(turn, JarStep::kFirstBowl) != nullptr) put_on_bowl_clay(turn, JarStep::kAside);
}

void take_jar(Turn& turn, const event::Rims& rims) {
    JarMaking* const jar = jar_at_work(turn, JarStep::kSecondBowl);
    if (jar == nullptr) return;
    go_to(turn, JarStep::kJoin);
    jar->rims_mm = rims.apart_mm;
}

void take_jar(Turn& turn, const event::RimsApart& /*event*/) {
    JarMaking* const jar = jar_at_work(turn, JarStep::kSecondBowl);
    if (jar == nullptr) return;
    jar->waits = false;
    jar->rims_apart = true;
}

void take_jar(Turn& turn, const event::Joined& /*event*/) {
    if (jar_at_work(turn, JarStep::kJoin) == nullptr) return;
    go_to(turn, JarStep::kSeam);
    turn.state.throwing.steps_done = kTeachingSteps;
    turn.state.throwing.held = Held::kRib;
}

void take_jar(Turn& turn, const event::JarStays& /*event*/) {
    if (JarMaking* const jar = jar_at_work(turn)) jar->waits = false;
}

void take_jar(Turn& turn, const event::UndoneAll& /*event*/) {
    if (jar_at_work(turn) != nullptr && turn.state.screen == Screen::kThrow) step_back(turn);
}

void pass_aside(Turn& turn) {
    const State& state = turn.state;
    if (state.throwing.jar.step == JarStep::kAside &&
        turn.now_s - state.pace.progress_s >= turn.rules.aside_s)
        end_aside(turn);
}

void end_aside(Turn& turn) {
    if (turn.state.throwing.jar.step == JarStep::kAside) turn.state.throwing.jar.step = JarStep::kSecondBowl;
}

}  // namespace onggi::kiosk
