// A window, or a headless one for machines without a display. Main thread only. Pixels are those of the
// framebuffer.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/host_surface.h"
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

    // The Vulkan instance extensions that create_surface needs; empty: nothing is presented.
    [[nodiscard]] virtual std::vector<std::string> instance_extensions() const = 0;
    // Returns VK_NULL_HANDLE for a headless window. The caller destroys the surface.
    virtual Result<VkSurfaceKHR> create_surface(VkInstance instance) = 0;

    // The window's memory for pictures of a software device. Null if the window system cannot share memory;
    // the pictures then go through a surface.
    [[nodiscard]] virtual std::unique_ptr<vk::HostSurface> host_surface() = 0;

    // Returns the events since the last call, oldest first. Never blocks.
    [[nodiscard]] virtual std::vector<Event> poll_events() = 0;
    // The connected gamepads with a known button layout, as of the last poll_events().
    [[nodiscard]] virtual std::vector<Gamepad> gamepads() const = 0;
    // The pen that moved the pointer last, as of the last poll_events(); empty: a mouse or a finger did.
    [[nodiscard]] virtual std::optional<Pen> pen() const = 0;
    // Whether the first and the second finger hold something: one that holds is not taken for a hand that
    // lies on the screen, and keeps its place while another finger comes.
    virtual void keep_fingers(bool first, bool second) = 0;
    [[nodiscard]] virtual bool close_requested() const = 0;
    [[nodiscard]] virtual Size size() const = 0;
    // Refresh rate of the window's display in whole Hz, from GLFW; 0: unknown. Cheap.
    [[nodiscard]] virtual double refresh_hz() const = 0;
    // The window system, for the log; empty: headless.
    [[nodiscard]] virtual std::string platform() const = 0;
    // The reason why touches are not read one by one; empty if they are, or if headless.
    [[nodiscard]] virtual std::string why_no_touches() const = 0;
    virtual void set_title(const std::string& title) = 0;
    virtual void set_full_screen(bool full_screen) = 0;
};

// Opens a GLFW window, at most one at a time. Error: system lacks, if there is no display; the line says how
// to run without one.
Result<std::unique_ptr<Window>> open_window(const WindowDesc& desc);

// Opens a headless window: it stores size and title, and sends no events.
std::unique_ptr<Window> open_headless(const WindowDesc& desc);

// Returns empty if a window can be opened, otherwise the reason. For `onggi doctor`.
[[nodiscard]] std::string why_no_display();

// The connected gamepads, for a list of devices; empty without a display, which GLFW needs to find them. Not
// while a window is open: use its gamepads().
[[nodiscard]] std::vector<Gamepad> find_gamepads();

}  // namespace onggi::window
