#include "game/app/kiosk/visit/visit_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/haptics/control_sense.h"
#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/screens/page/layout.h"
#include "game/visit/flow/step.h"
#include "game/visit/throw/throw.h"

namespace onggi::app {

namespace event = kiosk::event;

namespace {

constexpr double kWorksOnS = 1.0;  // slow work changes less often than once a frame

using kiosk::Button;
using visit::Finger;
using visit::finger_is_hand;
using visit::open_finger;
using visit::step_of;

// Swaps up and down for a pot on its rim.
Button upright(Button button, const kiosk::State& state) {
    if (step_of(state.screen).finger != Finger::kFoot) return button;
    if (button == Button::kHandUp) return Button::kHandDown;
    return button == Button::kHandDown ? Button::kHandUp : button;
}

FingerKey finger_key(Button button) {
    switch (button) {
        case Button::kHandUp:
            return FingerKey::kUp;
        case Button::kHandDown:
            return FingerKey::kDown;
        case Button::kHandLeft:
            return FingerKey::kLeft;
        default:
            return FingerKey::kRight;
    }
}

}  // namespace

std::optional<dvec2> place_at(const wheel::LiveView& view, vec2 px) {
    const auto place = view.tool_target_mm(double{px.x}, double{px.y});
    if (!place) return std::nullopt;
    return dvec2(std::copysign(std::hypot(place->x, place->z), place->x), place->y);
}

bool VisitInput::hovers(double now_s) const {
    constexpr double kHoversS = 4.0;  // a mouse at rest for longer is ignored
    return now_s - hovered_s_ < kHoversS;
}

bool VisitInput::holder_lives(double now_s) const {
    const double lived_s = parts_.devices.holder().empty() ? finger_lived_s_ : device_lived_s_;
    return now_s - lived_s < kWorksOnS;
}

void VisitInput::nudge(Button button) {
    keys_lead_ = true;
    const FingerKey key = finger_key(upright(button, flow_.state()));
    if (step_of(flow_.state().screen).finger == Finger::kFoot) {
        finger_.key(key, side_of(flow_.state()));  // a trimmer follows the wall and does not raise it
    } else {
        finger_.button(key, side_of(flow_.state()));
    }
}

std::optional<dvec2> VisitInput::finger_place(vec2 px) const {
    const auto place = place_at(parts_.view, px);
    return place && step_of(flow_.state().screen).finger == Finger::kFoot ? trim_.turned(*place) : place;
}

void VisitInput::help_along() {
    const std::optional<int> target =
        parts_.settings.config.visit.forgiving && step_of(flow_.state().screen).finger == Finger::kClay
            ? flow_.state().throwing.target
            : std::nullopt;
    const int steps_done = flow_.state().throwing.steps_done;
    const kiosk::JarStep jar = flow_.state().throwing.jar.step;
    if (target == helped_ && steps_done == helped_steps_ && jar == helped_jar_) return;
    helped_ = target;
    helped_steps_ = steps_done;
    helped_jar_ = jar;
    if (!target) {
        finger_.set_outline({}, 0.0);
        return;
    }
    finger_.set_outline(jar_.outline(), outline_help_after(steps_done));
}

bool VisitInput::take_drawing(const PointerNews& news) {
    switch (news.kind) {
        case PointerNews::Kind::kFingerDown:
            keys_lead_ = false;
            flow_.dispatch(event::Input{});
            drawing_.press(news.at_px);
            return true;
        case PointerNews::Kind::kFingerMoved:
            if (news.lives) flow_.dispatch(event::Input{});
            drawing_.drag(news.at_px);
            return true;
        case PointerNews::Kind::kFingerUp:
            drawing_.release();
            return true;
        case PointerNews::Kind::kHovered:
            keys_lead_ = false;
            drawing_.hover(news.at_px);
            return true;
        case PointerNews::Kind::kNudged:
            pointer_.leave_ring();
            flow_.dispatch(event::Pressed{news.button});
            return true;
        case PointerNews::Kind::kPutDown:
            flow_.dispatch(event::Pressed{Button::kPutBrush});
            return true;
        default:
            return false;
    }
}

bool VisitInput::walks(Button arrow) {
    const Finger finger = open_finger(flow_.state());
    if (finger == Finger::kBowl) return false;
    const bool is_hand = finger_is_hand(flow_.state()) || finger == Finger::kBrush;
    if (is_hand && !pointer_.arrows_walk()) return false;
    pointer_.walk(arrow);
    return true;
}

bool VisitInput::begins_on_bench(vec2 px) {
    bench_ = {};  // a touch may have ended on another screen
    if (open_finger(flow_.state()) != Finger::kClay) return false;
    const auto tool = bench_tool_at(bench_tools(parts_, flow_.state()), px);
    if (tool) {
        const float px_per_u = screens::px_per_u_of(parts_.view.width(), parts_.view.height());
        bench_.begin(*tool, px, kTapU * px_per_u);
    }
    return tool.has_value();
}

void VisitInput::touch_clay(vec2 px, void (KioskFinger::*press)(const dvec2&)) {
    keys_lead_ = false;
    flow_.dispatch(event::ClayTouched{});
    if (const auto place = finger_place(px)) (finger_.*press)(*place);
}

void VisitInput::take_arrow(const PointerNews& news) {
    if (open_finger(flow_.state()) == Finger::kBowl) flow_.dispatch(event::Pressed{news.button});
    if (!finger_is_hand(flow_.state())) return;
    if (news.lives) flow_.dispatch(event::ClayTouched{});
    keys_lead_ = true;
    finger_.key(finger_key(upright(news.button, flow_.state())), side_of(flow_.state()));
}

void VisitInput::take_news(const PointerNews& news, double now_s) {
    using Kind = PointerNews::Kind;
    const bool is_of_nobody =
        news.kind == Kind::kFingerUp || news.kind == Kind::kSecondUp || news.kind == Kind::kHovered;
    if (news.lives && !is_of_nobody) finger_lived_s_ = now_s;
    if (news.kind == Kind::kNudged && walks(news.button)) return;
    if (open_finger(flow_.state()) == Finger::kBrush && take_drawing(news)) return;
    switch (news.kind) {
        case PointerNews::Kind::kNone:
            break;
        case PointerNews::Kind::kPutDown:
            if (finger_is_hand(flow_.state())) pointer_.begin_walk();
            break;
        case PointerNews::Kind::kLife:
            flow_.dispatch(event::Input{.by_key = news.value == 1});
            break;
        case PointerNews::Kind::kPressed:
            flow_.dispatch(event::Pressed{news.button, news.value});
            break;
        case PointerNews::Kind::kFingerDown:
            if (!begins_on_bench(news.at_px) && finger_is_hand(flow_.state())) {
                touch_clay(news.at_px, &KioskFinger::press);
            } else {
                flow_.dispatch(event::Input{});
            }
            break;
        case PointerNews::Kind::kFingerMoved:
            if (!finger_is_hand(flow_.state()) && open_finger(flow_.state()) != Finger::kLooks) break;
            if (news.lives) flow_.dispatch(event::Input{});
            if (bench_.becomes_drag(news.at_px) && finger_is_hand(flow_.state()))
                touch_clay(news.at_px, &KioskFinger::press);
            if (const auto place = finger_place(news.at_px)) finger_.drag(*place);
            break;
        case PointerNews::Kind::kFingerUp:
            if (const auto tool = bench_.lift(); tool && open_finger(flow_.state()) == Finger::kClay)
                flow_.dispatch(event::Pressed{Button::kTakeTool, static_cast<int>(visit::tray_place(*tool))});
            finger_.lift();
            break;
        case PointerNews::Kind::kSecondDown:
            flow_.dispatch(event::Input{});
            if (open_finger(flow_.state()) == Finger::kClay &&
                !bench_tool_at(bench_tools(parts_, flow_.state()), news.at_px))
                touch_clay(news.at_px, &KioskFinger::press_second);
            break;
        case PointerNews::Kind::kSecondMoved:
            if (news.lives) flow_.dispatch(event::Input{});
            if (const auto place = finger_place(news.at_px)) finger_.drag_second(*place);
            break;
        case PointerNews::Kind::kSecondUp:
            finger_.lift_second();
            break;
        case PointerNews::Kind::kHovered:
            hovered_s_ = now_s;
            keys_lead_ = false;
            if (const auto place = finger_place(news.at_px)) finger_.hover(*place);
            break;
        case PointerNews::Kind::kNudged:
            take_arrow(news);
            break;
        case PointerNews::Kind::kCornerHeld:
            flow_.dispatch(event::CornerHeld{});
            break;
        case PointerNews::Kind::kCloseAsked:
            flow_.dispatch(event::CloseAsked{});
            break;
        case PointerNews::Kind::kStopForce:
            parts_.job.stop_force();
            break;
        case PointerNews::Kind::kWhere:
            asks_where_ = true;
            flow_.dispatch(event::Input{});
            break;
        case PointerNews::Kind::kFullScreen:
            if (parts_.settings.rules.locked) break;
            full_screen_ = !full_screen_;
            parts_.view.set_full_screen(full_screen_);
            break;
    }
}

void VisitInput::take(const VisitMoment& moment) {
    std::vector<PointerNews> all;
    for (const window::Event& event : parts_.view.poll_events())
        pointer_.handle(event, moment.now_s, all);
    pointer_.pass_time(moment.now_s, all);
    for (const PointerNews& news : all)
        take_news(news, moment.now_s);
    take_pen();
    const clay::studio::GripReport& grip = moment.snapshot.result.grip;
    const bool holds = moment.snapshot.tool.pressing && grip.grip != clay::studio::Grip::kNone;
    parts_.view.keep_fingers(holds, holds && grip.has_second);
    take_devices(moment);
    take_strokes(moment);
    take_gamepads(moment);
    name_restless(moment.now_s);
    help_along();
    if (!finger_is_hand(flow_.state())) finger_.release();
}

// The pressure of a pen is the push, and its tilt the hand's.
void VisitInput::take_pen() {
    const std::optional<window::Pen> pen = parts_.view.pen();
    finger_.push(pen ? std::optional(pen->pressure) : std::nullopt);
    parts_.view.scene().tilt_hand(pen ? pen->tilt_rad : dvec2(0.0));
}

void VisitInput::take_devices(const VisitMoment& moment) {
    for (const std::string& line : parts_.devices.news())
        flow_.say(line);
    const bool has_device = parts_.devices.has_device();
    if (has_device != had_device_) flow_.dispatch(event::Device{.is_there = has_device});
    had_device_ = has_device;
    // If another device has the tool, the finger's next motion begins another touch.
    const std::string holder = parts_.devices.holder();
    if (!holder.empty() && holder != holder_) finger_.release();
    // A step is shown from its beginning, once the device is at rest that asked for it.
    const kiosk::State& state = flow_.state();
    if (holder.empty() && !holder_.empty() && finger_.shows() && state.throwing.shown)
        finger_.show(*state.throwing.shown, *moment.snapshot.pot, side_of(state));
    holder_ = holder;
    if (!parts_.devices.somebody_moved()) return;
    device_lived_s_ = moment.now_s;
    flow_.dispatch(event::Input{});
}

// Who finds no button on a screen works them by strokes of the device. At the clay they are above it, so that
// no stroke of a hand at work counts.
void VisitInput::take_strokes(const VisitMoment& moment) {
    constexpr double kAboveRimMm = 40.0;
    constexpr double kStaysMm = 15.0;  // lower than it came
    const kiosk::State& state = flow_.state();
    const dvec3& tip_mm = moment.snapshot.tool.position_mm;
    const bool was_there = device_is_at_buttons_;
    const double above_mm = kAboveRimMm - (was_there ? kStaysMm : 0.0);
    const Finger finger = open_finger(state);
    device_is_at_buttons_ = state.comfort.speech && !parts_.devices.holder().empty() &&
                            step_of(state.screen).whose == visit::Whose::kVisitor &&
                            (finger != Finger::kClay || tip_mm.y > moment.snapshot.pot->height_mm + above_mm);
    if (was_there && !device_is_at_buttons_) pointer_.leave_ring();
    const Stroke stroke =
        strokes_.look(device_is_at_buttons_ ? std::optional(tip_mm) : std::nullopt, moment.dt_s);
    if (stroke == Stroke::kNone) return;
    if (stroke == Stroke::kAsk) asks_where_ = true;
    const auto language = static_cast<std::size_t>(state.comfort.language);
    const bool right_to_left = (*parts_.settings.languages)[language].right_to_left();
    const Stroke forward = right_to_left ? Stroke::kLeft : Stroke::kRight;
    std::vector<PointerNews> all;
    const auto press = [&](window::Key key) {
        pointer_.handle(window::KeyEvent{.key = key, .pressed = true}, moment.now_s, all);
        pointer_.handle(window::KeyEvent{.key = key, .pressed = false}, moment.now_s, all);
    };
    if (stroke == Stroke::kLeft || stroke == Stroke::kRight)
        press(stroke == forward ? window::Key::kRightBracket : window::Key::kLeftBracket);
    if (stroke == Stroke::kPress && pointer_.focus() >= 0) press(window::Key::kEnter);
    for (const PointerNews& news : all)
        take_news(news, moment.now_s);
}

// Not while anybody is there, whose hand may be what does not rest.
void VisitInput::name_restless(double now_s) {
    restless_ = parts_.devices.restless();
    for (auto& names : {gamepads_.restless(), pointer_.restless()})
        restless_.insert(restless_.end(), names.begin(), names.end());
    const auto is_in = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    std::erase_if(named_, [&](const std::string& name) {
        if (is_in(restless_, name)) return false;
        flow_.say(fmt::format("device: {} is at rest again", name));
        return true;
    });
    const kiosk::State& state = flow_.state();
    const bool is_alone = step_of(state.screen).whose == visit::Whose::kNobody &&
                          now_s - state.screen_s >= haptics::kControlRestsS;
    for (const std::string& name : restless_) {
        if (!is_alone || is_in(named_, name)) continue;
        flow_.warn(fmt::format("device: {} does not come to rest; it no longer keeps the kiosk awake", name));
        named_.push_back(name);
    }
}

void VisitInput::take_gamepads(const VisitMoment& moment) {
    std::vector<window::Gamepad> pads = parts_.view.gamepads();
    std::erase_if(pads,
                  [&](const auto& pad) { return parts_.devices.drives(pad.vendor_id, pad.product_id); });
    const GamepadRequest request = gamepads_.request(pads, moment.dt_s);
    const std::vector<window::KeyEvent> keys = keys_of(request);
    std::vector<PointerNews> all;
    for (const window::KeyEvent& key : keys)
        pointer_.handle(key, moment.now_s, all);
    for (const PointerNews& news : all)
        take_news(news, moment.now_s);
    if (request.is_used) finger_lived_s_ = moment.now_s;
    if (request.is_used && keys.empty()) flow_.dispatch(event::Input{});
    if (!finger_is_hand(flow_.state())) return;
    if (request.is_for_clay) flow_.dispatch(event::ClayTouched{});
    const double up = step_of(flow_.state().screen).finger == Finger::kFoot ? -1.0 : 1.0;
    finger_.steer(request.step_mm * dvec2(1.0, up), request.presses, *moment.snapshot.pot,
                  side_of(flow_.state()));
    if (request.radius_steps > 0.5) flow_.dispatch(event::Pressed{Button::kToolMore});
    if (request.radius_steps < -0.5) flow_.dispatch(event::Pressed{Button::kToolLess});
    if (request.speed_steps > 0.5) flow_.dispatch(event::Pressed{Button::kSpeedMore});
    if (request.speed_steps < -0.5) flow_.dispatch(event::Pressed{Button::kSpeedLess});
    if (request.fresh_lump) flow_.dispatch(event::Pressed{Button::kNewClay});
}

}  // namespace onggi::app
