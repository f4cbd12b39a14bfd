// The fingers on a window, each by itself: what the X server makes a pointer of is the first of them alone.
// X11 with XInput 2.2, Xwayland too. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/window/leading_finger.h"

struct xcb_connection_t;

namespace onggi::window {

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
