#include "engine/window/touch_screen.h"

#include <xcb/xinput.h>

#include <cmath>

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

bool LeadingFinger::is_free(int which, std::uint32_t now_ms) const {
    constexpr std::uint32_t kRestMs = 3000;  // longer than a throwing finger stays still
    constexpr std::uint32_t kNeverLiftedMs = 300'000;
    const auto at = static_cast<std::size_t>(which);
    if (!fingers_[at]) return true;
    const bool rests = !keeps_[at] && now_ms - fingers_[at]->still.time_ms >= kRestMs;
    return rests || now_ms - fingers_[at]->began_ms >= kNeverLiftedMs;
}

void LeadingFinger::follow(const Touch& touch, std::vector<Event>& events) {
    if (touch.phase == Touch::Phase::kBegin) return begin(touch, events);
    constexpr double kStillPx = 12.0;  // a resting palm's position drifts by some pixels
    for (std::optional<Finger>& finger : fingers_) {
        if (!finger || finger->id != touch.finger) continue;
        if (std::hypot(touch.x_px - finger->still.x_px, touch.y_px - finger->still.y_px) > kStillPx)
            finger->still = touch;
        const bool ends = touch.phase == Touch::Phase::kEnd;
        if (&finger == &fingers_[1]) {
            events.push_back(SecondFingerEvent{touch.phase, touch.x_px, touch.y_px});
        } else {
            events.push_back(PointerEvent{touch.x_px, touch.y_px});
            if (ends) events.push_back(ButtonEvent{MouseButton::kLeft, false});
        }
        if (ends) finger.reset();
    }
}

void LeadingFinger::begin(const Touch& touch, std::vector<Event>& events) {
    auto& [first, second] = fingers_;
    const Finger begun{touch.finger, touch, touch.time_ms};
    if (is_free(0, touch.time_ms)) {
        // Move the pointer away before the release, so that nothing is pressed there.
        if (first) events.push_back(PointerEvent{-1.0, -1.0});
        if (first) events.push_back(ButtonEvent{MouseButton::kLeft, false});
        first = begun;
        events.push_back(PointerEvent{touch.x_px, touch.y_px});
        events.push_back(ButtonEvent{MouseButton::kLeft, true});
    } else if (is_free(1, touch.time_ms)) {
        if (second)
            events.push_back(SecondFingerEvent{TouchPhase::kEnd, second->still.x_px, second->still.y_px});
        second = begun;
        events.push_back(SecondFingerEvent{TouchPhase::kBegin, touch.x_px, touch.y_px});
    }
}

namespace {

// Fixed point: 16 integer bits, 16 fractional bits.
double number(xcb_input_fp1616_t fixed) {
    return static_cast<double>(fixed) / 65536.0;
}

}  // namespace

std::unique_ptr<TouchScreen> TouchScreen::of(std::uint32_t window) {
    auto server = InputServer::connect();
    if (server == nullptr) return nullptr;
    const bool takes =
        server->select(window, XCB_INPUT_DEVICE_ALL_MASTER,
                       XCB_INPUT_XI_EVENT_MASK_TOUCH_BEGIN | XCB_INPUT_XI_EVENT_MASK_TOUCH_UPDATE |
                           XCB_INPUT_XI_EVENT_MASK_TOUCH_END);
    return takes ? std::unique_ptr<TouchScreen>(new TouchScreen(std::move(server))) : nullptr;
}

std::vector<Touch> TouchScreen::poll() {
    std::vector<Touch> touches;
    while (const auto event = server_->next_event()) {
        const auto* generic = reinterpret_cast<const xcb_ge_generic_event_t*>(event.get());
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
