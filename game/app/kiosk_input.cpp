// What the visitor does, by pointer, keys, devices and gamepads: a part of KioskVisit.
#include <vector>

#include "game/app/kiosk_visit.h"

namespace onggi::app {
namespace {

using kiosk::Button;
using kiosk::Event;
using kiosk::Panel;
using kiosk::Screen;

constexpr double kNudgeMm = 5.0;
constexpr double kFrameS = 1.0 / 60.0;

dvec3 nudge_of(Button button) {
    switch (button) {
        case Button::kHandUp:
            return {0.0, kNudgeMm, 0.0};
        case Button::kHandDown:
            return {0.0, -kNudgeMm, 0.0};
        case Button::kHandLeft:
            return {-kNudgeMm, 0.0, 0.0};
        case Button::kHandRight:
            return {kNudgeMm, 0.0, 0.0};
        default:
            return dvec3(0.0);
    }
}

}  // namespace

std::optional<dvec3> KioskVisit::place_at(vec2 px) const {
    return parts_.view.tool_target_mm(double{px.x}, double{px.y});
}

double KioskVisit::side() const {
    return state_.comfort.left_hand ? -1.0 : 1.0;
}

void KioskVisit::nudge_hand(Button button, const haptic::PotShape& shape) {
    hand_.nudge(nudge_of(button), shape, side());
}

void KioskVisit::take_news(const PointerNews& news, const haptic::Snapshot& snapshot) {
    const bool scene_is_open =
        state_.panel == Panel::kNone && (state_.screen == Screen::kThrow || state_.screen == Screen::kChoose);
    switch (news.kind) {
        case PointerNews::Kind::kNone:
            break;
        case PointerNews::Kind::kLife:
            tell({Event::Kind::kInput});
            break;
        case PointerNews::Kind::kPressed:
            tell(Event::pressed(news.button, news.value));
            break;
        case PointerNews::Kind::kHandDown:
            if (state_.panel == Panel::kNone && state_.screen == Screen::kThrow) {
                tell({Event::Kind::kClayTouched});
                if (const auto place = place_at(news.at_px)) hand_.press(*place, *snapshot.shape);
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
            if (const auto place = place_at(news.at_px)) hand_.hover(*place, parts_.view.towards_eye(*place));
            break;
        case PointerNews::Kind::kNudged:
            if (state_.panel == Panel::kNone && state_.screen == Screen::kThrow) {
                tell({Event::Kind::kClayTouched});
                nudge_hand(news.button, *snapshot.shape);
            }
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

void KioskVisit::take_input(const haptic::Snapshot& snapshot) {
    std::vector<PointerNews> all;
    for (const window::Event& event : parts_.view.poll_events())
        pointer_.handle(event, now_s_, all);
    pointer_.pass_time(now_s_, all);
    for (const PointerNews& news : all)
        take_news(news, snapshot);
    for (const std::string& line : parts_.devices.news())
        say(line);
    const bool has_device = parts_.devices.has_hand();
    if (has_device != had_device_) tell({has_device ? Event::Kind::kDeviceBack : Event::Kind::kDeviceLost});
    had_device_ = has_device;
    if (parts_.devices.somebody_moved()) tell({Event::Kind::kInput});
    take_gamepads(snapshot);
}

void KioskVisit::take_gamepads(const haptic::Snapshot& snapshot) {
    std::vector<window::Gamepad> pads = parts_.view.gamepads();
    std::erase_if(pads,
                  [&](const auto& pad) { return parts_.devices.drives(pad.vendor_id, pad.product_id); });
    const GamepadWish wish = gamepads_.wish(pads, kFrameS);
    if (!wish.is_used) return;
    tell({Event::Kind::kInput});
    if (state_.screen != Screen::kThrow || state_.panel != Panel::kNone) return;
    tell({Event::Kind::kClayTouched});
    hand_.nudge(wish.step_mm, *snapshot.shape, side());
    if (wish.radius_steps > 0.5) tell(Event::pressed(Button::kToolMore));
    if (wish.radius_steps < -0.5) tell(Event::pressed(Button::kToolLess));
    if (wish.fresh_lump) tell(Event::pressed(Button::kNewClay));
}

}  // namespace onggi::app
