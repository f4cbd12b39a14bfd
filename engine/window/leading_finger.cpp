#include "engine/window/leading_finger.h"

#include <cmath>

namespace onggi::window {

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
        constexpr std::uint32_t kRestMs = 3000;  // longer than who throws lies still
        if (touch.time_ms - still_.time_ms < kRestMs) return;
        // Away from where it lies, so that nothing is pressed there.
        events.push_back(PointerEvent{-1.0, -1.0});
        events.push_back(ButtonEvent{MouseButton::kLeft, false});
    }
    finger_ = touch.finger;
    still_ = touch;
    events.push_back(PointerEvent{touch.x_px, touch.y_px});
    events.push_back(ButtonEvent{MouseButton::kLeft, true});
}

void LeadingFinger::move(const Touch& touch, std::vector<Event>& events) {
    constexpr double kStillPx = 12.0;  // a palm's place wanders by some pixels
    if (std::hypot(touch.x_px - still_.x_px, touch.y_px - still_.y_px) > kStillPx) still_ = touch;
    events.push_back(PointerEvent{touch.x_px, touch.y_px});
}

}  // namespace onggi::window
