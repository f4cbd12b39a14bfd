// The fingers on a window, each by itself: what the X server makes a pointer of is the first of them alone.
// X11 with XInput 2.2, Xwayland too. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/window/events.h"

struct xcb_connection_t;

namespace onggi::window {

// Which of the fingers on a touch screen is the hand. Any thread; no clock of its own.
struct Touch {
    enum class Phase { kBegin, kMove, kEnd };
    Phase phase = Phase::kBegin;
    std::uint32_t finger = 0;  // the same from its beginning to its end
    double x_px = 0.0;
    double y_px = 0.0;
    std::uint32_t time_ms = 0;  // of the display server; begins again at 0 after 49 days
};

// One finger throws. A second one changes nothing while the first is at work; but a first that lies still, a
// palm on the panel's edge or a sleeve, keeps nobody else from the wheel: it is nobody as soon as another
// comes. Who is nobody stays so until lifted.
class LeadingFinger {
  public:
    // What a pointer with one button would have done, into `events`.
    void follow(const Touch& touch, std::vector<Event>& events);

  private:
    void begin(const Touch& touch, std::vector<Event>& events);
    void move(const Touch& touch, std::vector<Event>& events);

    std::optional<std::uint32_t> finger_;
    Touch still_{};  // where it has been since when
};

// Whether the window shows the pointer's arrow: while somebody moves a mouse. A jump is nobody's movement, for a display
// server puts the pointer somewhere at the start and after a reconnection; nor is a jolt that shakes a mouse a little. Time in
// s, of any clock that does not go back; places in px.
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
    // Takes the touches of this window of the server that DISPLAY names: no pointer moves for them any more.
    // Null where the server knows no touches, or somebody else has taken them; they are a pointer's then.
    static std::unique_ptr<TouchScreen> of(std::uint32_t window);
    ~TouchScreen();
    TouchScreen(const TouchScreen&) = delete;
    TouchScreen& operator=(const TouchScreen&) = delete;

    // Since the last call; in the window's own units.
    [[nodiscard]] std::vector<Touch> poll();

  private:
    explicit TouchScreen(xcb_connection_t* server) : server_(server) {}
    [[nodiscard]] bool take(std::uint32_t window);

    xcb_connection_t* server_;
    std::uint8_t xinput_ = 0;  // the extension's number in events
};

}  // namespace onggi::window
