// Reads each finger on a window separately; the X server's pointer follows the first finger only
// (findings/x-pointer-is-deaf-to-every-finger-but-the-first.sh). X11 with XInput 2.2, including Xwayland.
// Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/window/events.h"

struct xcb_connection_t;

namespace onggi::window {

// A touch event of one finger.
struct Touch {
    enum class Phase { kBegin, kMove, kEnd };
    Phase phase = Phase::kBegin;
    std::uint32_t finger = 0;  // constant from its beginning to its end
    double x_px = 0.0;
    double y_px = 0.0;
    std::uint32_t time_ms = 0;  // of the display server; wraps to 0 after 49 days
};

// Selects the one finger that acts as the pointer. A second finger is ignored while the first one moves. If
// the first lies still, such as a palm or a sleeve on the panel's edge, or has not been lifted for minutes,
// such as a wet spot, the next finger replaces it. A replaced or ignored finger stays ignored until it
// is lifted. Any thread; no clock.
class LeadingFinger {
  public:
    // Appends to `events` what a pointer with one button would have sent.
    void follow(const Touch& touch, std::vector<Event>& events);

  private:
    void begin(const Touch& touch, std::vector<Event>& events);
    void move(const Touch& touch, std::vector<Event>& events);

    std::optional<std::uint32_t> finger_;
    Touch still_{};  // its last position that counted as motion, and when
    std::uint32_t began_ms_ = 0;
};

// Whether the window shows the pointer's arrow: only while a mouse moves. Ignores jumps, because a display
// server places the pointer at the start and after a reconnection, and small movements of a mouse that was
// jolted. Time in s, of any clock that does not go back; places in px.
class PointerArrow {
  public:
    explicit PointerArrow(bool is_shown) : is_shown_(is_shown) {}

    void moved(double x_px, double y_px, double now_s);
    void touched() { is_shown_ = false; }
    // Hides it once it has been still for a while.
    [[nodiscard]] bool is_shown(double now_s);

  private:
    bool is_shown_;
    int moves_ = 0;  // of the movement that began at from_*
    double from_x_px_ = 0.0;
    double from_y_px_ = 0.0;
    double moved_s_ = 0.0;
};

class TouchScreen {
  public:
    // Subscribes to the touches of this window on the server in DISPLAY; they no longer move the pointer.
    // Null if the server has no touches or another client has taken them; then touches move the pointer.
    static std::unique_ptr<TouchScreen> of(std::uint32_t window);
    ~TouchScreen();
    TouchScreen(const TouchScreen&) = delete;
    TouchScreen& operator=(const TouchScreen&) = delete;

    // Returns the touches since the last call, in the window's own units.
    [[nodiscard]] std::vector<Touch> poll();

  private:
    explicit TouchScreen(xcb_connection_t* server) : server_(server) {}
    [[nodiscard]] bool take(std::uint32_t window);

    xcb_connection_t* server_;
    std::uint8_t xinput_ = 0;  // the extension's number in events
};

}  // namespace onggi::window
