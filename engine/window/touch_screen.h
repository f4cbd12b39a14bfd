// Reads each finger on a window separately; the X server's pointer follows the first finger only
// (findings/x-pointer-is-deaf-to-every-finger-but-the-first.sh). X11 with XInput 2.2, including Xwayland.
// Main thread.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/window/events.h"
#include "engine/window/input_server.h"

namespace onggi::window {

// A touch event of one finger.
struct Touch {
    using Phase = TouchPhase;
    Phase phase = Phase::kBegin;
    std::uint32_t finger = 0;  // constant from its beginning to its end
    double x_px = 0.0;
    double y_px = 0.0;
    std::uint32_t time_ms = 0;  // of the display server; wraps to 0 after 49 days
};

// Selects the finger that acts as the pointer, and a second one. Others are ignored. If one of the two lies
// still, such as a palm or a sleeve on the panel's edge, and holds nothing, or has not been lifted for
// minutes, such as a wet spot, the next finger replaces it. A replaced or ignored finger stays ignored until
// it is lifted. If the first lifts, the second remains the second. Any thread; no clock.
class LeadingFinger {
  public:
    // Appends to `events` what a pointer with one button, and a second finger, would have sent.
    void follow(const Touch& touch, std::vector<Event>& events);
    // See Window::keep_fingers().
    void keep(bool first, bool second) { keeps_ = {first, second}; }

  private:
    struct Finger {
        std::uint32_t id = 0;
        Touch still{};  // its last position that counted as motion, and when
        std::uint32_t began_ms = 0;
    };
    void begin(const Touch& touch, std::vector<Event>& events);
    // Whether the next finger may have the place of that one.
    [[nodiscard]] bool is_free(int which, std::uint32_t now_ms) const;

    std::array<std::optional<Finger>, 2> fingers_;  // the pointer, the second
    std::array<bool, 2> keeps_{};
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

    // Returns the touches since the last call, in the window's own units.
    [[nodiscard]] std::vector<Touch> poll();

  private:
    explicit TouchScreen(std::unique_ptr<InputServer> server) : server_(std::move(server)) {}

    std::unique_ptr<InputServer> server_;
};

}  // namespace onggi::window
