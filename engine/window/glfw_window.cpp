// The only user of GLFW.
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "engine/window/pens.h"
#include "engine/window/shared_picture.h"
#include "engine/window/touch_screen.h"
#include "engine/window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

// Declared in <GLFW/glfw3native.h>, which would include Xlib's macros. Weak: GLFW 3.3's Wayland build lacks
// it.
extern "C" [[gnu::weak]] unsigned long glfwGetX11Window(GLFWwindow* window);
// Weak: GLFW 3.3 lacks it. A program built with the headers of 3.3 may run on 3.4, which has the same soname.
extern "C" [[gnu::weak]] int glfwGetPlatform();

namespace onggi::window {
namespace {

// Values of the header of GLFW 3.4, which that of 3.3 lacks.
constexpr int kPlatformHint = 0x00050003;
constexpr int kAnyPlatform = 0x00060000;
constexpr int kPlatformX11 = 0x00060004;

bool starts_on(int platform) {
    glfwInitHint(kPlatformHint, platform);
    return glfwInit() == GLFW_TRUE;
}

// GLFW 3.4 prefers Wayland, where it has no touches, also inside cage
// (findings/glfw-3-4-takes-wayland-inside-cage.sh). Touches need X11, wherever there is an X server.
bool starts() {
    if (glfwGetPlatform == nullptr) return glfwInit() == GLFW_TRUE;
    const char* display = std::getenv("DISPLAY");
    return (display != nullptr && *display != '\0' && starts_on(kPlatformX11)) || starts_on(kAnyPlatform);
}

bool is_on_x11() {
    if (glfwGetX11Window == nullptr) return false;
    return glfwGetPlatform == nullptr || glfwGetPlatform() == kPlatformX11;
}

// GLFW has global state; this class counts its users.
class GlfwLibrary {
  public:
    // Error: why GLFW cannot start.
    static Result<std::unique_ptr<GlfwLibrary>> start() {
        if (!starts()) {
            const char* reason = nullptr;
            glfwGetError(&reason);
            return system_lacks(
                fmt::format("window: expected a display, found none ({}); set DISPLAY or do without a window",
                            reason == nullptr ? "no reason given" : reason));
        }
        return std::unique_ptr<GlfwLibrary>(new GlfwLibrary);
    }
    ~GlfwLibrary() { glfwTerminate(); }
    GlfwLibrary(const GlfwLibrary&) = delete;
    GlfwLibrary& operator=(const GlfwLibrary&) = delete;

  private:
    GlfwLibrary() = default;
};

Key key_of(int code) {
    switch (code) {
        case GLFW_KEY_ESCAPE:
            return Key::kEscape;
        case GLFW_KEY_SPACE:
            return Key::kSpace;
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER:
            return Key::kEnter;
        case GLFW_KEY_LEFT_BRACKET:
            return Key::kLeftBracket;
        case GLFW_KEY_RIGHT_BRACKET:
            return Key::kRightBracket;
        case GLFW_KEY_EQUAL:  // the key of + on most layouts, without shift
        case GLFW_KEY_KP_ADD:
            return Key::kPlus;
        case GLFW_KEY_MINUS:
        case GLFW_KEY_KP_SUBTRACT:
            return Key::kMinus;
        case GLFW_KEY_UP:
            return Key::kUp;
        case GLFW_KEY_DOWN:
            return Key::kDown;
        case GLFW_KEY_1:
            return Key::k1;
        case GLFW_KEY_2:
            return Key::k2;
        case GLFW_KEY_3:
            return Key::k3;
        case GLFW_KEY_4:
            return Key::k4;
        case GLFW_KEY_C:
            return Key::kC;
        case GLFW_KEY_E:
            return Key::kE;
        case GLFW_KEY_F:
            return Key::kF;
        case GLFW_KEY_Q:
            return Key::kQ;
        case GLFW_KEY_R:
            return Key::kR;
        case GLFW_KEY_S:
            return Key::kS;
        case GLFW_KEY_T:
            return Key::kT;
        case GLFW_KEY_U:
            return Key::kU;
        case GLFW_KEY_V:
            return Key::kV;
        case GLFW_KEY_W:
            return Key::kW;
        case GLFW_KEY_X:
            return Key::kX;
        case GLFW_KEY_F1:
            return Key::kF1;
        case GLFW_KEY_F11:
            return Key::kF11;
        case GLFW_KEY_TAB:
            return Key::kTab;
        case GLFW_KEY_LEFT:
            return Key::kLeft;
        case GLFW_KEY_RIGHT:
            return Key::kRight;
        case GLFW_KEY_BACKSPACE:
            return Key::kBackspace;
        case GLFW_KEY_PAUSE:
            return Key::kPause;
        default:
            return Key::kUnknown;
    }
}

MouseButton button_of(int code) {
    switch (code) {
        case GLFW_MOUSE_BUTTON_RIGHT:
            return MouseButton::kRight;
        case GLFW_MOUSE_BUTTON_MIDDLE:
            return MouseButton::kMiddle;
        default:
            return MouseButton::kLeft;
    }
}

// SDL's GUID, 32 hexadecimal digits: bus, vendor and product, each with its low byte first and followed by
// two zero bytes.
std::uint16_t number_in_identity(std::string_view identity, std::size_t at) {
    const auto byte = [&](std::size_t from) -> unsigned {
        unsigned value = 0;
        if (from + 2 > identity.size()) return 0;
        std::from_chars(identity.data() + from, identity.data() + from + 2, value, 16);
        return value;
    };
    return static_cast<std::uint16_t>(byte(at) | byte(at + 2) << 8U);
}

std::vector<Gamepad> gamepads_now() {
    std::vector<Gamepad> found;
    for (int slot = GLFW_JOYSTICK_1; slot <= GLFW_JOYSTICK_LAST; ++slot) {
        GLFWgamepadstate state{};
        if (glfwJoystickIsGamepad(slot) != GLFW_TRUE || glfwGetGamepadState(slot, &state) != GLFW_TRUE)
            continue;
        const char* name = glfwGetGamepadName(slot);
        const char* guid = glfwGetJoystickGUID(slot);
        const std::string_view identity = guid == nullptr ? "" : guid;
        constexpr std::size_t kVendorDigit = 8;
        constexpr std::size_t kProductDigit = 16;
        // A trigger's axis runs from -1 (released) to 1.
        const auto pulled = [&](int axis) { return (state.axes[axis] + 1.0F) / 2.0F; };
        Gamepad pad{.slot = slot,
                    .name = name == nullptr ? "" : name,
                    .vendor_id = number_in_identity(identity, kVendorDigit),
                    .product_id = number_in_identity(identity, kProductDigit),
                    .left_x = state.axes[GLFW_GAMEPAD_AXIS_LEFT_X],
                    .left_y = state.axes[GLFW_GAMEPAD_AXIS_LEFT_Y],
                    .right_x = state.axes[GLFW_GAMEPAD_AXIS_RIGHT_X],
                    .right_y = state.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y],
                    .left_trigger = pulled(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER),
                    .right_trigger = pulled(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER)};
        for (unsigned button = 0; button <= GLFW_GAMEPAD_BUTTON_LAST; ++button)
            if (state.buttons[button] == GLFW_PRESS) pad.buttons |= 1U << button;
        found.push_back(std::move(pad));
    }
    return found;
}

class GlfwWindow final : public Window {
  public:
    GlfwWindow(std::unique_ptr<GlfwLibrary> library, GLFWwindow* window)
        : library_(std::move(library)),
          window_(window),
          wants_full_screen_(glfwGetWindowMonitor(window) != nullptr) {
        glfwSetWindowUserPointer(window_, this);
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int code, int, int action, int) {
            self(w).push(KeyEvent{key_of(code), action != GLFW_RELEASE, action == GLFW_REPEAT});
        });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int code, int action, int) {
            // A hand that holds a pen presses the buttons at its side by accident.
            const bool is_at_side = code != GLFW_MOUSE_BUTTON_LEFT && action == GLFW_PRESS && self(w).pen();
            if (code <= GLFW_MOUSE_BUTTON_MIDDLE && !is_at_side)
                self(w).push(ButtonEvent{button_of(code), action == GLFW_PRESS});
        });
        glfwSetCursorPosCallback(window_,
                                 [](GLFWwindow* w, double x, double y) { self(w).push_pointer(x, y); });
        glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double y) { self(w).push(ScrollEvent{y}); });
        glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int width, int height) {
            self(w).push(ResizeEvent{width, height});
            self(w).moved_ = true;
        });
        glfwSetWindowFocusCallback(
            window_, [](GLFWwindow* w, int focused) { self(w).push(FocusEvent{focused == GLFW_TRUE}); });
        glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { self(w).push(CloseEvent{}); });
        glfwSetWindowPosCallback(window_, [](GLFWwindow* w, int, int) { self(w).moved_ = true; });
        if (!is_on_x11()) return;
        fingers_ = TouchScreen::of(static_cast<std::uint32_t>(glfwGetX11Window(window_)));
        pens_ = Pens::open();
    }
    ~GlfwWindow() override { glfwDestroyWindow(window_); }
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    [[nodiscard]] std::vector<std::string> instance_extensions() const override {
        std::uint32_t count = 0;
        const char** names = glfwGetRequiredInstanceExtensions(&count);
        return names == nullptr ? std::vector<std::string>() : std::vector<std::string>(names, names + count);
    }

    Result<VkSurfaceKHR> create_surface(VkInstance instance) override {
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        const VkResult result = glfwCreateWindowSurface(instance, window_, nullptr, &surface);
        if (result == VK_SUCCESS) return surface;
        const char* reason = nullptr;
        glfwGetError(&reason);
        return system_lacks(fmt::format("window: expected a Vulkan surface, found VkResult {} ({})",
                                        static_cast<int>(result),
                                        reason == nullptr ? "no reason given" : reason));
    }

    [[nodiscard]] std::unique_ptr<vk::HostSurface> host_surface() override {
        if (!is_on_x11()) return nullptr;
        return SharedPicture::of(static_cast<std::uint32_t>(glfwGetX11Window(window_)));
    }

    [[nodiscard]] std::vector<Event> poll_events() override {
        if (pens_) pens_->poll();
        glfwPollEvents();
        if (fingers_) follow_fingers();
        show_cursor(arrow_.is_shown(glfwGetTime()));
        // After a monitor is unplugged the window is no longer full screen; restore that when it is plugged
        // in again.
        if (wants_full_screen_ && !fills_screen()) fill_screen();
        if (std::exchange(moved_, false)) {
            come_onto_the_display();
            refresh_hz_ = refresh_now_hz();
        }
        return std::exchange(events_, {});
    }
    [[nodiscard]] std::vector<Gamepad> gamepads() const override { return gamepads_now(); }
    [[nodiscard]] std::optional<Pen> pen() const override {
        return pens_ ? pens_->state().pen() : std::nullopt;
    }
    void keep_fingers(bool first, bool second) override { leading_.keep(first, second); }
    [[nodiscard]] bool close_requested() const override {
        return glfwWindowShouldClose(window_) == GLFW_TRUE;
    }
    [[nodiscard]] Size size() const override {
        Size size;
        glfwGetFramebufferSize(window_, &size.width, &size.height);
        return size;
    }
    [[nodiscard]] double refresh_hz() const override { return refresh_hz_; }
    [[nodiscard]] std::string platform() const override { return is_on_x11() ? "X11" : "Wayland"; }
    [[nodiscard]] std::string why_no_touches() const override {
        if (fingers_) return {};
        if (!is_on_x11())
            return "expected X11, found Wayland, where GLFW reads none; set DISPLAY to an X server";
        return "expected an X server that reports them (XInput 2.2), found one that does not";
    }
    void set_title(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }

    void set_full_screen(bool full_screen) override {
        wants_full_screen_ = full_screen;
        if (fills_screen() == full_screen) return;
        if (full_screen) {
            glfwGetWindowPos(window_, &windowed_x_, &windowed_y_);
            glfwGetWindowSize(window_, &windowed_.width, &windowed_.height);
            fill_screen();
        } else {
            if (std::exchange(covers_display_, false))
                glfwSetWindowAttrib(window_, GLFW_DECORATED, GLFW_TRUE);
            const Size size = windowed_.width > 0 ? windowed_ : Size{1280, 720};
            glfwSetWindowMonitor(window_, nullptr, windowed_x_, windowed_y_, size.width, size.height,
                                 GLFW_DONT_CARE);
        }
    }

  private:
    static GlfwWindow& self(GLFWwindow* window) {
        return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
    }
    [[nodiscard]] bool fills_screen() const {
        return covers_display_ || glfwGetWindowMonitor(window_) != nullptr;
    }
    void fill_screen() {
        GLFWmonitor* monitor = glfwGetPrimaryMonitor();
        const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
        if (mode == nullptr) return;
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
    // If RandR reports no CRTC, GLFW 3.3 places a full-screen window at uninitialised coordinates, out of
    // sight (findings/glfw-full-screen-is-off-the-display-without-randr.sh). A window without decoration then
    // covers the display.
    void come_onto_the_display() {
        GLFWmonitor* monitor = glfwGetWindowMonitor(window_);
        const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
        if (mode == nullptr) return;
        int left = 0;
        int top = 0;
        int x = 0;
        int y = 0;
        glfwGetMonitorPos(monitor, &left, &top);
        glfwGetWindowPos(window_, &x, &y);
        if (std::abs(x - left) < mode->width && std::abs(y - top) < mode->height) return;
        covers_display_ = true;
        glfwSetWindowMonitor(window_, nullptr, left, top, mode->width, mode->height, GLFW_DONT_CARE);
        glfwSetWindowAttrib(window_, GLFW_DECORATED, GLFW_FALSE);
    }
    // The refresh rate of the display that shows the window's centre, or of the first one. It queries the
    // server, so it is not called every frame.
    [[nodiscard]] double refresh_now_hz() const {
        GLFWmonitor* monitor = glfwGetWindowMonitor(window_);
        if (monitor == nullptr) monitor = monitor_below();
        const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
        return mode == nullptr ? 0.0 : static_cast<double>(mode->refreshRate);
    }
    [[nodiscard]] GLFWmonitor* monitor_below() const {
        int x = 0;
        int y = 0;
        Size own;
        glfwGetWindowPos(window_, &x, &y);
        glfwGetWindowSize(window_, &own.width, &own.height);
        int count = 0;
        GLFWmonitor** const monitors = glfwGetMonitors(&count);
        for (GLFWmonitor* monitor : std::span(monitors, static_cast<std::size_t>(count))) {
            int left = 0;
            int top = 0;
            glfwGetMonitorPos(monitor, &left, &top);
            const GLFWvidmode* mode = glfwGetVideoMode(monitor);
            if (mode == nullptr) continue;
            const int across = x + own.width / 2 - left;
            const int down = y + own.height / 2 - top;
            if (across >= 0 && across < mode->width && down >= 0 && down < mode->height) return monitor;
        }
        return glfwGetPrimaryMonitor();
    }
    void push(Event event) { events_.push_back(event); }
    // Converts pointer and touch positions from the desktop's units, which are not pixels on a scaled screen.
    // Empty while the window has no size.
    [[nodiscard]] std::optional<PointerEvent> in_pixels(double x, double y) const {
        Size units;
        glfwGetWindowSize(window_, &units.width, &units.height);
        const Size pixels = size();
        if (units.width <= 0 || units.height <= 0) return std::nullopt;
        return PointerEvent{x * pixels.width / units.width, y * pixels.height / units.height};
    }
    void push_pointer(double x, double y) {
        arrow_.moved(x, y, glfwGetTime());
        if (const auto pointer = in_pixels(x, y)) push(*pointer);
    }
    void show_cursor(bool shows) {
        if (std::exchange(shows_cursor_, shows) != shows)
            glfwSetInputMode(window_, GLFW_CURSOR, shows ? GLFW_CURSOR_NORMAL : GLFW_CURSOR_HIDDEN);
    }
    void follow_fingers() {
        for (Touch touch : fingers_->poll()) {
            const auto place = in_pixels(touch.x_px, touch.y_px).value_or(PointerEvent{});
            touch.x_px = place.x_px;
            touch.y_px = place.y_px;
            arrow_.touched();
            if (pens_) pens_->state().touched();
            leading_.follow(touch, events_);
        }
    }

    std::unique_ptr<GlfwLibrary> library_;
    GLFWwindow* window_;
    std::vector<Event> events_;
    std::unique_ptr<TouchScreen> fingers_;  // null: touches move the pointer
    std::unique_ptr<Pens> pens_;            // null: pens are mice
    LeadingFinger leading_;
    bool shows_cursor_ = true;
    PointerArrow arrow_{fingers_ == nullptr};
    double refresh_hz_ = refresh_now_hz();
    bool moved_ = true;            // perhaps to another display
    bool covers_display_ = false;  // without being GLFW's full screen
    Size windowed_;
    int windowed_x_ = 0;
    int windowed_y_ = 0;
    bool wants_full_screen_ = false;
};

}  // namespace

Result<std::unique_ptr<Window>> open_window(const WindowDesc& desc) {
    auto library = GlfwLibrary::start();
    if (!library) return library.error();
    if (glfwVulkanSupported() != GLFW_TRUE) {
        return system_lacks(
            "window: expected a Vulkan loader and driver, found none; install mesa-vulkan-drivers");
    }
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    GLFWmonitor* monitor = desc.full_screen ? glfwGetPrimaryMonitor() : nullptr;
    int width = desc.width;
    int height = desc.height;
    if (const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor)) {
        width = mode->width;
        height = mode->height;
        glfwWindowHint(GLFW_REFRESH_RATE, mode->refreshRate);
    }
    GLFWwindow* window = glfwCreateWindow(width, height, desc.title.c_str(), monitor, nullptr);
    if (window == nullptr) {
        const char* reason = nullptr;
        glfwGetError(&reason);
        return system_lacks(fmt::format("window: expected one of {}x{}, found none ({})", width, height,
                                        reason == nullptr ? "no reason given" : reason));
    }
    return std::unique_ptr<Window>(std::make_unique<GlfwWindow>(std::move(*library), window));
}

std::vector<Gamepad> find_gamepads() {
    const auto library = GlfwLibrary::start();
    if (!library) return {};
    glfwPollEvents();
    return gamepads_now();
}

std::string why_no_display() {
    const auto library = GlfwLibrary::start();
    if (!library) return library.error().message;
    return glfwVulkanSupported() == GLFW_TRUE ? std::string() : "a display, but no Vulkan driver for it";
}

}  // namespace onggi::window
