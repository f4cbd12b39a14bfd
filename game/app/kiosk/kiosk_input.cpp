// What the visitor does, by pointer, keys, devices and gamepads: a part of KioskVisit.
#include <cmath>
#include <vector>

#include "game/app/kiosk/kiosk_visit.h"

namespace onggi::app {
namespace {

using kiosk::Button;
using kiosk::Event;
using kiosk::Panel;
using kiosk::Screen;

HandKey hand_key(Button button) {
    switch (button) {
        case Button::kHandUp:
            return HandKey::kUp;
        case Button::kHandDown:
            return HandKey::kDown;
        case Button::kHandLeft:
            return HandKey::kLeft;
        default:
            return HandKey::kRight;
    }
}

}  // namespace

// On the upright plane through the axis that faces the camera: how far to the right, and how high.
std::optional<dvec2> KioskVisit::place_at(vec2 px) const {
    const auto place = parts_.view.tool_target_mm(double{px.x}, double{px.y});
    if (!place) return std::nullopt;
    return dvec2(std::copysign(std::hypot(place->x, place->z), place->x), place->y);
}

double KioskVisit::side() const {
    return state_.comfort.left_hand ? -1.0 : 1.0;
}

void KioskVisit::nudge_hand(Button button) {
    keys_lead_ = true;
    hand_.button(hand_key(button), side());
}

bool KioskVisit::clay_is_open() const {
    return state_.panel == Panel::kNone && state_.screen == Screen::kThrow;
}

void KioskVisit::help_along() {
    const std::optional<int> target =
        parts_.settings.config.visit.forgiving && state_.screen == Screen::kThrow ? state_.throwing.target
                                                                                  : std::nullopt;
    const int steps_done = state_.throwing.steps_done;
    if (target == helped_ && steps_done == helped_steps_) return;
    helped_ = target;
    helped_steps_ = steps_done;
    if (!target) {
        hand_.set_outline({}, 0.0);
        return;
    }
    const auto place = parts_.settings.exhibit_places[static_cast<std::size_t>(*target)];
    hand_.set_outline(wet_outline(parts_.settings.targets[place]), outline_help_after(steps_done));
}

void KioskVisit::take_news(const PointerNews& news) {
    const bool scene_is_open =
        state_.panel == Panel::kNone && (state_.screen == Screen::kThrow || state_.screen == Screen::kChoose);
    switch (news.kind) {
        case PointerNews::Kind::kNone:
            break;
        case PointerNews::Kind::kLife:
            tell({Event::Kind::kInput, Button::kNone, news.value});
            break;
        case PointerNews::Kind::kPressed:
            tell(Event::pressed(news.button, news.value));
            break;
        case PointerNews::Kind::kHandDown:
            if (clay_is_open()) {
                keys_lead_ = false;
                tell({Event::Kind::kClayTouched});
                if (const auto place = place_at(news.at_px)) hand_.press(*place);
            } else {
                tell({Event::Kind::kInput});
            }
            break;
        case PointerNews::Kind::kHandMoved:
            if (!scene_is_open) break;
            tell({Event::Kind::kInput});
            if (const auto place = place_at(news.at_px)) hand_.drag(*place);
            break;
        case PointerNews::Kind::kHandUp:
            hand_.release();
            break;
        case PointerNews::Kind::kHovered:
            hovered_s_ = now_s_;
            keys_lead_ = false;
            if (const auto place = place_at(news.at_px)) hand_.hover(*place);
            break;
        case PointerNews::Kind::kNudged:
            if (!clay_is_open()) break;
            tell({Event::Kind::kClayTouched});
            keys_lead_ = true;
            hand_.key(hand_key(news.button), side());
            break;
        case PointerNews::Kind::kCornerHeld:
            tell({Event::Kind::kCornerHeld});
            break;
        case PointerNews::Kind::kCloseAsked:
            tell({Event::Kind::kCloseAsked});
            break;
        case PointerNews::Kind::kStopForce:
            parts_.job.stop_force();
            break;
        case PointerNews::Kind::kFullScreen:
            if (parts_.settings.rules.locked) break;
            full_screen_ = !full_screen_;
            parts_.view.set_full_screen(full_screen_);
            break;
    }
}

void KioskVisit::take_input(const haptic::Snapshot& snapshot, double dt_s) {
    std::vector<PointerNews> all;
    for (const window::Event& event : parts_.view.poll_events())
        pointer_.handle(event, now_s_, all);
    pointer_.pass_time(now_s_, all);
    for (const PointerNews& news : all)
        take_news(news);
    for (const std::string& line : parts_.devices.news())
        say(line);
    const bool has_device = parts_.devices.has_hand();
    if (has_device != had_device_) tell({has_device ? Event::Kind::kDeviceBack : Event::Kind::kDeviceLost});
    had_device_ = has_device;
    // Another hand has the tool now: what the finger does from here on is another touch.
    const std::string holder = parts_.devices.holder();
    if (!holder.empty() && holder != holder_) hand_.release();
    holder_ = holder;
    if (parts_.devices.somebody_moved()) tell({Event::Kind::kInput});
    take_gamepads(snapshot, dt_s);
    help_along();
    if (!clay_is_open()) hand_.release();
}

void KioskVisit::take_gamepads(const haptic::Snapshot& snapshot, double dt_s) {
    std::vector<window::Gamepad> pads = parts_.view.gamepads();
    std::erase_if(pads,
                  [&](const auto& pad) { return parts_.devices.drives(pad.vendor_id, pad.product_id); });
    const GamepadWish wish = gamepads_.wish(pads, dt_s);
    if (wish.is_used) tell({Event::Kind::kInput});
    if (!clay_is_open()) return;
    if (wish.is_used) tell({Event::Kind::kClayTouched});
    hand_.steer(wish.step_mm, wish.presses, *snapshot.shape, side());
    if (wish.radius_steps > 0.5) tell(Event::pressed(Button::kToolMore));
    if (wish.radius_steps < -0.5) tell(Event::pressed(Button::kToolLess));
    if (wish.speed_steps > 0.5) tell(Event::pressed(Button::kSpeedMore));
    if (wish.speed_steps < -0.5) tell(Event::pressed(Button::kSpeedLess));
    if (wish.fresh_lump) tell(Event::pressed(Button::kNewClay));
}

}  // namespace onggi::app
