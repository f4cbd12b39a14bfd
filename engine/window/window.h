// A window, and its peer for machines without a display. Main thread only. Pixels are those of the
// framebuffer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/vulkan.h"
#include "engine/window/events.h"
#include "engine/window/gamepad.h"

namespace onggi::window {

struct WindowDesc {
    int width = 1280;
    int height = 720;
    std::string title;
    bool full_screen = false;  // on the primary monitor, at its own size
};

struct Size {
    int width = 0;
    int height = 0;
};

class Window {
  public:
    virtual ~Window() = default;

    // What a Vulkan instance needs so that create_surface can work; empty: nothing is presented.
    [[nodiscard]] virtual std::vector<std::string> instance_extensions() const = 0;
    // VK_NULL_HANDLE for a window that nobody sees. The caller destroys it.
    virtual Result<VkSurfaceKHR> create_surface(VkInstance instance) = 0;

    // Oldest first, since the last call. Never blocks.
    [[nodiscard]] virtual std::vector<Event> poll_events() = 0;
    // Those that are plugged in and whose buttons are known, as poll_events() found them.
    [[nodiscard]] virtual std::vector<Gamepad> gamepads() const = 0;
    [[nodiscard]] virtual bool close_requested() const = 0;
    [[nodiscard]] virtual Size size() const = 0;
    // How often the display that it is on is refreshed, in whole Hz as GLFW tells it; 0: unknown. Cheap.
    [[nodiscard]] virtual double refresh_hz() const = 0;
    virtual void set_title(const std::string& title) = 0;
    virtual void set_full_screen(bool full_screen) = 0;
};

// A GLFW window. System lacks when there is no display, in one line that says how to go on without one. At
// most one at a time.
Result<std::unique_ptr<Window>> open_window(const WindowDesc& desc);

// Nothing to see and nobody to press a key: size and title are kept, everything else is silent.
std::unique_ptr<Window> open_headless(const WindowDesc& desc);

// Whether a window could be opened, for doctor: empty, or why not.
[[nodiscard]] std::string why_no_display();

// The gamepads there are, for a list of devices: none where there is no display to reach them through. Not
// while a window is open, which has its own.
[[nodiscard]] std::vector<Gamepad> find_gamepads();

}  // namespace onggi::window
