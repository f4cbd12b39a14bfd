// A connection to the X server in DISPLAY for input that GLFW drops (XInput 2.2): fingers one by one, and the
// axes of pens. Main thread. Protocol: https://www.x.org/releases/X11R7.7/doc/inputproto/XI2proto.txt
#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>

struct xcb_connection_t;
struct xcb_ge_generic_event_t;

namespace onggi::window {

class InputServer {
  public:
    struct Freed {
        void operator()(void* answer) const { std::free(answer); }
    };
    template <typename T>
    using Answer = std::unique_ptr<T, Freed>;

    // Null without such a server.
    static std::unique_ptr<InputServer> connect();
    ~InputServer();
    InputServer(const InputServer&) = delete;
    InputServer& operator=(const InputServer&) = delete;

    // Subscribes to events of a device, or of all, on a window. Returns false if the server refuses, because
    // another client has them.
    [[nodiscard]] bool select(std::uint32_t window, std::uint16_t device, std::uint32_t mask);
    // The next event of the extension, or null. Never blocks.
    [[nodiscard]] Answer<xcb_ge_generic_event_t> next_event();
    [[nodiscard]] xcb_connection_t* connection() const { return connection_; }

  private:
    explicit InputServer(xcb_connection_t* connection) : connection_(connection) {}

    xcb_connection_t* connection_;
    std::uint8_t extension_ = 0;  // its number in events
};

}  // namespace onggi::window
