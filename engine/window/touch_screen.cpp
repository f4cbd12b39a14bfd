// Uses a connection to the server of its own, because GLFW drops events that it does not know. XI 2.2
// protocol: https://www.x.org/releases/X11R7.7/doc/inputproto/XI2proto.txt
#include "engine/window/touch_screen.h"

#include <xcb/xcb.h>
#include <xcb/xinput.h>

#include <cmath>
#include <cstdlib>

namespace onggi::window {

void PointerArrow::moved(double x_px, double y_px, double now_s) {
    constexpr double kPauseS = 0.5;  // what comes later is another movement
    constexpr int kFewestMoves = 3;
    constexpr double kJoltPx = 24.0;
    if (moves_ == 0 || now_s - moved_s_ > kPauseS) {
        moves_ = 0;
        from_x_px_ = x_px;
        from_y_px_ = y_px;
    }
    ++moves_;
    moved_s_ = now_s;
    is_shown_ =
        is_shown_ || (moves_ >= kFewestMoves && std::hypot(x_px - from_x_px_, y_px - from_y_px_) >= kJoltPx);
}

bool PointerArrow::is_shown(double now_s) {
    constexpr double kStillS = 20.0;
    is_shown_ = is_shown_ && now_s - moved_s_ <= kStillS;
    return is_shown_;
}

void LeadingFinger::follow(const Touch& touch, std::vector<Event>& events) {
    if (touch.phase == Touch::Phase::kBegin) return begin(touch, events);
    if (touch.finger != finger_) return;
    move(touch, events);
    if (touch.phase == Touch::Phase::kMove) return;
    events.push_back(ButtonEvent{MouseButton::kLeft, false});
    finger_.reset();
}

void LeadingFinger::begin(const Touch& touch, std::vector<Event>& events) {
    if (finger_) {
        constexpr std::uint32_t kRestMs = 3000;  // longer than a throwing finger stays still
        constexpr std::uint32_t kNeverLiftedMs = 300'000;
        const bool rests = touch.time_ms - still_.time_ms >= kRestMs;
        if (!rests && touch.time_ms - began_ms_ < kNeverLiftedMs) return;
        // Move the pointer away before the release, so that nothing is pressed there.
        events.push_back(PointerEvent{-1.0, -1.0});
        events.push_back(ButtonEvent{MouseButton::kLeft, false});
    }
    finger_ = touch.finger;
    still_ = touch;
    began_ms_ = touch.time_ms;
    events.push_back(PointerEvent{touch.x_px, touch.y_px});
    events.push_back(ButtonEvent{MouseButton::kLeft, true});
}

void LeadingFinger::move(const Touch& touch, std::vector<Event>& events) {
    constexpr double kStillPx = 12.0;  // a resting palm's position drifts by some pixels
    if (std::hypot(touch.x_px - still_.x_px, touch.y_px - still_.y_px) > kStillPx) still_ = touch;
    events.push_back(PointerEvent{touch.x_px, touch.y_px});
}

namespace {

struct Freed {
    void operator()(void* answer) const { std::free(answer); }
};
template <typename T>
using Answer = std::unique_ptr<T, Freed>;

// Fixed point: 16 integer bits, 16 fractional bits.
double number(xcb_input_fp1616_t fixed) {
    return static_cast<double>(fixed) / 65536.0;
}

}  // namespace

std::unique_ptr<TouchScreen> TouchScreen::of(std::uint32_t window) {
    std::unique_ptr<TouchScreen> self(new TouchScreen(xcb_connect(nullptr, nullptr)));
    return self->take(window) ? std::move(self) : nullptr;
}

TouchScreen::~TouchScreen() {
    xcb_disconnect(server_);
}

bool TouchScreen::take(std::uint32_t window) {
    if (xcb_connection_has_error(server_) != 0) return false;
    const xcb_query_extension_reply_t* extension = xcb_get_extension_data(server_, &xcb_input_id);
    if (extension == nullptr || extension->present == 0) return false;
    xinput_ = extension->major_opcode;
    const Answer<xcb_input_xi_query_version_reply_t> version(
        xcb_input_xi_query_version_reply(server_, xcb_input_xi_query_version(server_, 2, 2), nullptr));
    if (!version || version->major_version < 2) return false;
    if (version->major_version == 2 && version->minor_version < 2) return false;

    struct {
        xcb_input_event_mask_t head{.deviceid = XCB_INPUT_DEVICE_ALL_MASTER, .mask_len = 1};
        std::uint32_t events = XCB_INPUT_XI_EVENT_MASK_TOUCH_BEGIN | XCB_INPUT_XI_EVENT_MASK_TOUCH_UPDATE |
                               XCB_INPUT_XI_EVENT_MASK_TOUCH_END;
    } const wanted;
    const auto asked = xcb_input_xi_select_events_checked(server_, window, 1, &wanted.head);
    const Answer<xcb_generic_error_t> refused(xcb_request_check(server_, asked));
    return refused == nullptr;
}

std::vector<Touch> TouchScreen::poll() {
    std::vector<Touch> touches;
    while (const Answer<xcb_generic_event_t> event{xcb_poll_for_event(server_)}) {
        const auto* generic = reinterpret_cast<const xcb_ge_generic_event_t*>(event.get());
        if (generic->response_type != XCB_GE_GENERIC || generic->extension != xinput_) continue;
        // The three event types have the same layout.
        const auto* touch = reinterpret_cast<const xcb_input_touch_begin_event_t*>(event.get());
        Touch::Phase phase{};
        switch (generic->event_type) {
            case XCB_INPUT_TOUCH_BEGIN:
                phase = Touch::Phase::kBegin;
                break;
            case XCB_INPUT_TOUCH_UPDATE:
                phase = Touch::Phase::kMove;
                break;
            case XCB_INPUT_TOUCH_END:
                phase = Touch::Phase::kEnd;
                break;
            default:
                continue;
        }
        touches.push_back(
            {phase, touch->detail, number(touch->event_x), number(touch->event_y), touch->time});
    }
    return touches;
}

}  // namespace onggi::window
