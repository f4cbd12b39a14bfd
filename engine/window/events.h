// Window events as plain data. Any thread. Pixels count from the top left corner, y down, in framebuffer
// pixels (not the desktop's scaled units).
#pragma once

#include <variant>

#include "engine/math/math.h"

namespace onggi::window {

enum class Key {
    kUnknown,
    kEscape,
    kSpace,
    kEnter,
    kLeftBracket,
    kRightBracket,
    kPlus,
    kMinus,
    kUp,
    kDown,
    k1,
    k2,
    k3,
    k4,
    kC,
    kE,
    kF,
    kQ,
    kR,
    kS,
    kT,
    kU,
    kV,
    kW,
    kX,
    kF1,
    kF11,
    kTab,
    kLeft,
    kRight,
    kBackspace,
    kPause,
};
enum class MouseButton { kLeft, kRight, kMiddle };

struct KeyEvent {
    Key key = Key::kUnknown;
    bool pressed = false;  // a held key repeats as pressed
    bool repeat = false;
};
struct ButtonEvent {
    MouseButton button = MouseButton::kLeft;
    bool pressed = false;
};
struct PointerEvent {
    double x_px = 0.0;
    double y_px = 0.0;
};
struct ScrollEvent {
    double steps = 0.0;  // positive: away from the person
};
struct ResizeEvent {
    int width = 0;  // both 0 while minimised
    int height = 0;
};
struct CloseEvent {};
// Whether the window has the input focus. A key or button released without focus sends no event.
struct FocusEvent {
    bool focused = false;
};
enum class TouchPhase { kBegin, kMove, kEnd };
// A second finger on a touch screen, while another one is the pointer. It may stay after that one has lifted.
struct SecondFingerEvent {
    TouchPhase phase = TouchPhase::kBegin;
    double x_px = 0.0;
    double y_px = 0.0;
};

using Event = std::variant<KeyEvent, ButtonEvent, PointerEvent, ScrollEvent, ResizeEvent, CloseEvent,
                           FocusEvent, SecondFingerEvent>;

// A pen that moves the pointer.
struct Pen {
    double pressure = 0.0;  // 0 to 1 of its range
    dvec2 tilt_rad{0.0};    // of its upper end from upright: to the right, and towards the person
};

}  // namespace onggi::window
