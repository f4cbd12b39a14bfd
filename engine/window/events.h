// Window events as plain data. Any thread. Pixels count from the top left corner, y down, in framebuffer
// pixels (not the desktop's scaled units).
#pragma once

#include <variant>

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

using Event =
    std::variant<KeyEvent, ButtonEvent, PointerEvent, ScrollEvent, ResizeEvent, CloseEvent, FocusEvent>;

}  // namespace onggi::window
