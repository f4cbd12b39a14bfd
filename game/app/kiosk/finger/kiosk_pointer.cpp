#include "game/app/kiosk/finger/kiosk_pointer.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace onggi::app {
namespace {

using Kind = PointerNews::Kind;

constexpr float kLifePx = 24.0F;  // vibration moves a mouse by less, so smaller motion is not a visitor
// A single jump does not count either: display servers put the pointer of a new window at the last touch.
constexpr double kOnItsWayS = 2.0;
// A landing finger is first reported as a jump of the mouse; if it lands on a target, only the press counts.
constexpr double kLandingS = 0.08;
constexpr double kRepeatAfterS = 0.5;
constexpr double kRepeatEveryS = 0.25;
constexpr double kCornerS = 5.0;
constexpr float kCornerU = 80.0F;
constexpr double kScanEveryS = 1.4;
// A touch that does not move for longer is a fault of the touch screen; a key or press that repeats for
// longer is held by an object.
constexpr double kLongestStillS = haptics::kControlRestsS;
constexpr float kFingerStillPx = 4.0F;

dvec3 place(vec2 px) {
    return {px.x, px.y, 0.0};
}

}  // namespace

// A worn spot of a touch screen presses itself, always in the same place; visitors press in several places.
KioskPointer::KioskPointer()
    : mouse_(kLifePx),
      finger_(kFingerStillPx),
      second_(kFingerStillPx),
      presses_(kLifePx, kLifePx),
      wheel_(0.0) {}

void KioskPointer::advance(double now_s) {
    const double dt_s = std::max(0.0, now_s - advanced_s_.value_or(now_s));
    advanced_s_ = now_s;
    mouse_.pass(dt_s);
    finger_.pass(dt_s);
    second_.pass(dt_s);
    presses_.pass(dt_s, buttons_down_ != 0);
    wheel_.pass(dt_s);
}

std::vector<std::string> KioskPointer::restless() const {
    std::vector<std::string> words;
    if (presses_.never_rests() || (finger_down_ && finger_.never_rests()) ||
        (second_down_ && second_.never_rests()))
        words.emplace_back("touch screen or mouse button");
    if (mouse_.never_rests() && buttons_down_ == 0) words.emplace_back("mouse");
    if (wheel_.never_rests()) words.emplace_back("mouse wheel");
    if (key_down_s_ && advanced_s_.value_or(0.0) - *key_down_s_ >= haptics::kNeverRestsAfterS)
        words.emplace_back("keyboard");
    return words;
}

void KioskPointer::forget() {
    focus_ = -1;
    scans_ = false;
    arrows_walk_ = false;
}

int KioskPointer::target_count() const {
    return composition_ == nullptr ? 0 : static_cast<int>(composition_->targets.size());
}

KioskPointer::Meaning KioskPointer::meaning_of(int target) const {
    if (target < 0 || target >= target_count()) return {};
    const screens::Target& found = composition_->targets[static_cast<std::size_t>(target)];
    return {found.button, found.value};
}

int KioskPointer::place_of(const Meaning& meaning, int was) const {
    if (was < 0 || meaning_of(was) == meaning) return was;
    for (int i = 0; i < target_count(); ++i)
        if (meaning_of(i) == meaning) return i;
    return -1;
}

int KioskPointer::target_at(vec2 px) const {
    for (int i = target_count() - 1; i >= 0; --i) {
        if (composition_->targets[static_cast<std::size_t>(i)].lies_under(px / composition_->px_per_u))
            return i;
    }
    return -1;
}

bool KioskPointer::in_corner(vec2 px) const {
    if (composition_ == nullptr) return false;
    const vec2 at = px / composition_->px_per_u;
    const float x = right_to_left_ ? composition_->bounds.width - at.x : at.x;
    return x >= 0.0F && x < kCornerU && at.y >= 0.0F && at.y < kCornerU;
}

bool KioskPointer::in_window(vec2 px) const {
    if (composition_ == nullptr) return true;
    const vec2 size = composition_->px_per_u * vec2(composition_->bounds.width, composition_->bounds.height);
    // Half a pixel of tolerance for rounding.
    return px.x > -0.5F && px.y > -0.5F && px.x < size.x + 0.5F && px.y < size.y + 0.5F;
}

void KioskPointer::look_at(const screens::Composition* composition, int screen_key, bool right_to_left,
                           bool at_clay) {
    composition_ = composition;
    right_to_left_ = right_to_left;
    at_clay_ = at_clay;
    if (screen_key == screen_key_) {
        // If buttons were added or removed, the pressed target and the ring stay on theirs.
        pressed_ = place_of(pressed_meaning_, pressed_);
        const int ring = place_of(focus_meaning_, focus_);
        focus_ = ring >= 0 ? ring : std::min(focus_, target_count() - 1);
    } else {
        screen_key_ = screen_key;
        if (focus_ >= 0 || scans_ || arrows_walk_)
            focus_ = target_count() > 0 && !(arrows_walk_ && at_clay_) ? 0 : -1;
        scan_is_new_ = true;
    }
    focus_meaning_ = meaning_of(focus_);
}

void KioskPointer::move_focus(int by) {
    const int count = target_count();
    if (count == 0) return;
    focus_ = focus_ < 0 ? (by > 0 ? 0 : count - 1) : (focus_ + by + count) % count;
    focus_meaning_ = meaning_of(focus_);
}

void KioskPointer::walk(kiosk::Button arrow) {
    using kiosk::Button;
    const Button forward = right_to_left_ ? Button::kHandLeft : Button::kHandRight;
    const int by = arrow == forward || arrow == Button::kHandDown ? 1 : -1;
    const int next = focus_ + by;
    scans_ = false;
    arrows_walk_ = true;
    if (at_clay_ && (next < 0 || next >= target_count())) {
        focus_ = -1;
    } else {
        move_focus(by);
    }
}

void KioskPointer::begin_walk() {
    arrows_walk_ = true;
    if (focus_ < 0) move_focus(1);
}

void KioskPointer::press_focus(std::vector<PointerNews>& news) const {
    if (focus_ < 0 || focus_ >= target_count()) return;
    const screens::Target& target = composition_->targets[static_cast<std::size_t>(focus_)];
    news.push_back({Kind::kPressed, target.button, target.value, {}});
}

bool KioskPointer::is_pressed(const window::KeyEvent& key, double now_s) {
    if (!key.pressed) key_down_s_.reset();
    if (!key.pressed) return false;
    if (!key.repeat || !key_down_s_) key_down_s_ = now_s;
    return now_s - *key_down_s_ < kLongestStillS;
}

void KioskPointer::handle_key(const window::KeyEvent& key, double now_s, std::vector<PointerNews>& news) {
    using window::Key;
    if (!is_pressed(key, now_s)) return;
    // A press is not reported as kLife, which could close the panel that it is meant for.
    const bool takes = key.key == Key::kF1 || key.key == Key::kW ||
                       ((key.key == Key::kEnter || key.key == Key::kSpace) && focus_ >= 0);
    if (!takes && !key.repeat) news.push_back({.kind = Kind::kLife, .value = 1});
    const auto nudge = [&](kiosk::Button to) { news.push_back({Kind::kNudged, to, 0, {}, !key.repeat}); };
    switch (key.key) {
        case Key::kTab:
        case Key::kRightBracket:
        case Key::kLeftBracket:
            scans_ = false;
            arrows_walk_ = false;
            move_focus(key.key == Key::kLeftBracket ? -1 : 1);
            return;
        case Key::kUp:
            nudge(kiosk::Button::kHandUp);
            return;
        case Key::kDown:
            nudge(kiosk::Button::kHandDown);
            return;
        case Key::kLeft:
            nudge(kiosk::Button::kHandLeft);
            return;
        case Key::kRight:
            nudge(kiosk::Button::kHandRight);
            return;
        case Key::kEnter:
            if (key.repeat) return;
            // Without a ring, Enter puts a brush down or lifts it.
            if (focus_ < 0) news.push_back({.kind = Kind::kPutDown});
            press_focus(news);
            return;
        case Key::kSpace:
            // Single-switch scanning: the first press starts the scan, the next presses the focused target.
            if (key.repeat) return;
            if (focus_ >= 0) {
                press_focus(news);
            } else {
                scans_ = true;
                arrows_walk_ = false;
                move_focus(1);
            }
            scan_s_ = now_s;
            return;
        case Key::kEscape:
        case Key::kQ:
            if (!key.repeat) news.push_back({.kind = Kind::kCloseAsked});
            return;
        case Key::kF1:
            if (!key.repeat) news.push_back({Kind::kPressed, kiosk::Button::kShowMe, 0, {}});
            return;
        case Key::kT:
            if (!key.repeat) news.push_back({Kind::kPressed, kiosk::Button::kTools, 0, {}});
            return;
        case Key::k1:
        case Key::k2:
        case Key::k3:
        case Key::k4: {
            const int place = static_cast<int>(key.key) - static_cast<int>(Key::k1);
            if (!key.repeat) news.push_back({Kind::kPressed, kiosk::Button::kTakeTool, place, {}});
            return;
        }
        case Key::kV:
            if (!key.repeat) news.push_back({Kind::kPressed, kiosk::Button::kForces, 0, {}});
            return;
        case Key::kW:
        case Key::kPause:
            if (!key.repeat) news.push_back({.kind = key.key == Key::kW ? Kind::kWhere : Kind::kStopForce});
            return;
        case Key::kF:
        case Key::kF11:
            if (!key.repeat) news.push_back({.kind = Kind::kFullScreen});
            return;
        default:
            return;
    }
}

void KioskPointer::lift_finger(std::vector<PointerNews>& news) {
    if (finger_down_) news.push_back({.kind = Kind::kFingerUp, .at_px = at_px_});
    finger_down_ = false;
}

void KioskPointer::lift_second(std::vector<PointerNews>& news) {
    if (second_down_) news.push_back({.kind = Kind::kSecondUp, .at_px = second_px_});
    second_down_ = false;
}

// It presses no button and holds no corner, so that an elbow beside a hand at work does neither.
void KioskPointer::handle_second(const window::SecondFingerEvent& finger, std::vector<PointerNews>& news) {
    second_px_ = vec2(finger.x_px, finger.y_px);
    const bool is_on_scene =
        in_window(second_px_) && std::isfinite(finger.x_px) && std::isfinite(finger.y_px);
    switch (finger.phase) {
        case window::TouchPhase::kBegin:
            lift_second(news);
            if (!is_on_scene || in_corner(second_px_) || target_at(second_px_) >= 0 ||
                !presses_.struck_at(place(second_px_)))
                return;
            second_down_ = true;
            second_ = haptics::ControlSense(kFingerStillPx);
            static_cast<void>(second_.moved_to(place(second_px_), 0.0));
            news.push_back({.kind = Kind::kSecondDown, .at_px = second_px_});
            return;
        case window::TouchPhase::kMove: {
            if (second_down_ && !is_on_scene) lift_second(news);
            if (!second_down_) return;
            const bool lives = second_.moved_to(place(second_px_), 0.0);
            news.push_back({.kind = Kind::kSecondMoved, .at_px = second_px_, .lives = lives});
            return;
        }
        case window::TouchPhase::kEnd:
            return lift_second(news);
    }
}

void KioskPointer::handle_pointer(const window::PointerEvent& pointer, double now_s,
                                  std::vector<PointerNews>& news) {
    if (!std::isfinite(pointer.x_px) || !std::isfinite(pointer.y_px)) {
        lift_finger(news);
        return;
    }
    at_px_ = vec2(pointer.x_px, pointer.y_px);
    if (!in_corner(at_px_)) corner_s_.reset();
    // The first position is no motion: a new window reports the place of a resting mouse.
    if (mouse_.moved_to(place(at_px_), 0.0)) {
        if (now_s - leapt_s_ < kOnItsWayS && !life_s_) life_s_ = now_s + kLandingS;
        leapt_s_ = now_s;
    }
    if (pressed_ >= 0) pressed_over_ = target_at(at_px_) == pressed_;
    if (finger_down_ && !in_window(at_px_)) lift_finger(news);
    if (finger_down_) {
        const bool lives = finger_.moved_to(place(at_px_), 0.0);
        news.push_back({.kind = Kind::kFingerMoved, .at_px = at_px_, .lives = lives});
    } else if (buttons_down_ == 0) {
        news.push_back({.kind = Kind::kHovered, .at_px = at_px_});
    }
}

void KioskPointer::handle_button(const window::ButtonEvent& button, double now_s,
                                 std::vector<PointerNews>& news) {
    const unsigned bit = 1U << static_cast<unsigned>(button.button);
    const bool is_alone = (buttons_down_ & ~bit) == 0;
    buttons_down_ = button.pressed ? buttons_down_ | bit : buttons_down_ & ~bit;
    if (button.pressed) lift_finger(news);  // a second button, or one whose release was lost
    if (button.button != window::MouseButton::kLeft) return;
    if (button.pressed) {
        if (!presses_.struck_at(place(at_px_))) return;
        scans_ = false;
        arrows_walk_ = false;
        focus_ = -1;
        if (in_corner(at_px_)) corner_s_ = now_s;
        pressed_ = target_at(at_px_);
        pressed_meaning_ = meaning_of(pressed_);
        pressed_over_ = pressed_ >= 0;
        pressed_key_ = screen_key_;
        pressed_s_ = now_s;
        repeat_s_ = now_s + kRepeatAfterS;
        has_repeated_ = false;
        finger_down_ = pressed_ < 0 && !corner_s_ && is_alone;
        finger_ = haptics::ControlSense(kFingerStillPx);
        static_cast<void>(finger_.moved_to(place(at_px_), 0.0));
        if (pressed_ >= 0) {
            life_s_.reset();
        } else {
            news.push_back({.kind = finger_down_ ? Kind::kFingerDown : Kind::kLife, .at_px = at_px_});
        }
        return;
    }
    corner_s_.reset();
    lift_finger(news);
    const bool counts =
        pressed_ >= 0 && pressed_ < target_count() && pressed_over_ && pressed_key_ == screen_key_;
    // A token that has repeated is not pressed again on release.
    if (counts && !has_repeated_) {
        const screens::Target& target = composition_->targets[static_cast<std::size_t>(pressed_)];
        news.push_back({Kind::kPressed, target.button, target.value, at_px_});
    }
    pressed_ = -1;
    pressed_over_ = false;
}

void KioskPointer::handle(const window::Event& event, double now_s, std::vector<PointerNews>& news) {
    advance(now_s);
    if (const auto* pointer = std::get_if<window::PointerEvent>(&event)) {
        handle_pointer(*pointer, now_s, news);
    } else if (const auto* button = std::get_if<window::ButtonEvent>(&event)) {
        handle_button(*button, now_s, news);
    } else if (const auto* second = std::get_if<window::SecondFingerEvent>(&event)) {
        handle_second(*second, news);
    } else if (const auto* key = std::get_if<window::KeyEvent>(&event)) {
        handle_key(*key, now_s, news);
    } else if (const auto* focus = std::get_if<window::FocusEvent>(&event)) {
        if (focus->focused) return;
        // A window without focus gets no release events.
        lift_finger(news);
        lift_second(news);
        buttons_down_ = 0;
        pressed_ = -1;
        pressed_over_ = false;
        corner_s_.reset();
        key_down_s_.reset();
    } else if (std::holds_alternative<window::ScrollEvent>(event)) {
        if (wheel_.struck_at(dvec3(0.0))) news.push_back({.kind = Kind::kLife});
    } else if (std::holds_alternative<window::CloseEvent>(event)) {
        news.push_back({.kind = Kind::kCloseAsked});
    }
}

void KioskPointer::pass_time(double now_s, std::vector<PointerNews>& news) {
    advance(now_s);
    if (pressed_ >= 0 && pressed_ < target_count() && pressed_over_ && pressed_key_ == screen_key_) {
        const screens::Target& target = composition_->targets[static_cast<std::size_t>(pressed_)];
        if (target.repeats && now_s >= repeat_s_ && now_s - pressed_s_ < kLongestStillS) {
            repeat_s_ = now_s + kRepeatEveryS;
            has_repeated_ = true;
            news.push_back({Kind::kPressed, target.button, target.value, at_px_});
        }
    }
    if (finger_down_ && finger_.still_s() >= kLongestStillS) lift_finger(news);
    if (second_down_ && second_.still_s() >= kLongestStillS) lift_second(news);
    if (life_s_ && now_s >= *life_s_) {
        life_s_.reset();
        news.push_back({.kind = Kind::kLife, .at_px = at_px_});
    }
    if (corner_s_ && now_s - *corner_s_ >= kCornerS) {
        corner_s_.reset();
        news.push_back({.kind = Kind::kCornerHeld});
    }
    if (scan_is_new_ || scan_waits_) scan_s_ = now_s;
    scan_is_new_ = false;
    if (scans_ && now_s - scan_s_ >= kScanEveryS) {
        scan_s_ = now_s;
        move_focus(1);
    }
}

}  // namespace onggi::app
