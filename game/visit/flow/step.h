// What a step of a visit is: one screen, with what can be done there and what it looks like. Each step fills
// in a Step in its own folder; steps.cpp lists them all. Any thread; draw() on the composer's.
#pragma once

#include <string>
#include <string_view>

#include "game/kiosk/events.h"
#include "game/screens/page/page.h"

namespace onggi::visit {

using namespace kiosk;    // the words of a visit: its state, its buttons, events and effects
using namespace screens;  // and of what it shows
using screens::Words;

struct Turn;

// Whom the screen is for.
enum class Whose { kNobody, kVisitor, kStaff };

// What a finger or the hand's keys work on.
enum class Finger {
    kNone,
    kLooks,  // the hand follows and touches nothing
    kClay,
    kFoot,   // of the pot that stands on its rim
    kBrush,  // the dry pot
    kBowl,   // keys alone move the upper bowl
};

// How the camera frames the wheel.
enum class Camera {
    kFar,
    kAttract,   // beside the words
    kThrowing,  // leaves the hands room; low, if the visitor asked for it
    kNear,      // a brush is small; but as kThrowing where controls are low
};

// What the title of the window adds for scripts that play a visitor.
struct TitleFacts {
    const ScreenState& shown;
    const ScreenState& now;
    double clay_mm = 0.0;  // its height
};

// A function that a step does without is null.
struct Step {
    Screen screen = Screen::kAttract;
    std::string_view name{};  // one word, for titles and logs
    Whose whose = Whose::kVisitor;
    // The flow, pure. leave() is called also where a panel is laid over the screen.
    void (*enter)(Turn& turn) = nullptr;
    void (*leave)(Turn& turn) = nullptr;
    void (*press)(Turn& turn, const event::Pressed& pressed) = nullptr;  // null: nothing can be pressed
    void (*take)(Turn& turn, const Event& event) = nullptr;              // what is not every screen's
    void (*tick)(Turn& turn) = nullptr;
    // What is seen and heard; spoken() returns the key of a line.
    void (*draw)(Page& page) = nullptr;
    std::string_view (*spoken)(const State& state) = nullptr;
    std::string (*title)(const TitleFacts& facts) = nullptr;
    Camera camera = Camera::kFar;
    bool shows_scene = false;  // else the screen covers it
    // The wheel under it.
    Finger finger = Finger::kNone;
    bool turns_wheel = false;
    bool has_wet_clay = false;  // the visitor's, not cut off yet
};

// What lies over a screen, and takes its buttons and its time.
struct Overlay {
    Panel panel = Panel::kNone;
    std::string_view name{};
    std::string_view spoken{};  // key of its line; empty: silence
    void (*press)(Turn& turn, const event::Pressed& pressed) = nullptr;
    void (*tick)(Turn& turn) = nullptr;  // null: the screen's time goes on
    void (*draw)(Page& page) = nullptr;
    bool is_staffs = false;
};

[[nodiscard]] const Step& step_of(Screen screen);
[[nodiscard]] const Overlay& overlay_of(Panel panel);  // of kNone: no function at all

// What the finger works on now: nothing under a panel.
[[nodiscard]] inline Finger open_finger(const ScreenState& state) {
    return state.panel == Panel::kNone ? step_of(state.screen).finger : Finger::kNone;
}

}  // namespace onggi::visit
