// Defines a step of a visit: one screen, its controls and its looks. Each step fills in a Step in its own
// folder; steps.cpp lists them all. Any thread; draw() runs on the composer's.
#pragma once

#include <string>
#include <string_view>

#include "game/kiosk/events.h"
#include "game/screens/page/page.h"

namespace onggi::visit {

using namespace kiosk;    // state, buttons, events and effects of a visit
using namespace screens;  // pages and the parts of screens
using screens::Words;

struct Turn;

// The audience of a screen: kNobody for attract, kStaff for the fault screen.
enum class Whose { kNobody, kVisitor, kStaff };

// The object that a finger or the hand's keys act on.
enum class Finger {
    kNone,
    kLooks,  // the hand follows the finger but touches nothing
    kClay,
    kFoot,   // of the pot standing on its rim
    kBrush,  // on the dry pot
    kBowl,   // only keys move the upper bowl
};

// How the camera frames the wheel.
enum class Camera {
    kFar,
    kAttract,   // beside the text
    kThrowing,  // leaves room for the hands; low if the visitor prefers low controls
    kNear,      // close, because a brush is small; as kThrowing with low controls
};

// Input of Step::title, which adds to the window's title for scripts that play a visitor.
struct TitleFacts {
    const ScreenState& shown;
    const ScreenState& now;
    double clay_mm = 0.0;  // height of the clay
};

// The functions are optional: null if a step does not need one.
struct Step {
    Screen screen = Screen::kAttract;
    std::string_view name{};  // one word, for titles and logs
    Whose whose = Whose::kVisitor;
    // The flow, pure. leave() is also called when a panel opens over the screen.
    void (*enter)(Turn& turn) = nullptr;
    void (*leave)(Turn& turn) = nullptr;
    void (*press)(Turn& turn, const event::Pressed& pressed) = nullptr;  // null: no buttons
    // the events that Taking (flow.cpp) does not handle
    void (*take)(Turn& turn, const Event& event) = nullptr;
    void (*tick)(Turn& turn) = nullptr;
    // Whether the program works for a visitor who can only wait; meanwhile the idle timeout stands still.
    bool (*works)(const State& state) = nullptr;
    // Picture and speech. spoken() returns the key of a line.
    void (*draw)(Page& page) = nullptr;
    std::string_view (*spoken)(const State& state) = nullptr;
    std::string (*title)(const TitleFacts& facts) = nullptr;
    Camera camera = Camera::kFar;
    bool shows_scene = false;  // false: the page covers the scene
    // The wheel during this step.
    Finger finger = Finger::kNone;
    bool turns_wheel = false;
    bool has_wet_clay = false;  // the visitor's clay is not cut off yet
};

// A panel over a screen; receives the screen's button presses and ticks.
struct Overlay {
    Panel panel = Panel::kNone;
    std::string_view name{};
    std::string_view spoken{};  // key of its spoken line; empty: silence
    void (*press)(Turn& turn, const event::Pressed& pressed) = nullptr;
    void (*tick)(Turn& turn) = nullptr;  // null: the screen's tick runs instead
    void (*draw)(Page& page) = nullptr;
    bool is_staffs = false;
};

[[nodiscard]] const Step& step_of(Screen screen);
[[nodiscard]] const Overlay& overlay_of(Panel panel);  // kNone: all functions are null

// The object that the finger acts on now; none while a panel is open.
[[nodiscard]] inline Finger open_finger(const ScreenState& state) {
    return state.panel == Panel::kNone ? step_of(state.screen).finger : Finger::kNone;
}
// The finger is a hand at the clay, upright or upside down, and so are the arrow keys.
[[nodiscard]] inline bool finger_is_hand(const ScreenState& state) {
    return open_finger(state) == Finger::kClay || open_finger(state) == Finger::kFoot;
}

}  // namespace onggi::visit
