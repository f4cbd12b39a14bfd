#include "game/app/kiosk_hand.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::app {
namespace {

// The hand may go where the pot is and around it, not behind the picture.
constexpr double kReachMm = 260.0;
constexpr double kWaitsInFrontMm = 150.0;
constexpr double kAboveRimS = 0.18;
constexpr double kAboveRimMm = 30.0;
constexpr double kLowShare = 0.3;  // of the height: where the first move of the lesson presses
constexpr double kBesideMm = 4.0;
constexpr double kNudgeLastsS = 1.5;
constexpr double kAssistGapMm = 6.0;
constexpr std::array kToolRadiiMm{7.0, 12.0, 20.0};
constexpr std::array kWater{0.0, 0.25, 0.5, 0.75, 1.0};
constexpr std::array kSpeedsRevMin{50.0, 80.0, 110.0, 145.0, 180.0};

template <std::size_t count>
double step_of(const std::array<double, count>& steps, int step) {
    return steps[static_cast<std::size_t>(std::clamp(step - 1, 0, static_cast<int>(count) - 1))];
}

dvec3 within_reach(const dvec3& place_mm) {
    return glm::clamp(place_mm, dvec3(-kReachMm), dvec3(kReachMm, 2.0 * kReachMm, kReachMm));
}

}  // namespace

Wall wall_at(const haptic::PotShape& shape, double y_mm) {
    const auto outer = shape.outer_mm();
    if (outer.empty() || y_mm < 0.0 || y_mm >= shape.height_mm) return {};
    const auto tops = shape.top_mm();
    std::size_t ring = 0;
    if (tops.empty()) {
        ring = static_cast<std::size_t>(y_mm / shape.height_mm * static_cast<double>(outer.size()));
    } else {
        ring = static_cast<std::size_t>(std::upper_bound(tops.begin(), tops.end(), static_cast<float>(y_mm)) -
                                        tops.begin());
    }
    ring = std::min(ring, outer.size() - 1);
    const auto inner = shape.inner_mm();
    return {double{outer[ring]}, inner.empty() ? 0.0 : double{inner[ring]}};
}

void KioskHand::come(const dvec3& place_mm, const haptic::PotShape& shape) {
    place_mm_ = within_reach(place_mm);
    // A finger that lands within the mouth means the inside: the hand goes in from above.
    const Wall wall = wall_at(shape, std::min(place_mm_.y, shape.height_mm - 1.0));
    const double aside_mm = std::hypot(place_mm_.x, place_mm_.z);
    inside_ = wall.inner_mm > 0.0 && aside_mm < wall.inner_mm && place_mm_.y > shape.floor_mm;
    above_s_ = inside_ ? kAboveRimS : 0.0;
}

void KioskHand::press(const dvec3& place_mm, const haptic::PotShape& shape) {
    pressed_ = true;
    has_come_ = true;
    come(place_mm, shape);
}

void KioskHand::drag(const dvec3& place_mm) {
    place_mm_ = within_reach(place_mm);
}

void KioskHand::release() {
    pressed_ = false;
    inside_ = false;
    waiting_mm_ = place_mm_ + dvec3(0.0, 0.25 * kWaitsInFrontMm, kWaitsInFrontMm);
}

void KioskHand::hover(const dvec3& place_mm, const dvec3& towards_eye) {
    if (pressed_) return;
    waiting_mm_ = within_reach(place_mm) + kWaitsInFrontMm * towards_eye;
}

void KioskHand::come_beside(const haptic::PotShape& shape, double side) {
    const double low_mm = std::max(radius_mm_, kLowShare * shape.height_mm);
    place_mm_ = {side * (wall_at(shape, low_mm).outer_mm + radius_mm_ + kBesideMm), low_mm, 0.0};
    has_come_ = true;
}

void KioskHand::nudge(const dvec3& step_mm, const haptic::PotShape& shape, double side) {
    if (!has_come_) come_beside(shape, side);
    if (nudged_s_ <= 0.0 && !pressed_) come(place_mm_, shape);
    place_mm_ = within_reach(place_mm_ + step_mm);
    nudged_s_ = kNudgeLastsS;
}

haptics::ToolState KioskHand::wish(const HandSettings& settings, const haptic::PotShape& shape, double dt_s) {
    if (!pressed_) nudged_s_ = std::max(0.0, nudged_s_ - dt_s);
    haptics::ToolState tool;
    radius_mm_ = step_of(kToolRadiiMm, settings.tool);
    tool.radius_mm = radius_mm_;
    tool.water = step_of(kWater, settings.water);
    tool.wheel_speed_rev_min = step_of(kSpeedsRevMin, settings.speed);
    tool.wheel_button = true;
    tool.position_mm = works() ? place_mm_ : waiting_mm_;
    if (works() && inside_) {
        tool.side = haptics::SideHint::kInside;
        above_s_ = std::max(0.0, above_s_ - dt_s);
        if (above_s_ > 0.0) tool.position_mm.y = std::max(tool.position_mm.y, shape.height_mm + kAboveRimMm);
    }
    // One pointer throws with two hands: the other side of the wall is held.
    const Wall wall = wall_at(shape, tool.position_mm.y);
    if (works() && wall.inner_mm > 0.0) tool.assist_gap_mm = kAssistGapMm;
    // The tool rolls on the wheel head, it does not go through.
    tool.position_mm.y = std::max(tool.position_mm.y, tool.radius_mm);
    return tool;
}

}  // namespace onggi::app
