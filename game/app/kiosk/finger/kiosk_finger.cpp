#include "game/app/kiosk/finger/kiosk_finger.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "game/tool/tool.h"

namespace onggi::app {
namespace {

constexpr double kDrawnWithinMm = 6.0;
constexpr double kGrowsS = 0.5;

// Smooth weight: 1 at the outline, 0 from kDrawnWithinMm on.
double faded(double distance_mm) {
    const double fraction = std::min(std::abs(distance_mm) / kDrawnWithinMm, 1.0);
    const double rest = 1.0 - fraction * fraction;
    return rest * rest;
}

// Limits the finger to the pot and its surroundings.
constexpr double kReachMm = 260.0;
// Farther than a hand moves from one report to the next, or in a frame of 60 a second: another finger, or a
// faulty touch screen.
constexpr double kLeapMm = 120.0;
constexpr double kFrameS = 1.0 / 60.0;
constexpr double kRestsAfterS = 4.0;
constexpr dvec2 kRestingMm{230.0, 45.0};  // over the pan's edge, away from all clay
constexpr double kBesideMm = 15.0;
// Limits the queue, in case keys arrive faster than the hands work.
constexpr std::size_t kMostWaiting = 3;
constexpr std::array kToolRadiiMm{7.0, 12.0, 20.0};
constexpr std::array kLoopRadiiMm{4.0, 7.0, 11.0};
constexpr std::array kWater{0.0, 0.25, 0.5, 0.75, 1.0};
constexpr std::array kSpeedsRevMin{50.0, 80.0, 110.0, 145.0, 180.0};

constexpr double kWireBelowRimMm = 6.0;  // initial height of the wire
constexpr double kWireStepMm = 1.0;      // per key press
constexpr double kLowestCut = 0.5;       // fraction of the height

template <std::size_t count>
double step_of(const std::array<double, count>& steps, int step) {
    return steps[static_cast<std::size_t>(std::clamp(step - 1, 0, static_cast<int>(count) - 1))];
}

bool is_place(const dvec2& place_mm) {
    return std::isfinite(place_mm.x) && std::isfinite(place_mm.y);
}

dvec2 within_reach(const dvec2& place_mm) {
    return glm::clamp(place_mm, dvec2(-kReachMm, 0.0), dvec2(kReachMm, 2.0 * kReachMm));
}

}  // namespace

double outline_help_after(int steps_done) {
    constexpr double kLessEachStep = 0.15;
    return std::clamp(1.0 - kLessEachStep * steps_done, 0.0, 1.0);
}

void OutlineHelp::set(std::span<const vec2> radius_height, double strength) {
    strength_ = radius_height.size() < 2 || !std::isfinite(strength) ? 0.0 : std::clamp(strength, 0.0, 1.0);
    // The old outline stays while its help fades out.
    if (strength_ > 0.0) outline_mm_.assign(radius_height.begin(), radius_height.end());
}

void OutlineHelp::pass_time(double dt_s) {
    now_ += (strength_ - now_) * (dt_s / (dt_s + kGrowsS));
}

dvec2 OutlineHelp::drawn(const dvec2& finger_mm) const {
    if (outline_mm_.size() < 2 || now_ <= 0.0) return finger_mm;
    const double foot_mm = double{outline_mm_.front().y};
    const double rim_mm = double{outline_mm_.back().y};
    const double y_mm = std::clamp(finger_mm.y, foot_mm, std::max(foot_mm, rim_mm));
    std::size_t above = 1;
    while (above + 1 < outline_mm_.size() && double{outline_mm_[above].y} < y_mm)
        ++above;
    const vec2& low = outline_mm_[above - 1];
    const vec2& high = outline_mm_[above];
    const double rise_mm = double{high.y} - double{low.y};
    const double fraction = rise_mm > 0.0 ? std::clamp((y_mm - double{low.y}) / rise_mm, 0.0, 1.0) : 1.0;
    const double outline_mm = double{low.x} + fraction * (double{high.x} - double{low.x});
    const double away_mm = outline_mm - std::abs(finger_mm.x);
    const double pull_mm = now_ * away_mm * faded(away_mm) * faded(finger_mm.y - y_mm);
    return {std::copysign(std::max(0.0, std::abs(finger_mm.x) + pull_mm), finger_mm.x), finger_mm.y};
}

tool::ToolState resting_finger() {
    return {.position_mm = dvec3(kRestingMm, 0.0), .guided = true, .pressing = false};
}

void KioskFinger::take_over() {
    release();
    idle_s_ = 0.0;
}

void KioskFinger::begin(const dvec2& place_mm) {
    take_over();
    marker_.hide();
    if (!is_place(place_mm)) return;
    presser_ = Presser::kFinger;
    ++touches_;
    finger_mm_ = shown_before_mm_ = within_reach(place_mm);
    began_mm_ = finger_mm_;
}

void KioskFinger::follow(const dvec2& place_mm) {
    if (presser_ != Presser::kFinger || is_lifted_) return;
    if (!is_place(place_mm) || glm::length(within_reach(place_mm) - finger_mm_) > kLeapMm) {
        if (!passes_on()) release();
        return;
    }
    finger_mm_ = within_reach(place_mm);
    idle_s_ = 0.0;
}

bool KioskFinger::passes_on() {
    if (!finger_presses() || !other_mm_) return false;
    const bool second_leads = !second_leads_;
    const dvec2 place_mm = *other_mm_;
    begin(place_mm);
    second_leads_ = second_leads;
    return true;
}

void KioskFinger::end() {
    if (passes_on()) return;
    is_lifted_ = presser_ == Presser::kFinger && began_mm_;
    if (!is_lifted_) release();
}

void KioskFinger::follow_other(const dvec2& place_mm) {
    if (!other_mm_) return;
    const bool leaps = !is_place(place_mm) || glm::length(within_reach(place_mm) - *other_mm_) > kLeapMm;
    other_mm_ = leaps ? std::nullopt : std::optional(within_reach(place_mm));
}

void KioskFinger::press(const dvec2& place_mm) {
    if (!second_leads_ || !finger_presses()) return begin(place_mm);
    if (is_place(place_mm)) other_mm_ = within_reach(place_mm);
}

void KioskFinger::drag(const dvec2& place_mm) {
    second_leads_ ? follow_other(place_mm) : follow(place_mm);
}

void KioskFinger::lift() {
    second_leads_ ? other_mm_.reset() : end();
}

void KioskFinger::press_second(const dvec2& place_mm) {
    if (!is_place(place_mm)) return;
    if (finger_presses()) {
        other_mm_ = within_reach(place_mm);
    } else {
        begin(place_mm);
        second_leads_ = true;
    }
}

void KioskFinger::drag_second(const dvec2& place_mm) {
    second_leads_ ? follow(place_mm) : follow_other(place_mm);
}

void KioskFinger::lift_second() {
    second_leads_ ? end() : other_mm_.reset();
}

void KioskFinger::push(std::optional<double> pressure) {
    constexpr double kPressesFrom = 0.08;  // of a pen's range, about 30 g of most pens
    constexpr double kRestsBelow = 0.05;
    constexpr double kAsAFinger = 0.35;  // the pressure of ordinary writing
    constexpr double kFirmest = 1.6;
    if (!pressure || !std::isfinite(*pressure)) {
        push_ = 1.0;
        return;
    }
    const bool presses = *pressure >= (push_ > 0.0 ? kRestsBelow : kPressesFrom);
    const double push = (*pressure - kRestsBelow) / (kAsAFinger - kRestsBelow);
    push_ = presses ? std::clamp(push, tool::kLeastPush, kFirmest) : 0.0;
}

void KioskFinger::release() {
    presser_ = Presser::kNobody;
    other_mm_.reset();
    second_leads_ = false;
    began_mm_.reset();
    is_lifted_ = false;
    touch_.stop();
    waiting_.clear();
    shows_ = false;
}

void KioskFinger::hover(const dvec2& place_mm) {
    if (works() || !is_place(place_mm)) return;
    finger_mm_ = within_reach(place_mm);
    idle_s_ = 0.0;
}

void KioskFinger::steer(const dvec2& step_mm, bool presses, const pot::Pot& shape, double side) {
    const bool begins = presses && !pad_held_;
    pad_held_ = presses;
    const bool is_moved = is_place(step_mm) && step_mm != dvec2(0.0);
    if (presser_ == Presser::kFinger) return;
    if (presser_ == Presser::kGamepad && !presses) release();
    if (!is_moved && !begins) return;
    if (touch_.runs()) take_over();
    if (!pad_has_come_) {
        const double low_mm = kLowFraction * shape.height_mm;
        finger_mm_ = {side * (wall_at(shape, low_mm).outer_mm + kBesideMm), low_mm};
        pad_has_come_ = true;
    }
    marker_.hide();
    idle_s_ = 0.0;
    if (is_moved) finger_mm_ = within_reach(finger_mm_ + step_mm);
    if (!begins) return;
    presser_ = Presser::kGamepad;
    ++touches_;
}

void KioskFinger::ask_for(const WaitingKey& key) {
    if (presser_ != Presser::kNobody) return;
    stop_showing();
    idle_s_ = 0.0;
    if (waiting_.size() < kMostWaiting) waiting_.push_back(key);
}

void KioskFinger::show(kiosk::ShownStep step, const pot::Pot& shape, double side) {
    take_over();
    shows_ = true;
    ++touches_;
    touch_.begin(path_of_step(step, shape, side));
}

void KioskFinger::stop_showing() {
    if (!shows_) return;
    touch_.stop();
    shows_ = false;
}

void KioskFinger::leave_clay() {
    release();
    marker_.hide();
    pad_has_come_ = false;
}

void KioskFinger::work_off_keys(const pot::Pot& shape) {
    while (!waiting_.empty() && !touch_.runs()) {
        const WaitingKey key = waiting_.front();
        waiting_.pop_front();
        std::optional<TouchPath> path =
            key.is_button ? marker_.button(key.key, shape, key.side) : marker_.key(key.key, shape, key.side);
        if (path) {
            touch_.begin(std::move(*path));
            ++touches_;
        }
        finger_mm_ = path ? touch_.place_mm() : marker_.place_mm(shape).value_or(finger_mm_);
        idle_s_ = 0.0;
    }
}

// A slow frame may hold a long way of the finger.
void KioskFinger::drop_leap(double dt_s) {
    const double most_mm = kLeapMm * std::max(1.0, dt_s / kFrameS);
    if (presser_ == Presser::kFinger && glm::length(finger_mm_ - shown_before_mm_) > most_mm && !passes_on())
        release();
}

// The place of a finger or a gamepad in this frame: a touch's first place has a frame of its own.
dvec2 KioskFinger::take_place() {
    if (began_mm_) return *std::exchange(began_mm_, std::nullopt);
    if (is_lifted_ && shown_before_mm_ == finger_mm_) release();
    return finger_mm_;
}

// Follows a synthetic touch, else the pressing input, else goes aside.
dvec2 KioskFinger::finger_now(const pot::Pot& shape, double dt_s) {
    if (touch_.runs()) {
        touch_.pass_time(dt_s);
        finger_mm_ = touch_.place_mm();
        idle_s_ = 0.0;
        return finger_mm_;
    }
    shows_ = false;
    work_off_keys(shape);
    if (touch_.runs()) return finger_mm_;
    if (presser_ == Presser::kNobody) idle_s_ += dt_s;
    if (idle_s_ >= kRestsAfterS) return kRestingMm;
    shown_before_mm_ = take_place();
    return help_.drawn(shown_before_mm_);
}

// Separates two touches by one frame without pressing; otherwise the clay would take them for one.
bool KioskFinger::presses_now() {
    const bool presses = (finger_presses() ? push_ > 0.0 : presser_ != Presser::kNobody) || touch_.presses();
    const bool is_another = pressing_ && *pressing_ != touches_;
    pressing_ = presses && !is_another ? std::optional(touches_) : std::nullopt;
    return pressing_.has_value();
}

// A finger drags the wire's line, and a key moves it. Neither presses the clay.
void KioskFinger::hold_wire(const pot::Pot& shape) {
    if (!wire_mm_) wire_mm_ = shape.height_mm - kWireBelowRimMm;
    if (presser_ != Presser::kNobody) wire_mm_ = finger_mm_.y;
    for (const WaitingKey& key : waiting_) {
        if (key.key == FingerKey::kUp) *wire_mm_ += kWireStepMm;
        if (key.key == FingerKey::kDown) *wire_mm_ -= kWireStepMm;
    }
    waiting_.clear();
    wire_mm_ = std::clamp(*wire_mm_, kLowestCut * shape.height_mm, shape.height_mm);
}

tool::ToolState KioskFinger::request(const HeldTool& held, const pot::Pot& shape, double dt_s) {
    const bool holds_wire = held.tool == tool::Tool::kWire;
    const bool trims = held.tool == tool::Tool::kTrimmer;
    help_.pass_time(dt_s);
    drop_leap(dt_s);
    tool::ToolState tool;
    tool.guided = true;
    if (holds_wire) hold_wire(shape);
    tool.position_mm = dvec3(finger_now(shape, dt_s), 0.0);
    tool.pressing = presses_now() && !holds_wire;
    if (finger_presses() && push_ > 0.0) tool.position_mm.z = tool::z_of_push(push_);
    if (tool.pressing && other_mm_ && held.tool == tool::Tool::kHand)
        tool.second = {.present = true, .position_mm = dvec3(*other_mm_, 0.0)};
    marker_mm_ = holds_wire ? std::nullopt : marker_.place_mm(shape);
    tool.tool = holds_wire ? tool::Tool::kHand : held.tool;
    if (std::exchange(cuts_, false)) {
        tool.wire = tool::Wire::kCutRim;
        tool.wire_height_mm = *wire_mm_;
    }
    if (!holds_wire) wire_mm_.reset();
    tool.radius_mm = step_of(trims ? kLoopRadiiMm : kToolRadiiMm, held.size);
    tool.water = trims ? 0.0 : step_of(kWater, held.water);
    tool.wheel_speed_rev_min = step_of(kSpeedsRevMin, held.speed);
    tool.wheel_button = true;
    return tool;
}

}  // namespace onggi::app
