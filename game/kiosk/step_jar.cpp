// A jar of two bowls, made as moon jars are: throw a bowl and set it aside, throw the second bowl, put the
// first upside down on the second, close the seam. Undo works across the steps, and a collapse loses one bowl
// at most.
#include <algorithm>
#include <utility>

#include "game/kiosk/step_screens.h"

namespace onggi::kiosk {
namespace {

bool is_with_clay(const State& state) {
    return state.screen == Screen::kThrow || state.screen == Screen::kJoin;
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
    turn.add(Effect::Kind::kFreshClay, *throwing.target);
}

void ask(Turn& turn, Effect::Kind kind, int value = 0) {
    JarMaking& jar = turn.state.throwing.jar;
    if (jar.waits) return;
    jar.waits = true;
    turn.add(kind, value);
}

void end_bowl(Turn& turn, Effect::Kind with) {
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
            turn.add(Effect::Kind::kTakeBack, 1);
            turn.state.throwing.steps_done = kTeachingSteps;
            go_to(turn, JarStep::kFirstBowl);
            break;
        case JarStep::kSeam:
            turn.add(Effect::Kind::kTakeBack, 2);
            turn.state.throwing.held = tool::Tool::kHand;
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

void press_jar_start(Turn& turn, const Event& event) {
    if (event.button == Button::kBack) {
        turn.show(Screen::kChoose);
    } else if (event.button == Button::kBegin) {
        turn.show(Screen::kThrow);
        turn.put_on_clay(turn.state.throwing.target);
        turn.state.throwing.jar.step = JarStep::kFirstBowl;
        turn.add(Effect::Kind::kBeginJar, *turn.state.throwing.target);
    }
}

void resume_jar(Turn& turn) {
    const int interrupted = std::exchange(turn.state.interrupted_jar, 0);
    const int target = interrupted / kInterruptedJarStride - 1;
    const auto step = static_cast<JarStep>(interrupted % kInterruptedJarStride);
    const std::vector<int>& jars = turn.rules.jars;
    const bool is_step =
        step == JarStep::kFirstBowl || step == JarStep::kSecondBowl || step == JarStep::kSeam;
    if (!is_step || std::find(jars.begin(), jars.end(), target) == jars.end()) return;
    turn.state.throwing.target = target;
    turn.state.throwing.jar.step = step;
    if (step != JarStep::kSeam) return;
    turn.state.throwing.steps_done = kTeachingSteps;
    turn.state.throwing.held = tool::Tool::kRib;
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

bool press_jar(Turn& turn, const Event& event) {
    const JarMaking& jar = turn.state.throwing.jar;
    const bool is_over = event.button == Button::kDone;
    switch (jar.step) {
        case JarStep::kFirstBowl:
            if (is_over) end_bowl(turn, Effect::Kind::kSetAside);
            return is_over;
        case JarStep::kAside:
            if (event.button == Button::kUndo) {
                step_back(turn);
                return true;
            }
            end_aside(turn);
            return is_over;
        case JarStep::kSecondBowl:
            if (is_over) end_bowl(turn, Effect::Kind::kHoldTogether);
            return is_over;
        case JarStep::kNone:
        case JarStep::kJoin:
        case JarStep::kSeam:
            return false;
    }
    return false;
}

void press_join(Turn& turn, const Event& event) {
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
            ask(turn, Effect::Kind::kJoinBowls, jar.shift_mm);
            break;
        default:
            break;
    }
}

void take_jar(Turn& turn, const Event& event) {
    State& state = turn.state;
    JarMaking& jar = state.throwing.jar;
    if (jar.step == JarStep::kNone || !is_with_clay(state)) return;
    switch (event.kind) {
        case Event::Kind::kBowl:
            jar.is_bowl = event.value == 1;
            break;
        case Event::Kind::kSetAside:
            if (jar.step != JarStep::kFirstBowl) break;
            put_on_bowl_clay(turn, JarStep::kAside);
            break;
        case Event::Kind::kRims:
            if (jar.step != JarStep::kSecondBowl) break;
            go_to(turn, JarStep::kJoin);
            jar.rims_mm = event.value;
            break;
        case Event::Kind::kRimsApart:
            if (jar.step != JarStep::kSecondBowl) break;
            jar.waits = false;
            jar.rims_apart = true;
            break;
        case Event::Kind::kJoined:
            if (jar.step != JarStep::kJoin) break;
            go_to(turn, JarStep::kSeam);
            state.throwing.steps_done = kTeachingSteps;
            state.throwing.held = tool::Tool::kRib;
            break;
        case Event::Kind::kJarStays:
            jar.waits = false;
            break;
        case Event::Kind::kUndoneAll:
            if (state.screen == Screen::kThrow) step_back(turn);
            break;
        default:
            break;
    }
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
