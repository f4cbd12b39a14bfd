#include "game/wheel/tool_pose.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::wheel {
namespace {

constexpr double kDegree = kPi / 180.0;

// Follows the tool within the time that hides a device's steps; turns at a wrist's speed.
constexpr double kFollowS = 0.012;
constexpr double kTurnS = 0.10;
// A hand that follows a finger smooths over the screen's report interval, and moves more slowly while it
// hovers.
constexpr double kFollowFingerS = 0.03;
constexpr double kHoverS = 0.09;
constexpr double kLeapMm = 60.0;  // a longer jump makes the hand go and come back
constexpr double kLeaveS = 0.06;
constexpr double kComeS = 0.11;
constexpr double kGoneMm = 150.0;   // a hidden hand moves back this far, then is not drawn
constexpr double kChangeMm = 45.0;  // a hand that changes sides or tools moves back this far, then returns
constexpr double kSideChangeMm = 15.0;  // distance beyond the axis before the other hand takes over
// A hand needs this much of an opening. Below kNarrowMm it uses a sponge on a stick, until there is clearly
// room.
constexpr double kNarrowMm = 46.0;
constexpr double kWideMm = 52.0;
// Finger tips that hold the rim under a guiding finger need half that width.
constexpr double kTipsMm = 30.0;
// A tool at the front of the pot is held from the side, so that it hides nothing.
constexpr double kMostToFront = 25.0 * kDegree;
constexpr double kMostToBack = 60.0 * kDegree;
constexpr double kMostLean = 30.0 * kDegree;
constexpr double kFromAbove = 52.0 * kDegree;
constexpr double kDigs = 78.0 * kDegree;
constexpr double kFlatOnRim = 24.0 * kDegree;
// A hand beside a foot has the wheel below it, so its lean is limited to level there.
constexpr double kWheelClearanceMm = 12.0;
constexpr double kReachMm = 120.0;

double eased(double from, double to, double dt_s, double time_s) {
    return dt_s <= 0.0 ? to : to + (from - to) * std::exp(-dt_s / time_s);
}

// The largest lean outwards from upright for an arm from above: it must pass through the mouth, not the wall.
double most_lean_through_mouth(const DrawnHand& hand, const dvec3& touch) {
    constexpr double kShaftMm = 4.0;
    constexpr double kAtRimMm = 25.0;  // nearer to the rim there is no obstacle
    const double reach_mm = std::hypot(touch.x, touch.z);
    return std::atan2(hand.mouth_radius_mm - kShaftMm - reach_mm, std::max(hand.below_rim_mm, kAtRimMm));
}

double wrapped(double angle_rad) {
    return std::remainder(angle_rad, kTurn);
}

bool is_inside(tool::Side side) {
    return side == tool::Side::kIn;
}

// Horizontal direction from the axis; the visitor's right near the axis.
dvec2 outwards(const dvec3& at_mm) {
    const dvec2 flat(at_mm.x, at_mm.z);
    const double length = glm::length(flat);
    return length > 1.0 ? flat / length : dvec2(1.0, 0.0);
}

// Direction from the clay to the hand.
dvec3 reach_of(const dvec3& at_mm, tool::Side side) {
    if (side == tool::Side::kTop) return {0.0, 1.0, 0.0};
    const dvec2 out = outwards(at_mm);
    return is_inside(side) ? dvec3(-out.x, 0.0, -out.y) : dvec3(out.x, 0.0, out.y);
}

// Balls for the parts of a hand that are thick enough for a visible shadow, in its model's frame, mm.
struct Ball {
    vec3 at;
    float radius;
};
constexpr std::array<Ball, 2> kOuterBalls{Ball{{30.0F, 12.0F, 6.0F}, 15.0F},
                                          Ball{{104.0F, 36.0F, 40.0F}, 33.0F}};
constexpr Ball kInnerBall{{16.0F, 48.0F, 0.0F}, 17.0F};
constexpr Ball kToolBall{{22.0F, 0.0F, 0.0F}, 20.0F};

render::Sphere shadow_of(const Ball& ball, const mat4& place, bool left) {
    const vec3 at(ball.at.x, ball.at.y, left ? -ball.at.z : ball.at.z);
    return {.centre_mm = vec3(place * vec4(at, 1.0F)), .radius_mm = ball.radius};
}

// Place of the finger tips on a tool, from the clay, mm: outwards, and towards the visitor.
dvec2 tips_on(tool::Tool kind) {
    switch (kind) {
        case tool::Tool::kRib:
            return {17.0, 15.0};
        case tool::Tool::kSponge:
            return {23.0, 3.0};
        case tool::Tool::kHand:
        case tool::Tool::kTrimmer:
        case tool::Tool::kWire:
            break;
    }
    return {0.0, 0.0};
}

}  // namespace

mat4 placed(const dvec3& at_mm, double yaw_rad, double pitch_rad) {
    dmat4 place = glm::translate(dmat4(1.0), at_mm);
    place = glm::rotate(place, yaw_rad, dvec3(0.0, 1.0, 0.0));
    return mat4(glm::rotate(place, pitch_rad, dvec3(0.0, 0.0, 1.0)));
}

void ToolPose::settle(const DrawnHand& hand) {
    const tool::Side was = side_;
    const bool was_left = left_;
    const bool was_narrow = narrow_;
    if (hand.side != tool::Side::kFree) side_ = hand.side;
    if (!is_known_ && side_ == tool::Side::kFree) side_ = hand.is_second ? tool::Side::kIn : tool::Side::kOut;
    const bool only_tips = hand.guided && hand.below_rim_mm < kTipsMm;
    const double room_mm = only_tips ? 2.0 * hand.mouth_radius_mm : hand.mouth_radius_mm;
    if (room_mm < kNarrowMm) narrow_ = true;
    if (room_mm > kWideMm) narrow_ = false;
    // Outside, each hand works on its own side of the pot; inside, it reaches over and presses the other way.
    const double across = is_inside(side_) ? -hand.position_mm.x : hand.position_mm.x;
    if (!is_known_ || std::abs(across) > kSideChangeMm) left_ = across < 0.0;
    const bool changed = is_known_ && (tool_ != hand.tool || is_inside(was) != is_inside(side_) ||
                                       was_left != left_ || (is_inside(side_) && was_narrow != narrow_));
    tool_ = hand.tool;
    if (changed) away_mm_ = std::max(away_mm_, kChangeMm);
}

bool ToolPose::leaps_to(const DrawnHand& hand) const {
    const dvec3 touch = hand.position_mm - hand.radius_mm * reach_of(hand.position_mm, hand.side);
    return glm::length(touch - touch_mm_) > kLeapMm || is_inside(hand.side) != is_inside(side_);
}

void ToolPose::follow(const DrawnHand& hand, double dt_s) {
    if (is_known_ && dt_s > 0.0 && hand.guided && hand.shown && leaps_to(hand)) {
        away_mm_ = eased(away_mm_, 1.1 * kGoneMm, dt_s, kLeaveS);
        if (away_mm_ < kGoneMm) return;
        is_known_ = false;
    }
    const bool was_known = is_known_;
    settle(hand);
    is_known_ = true;

    const dvec2 out = outwards(hand.position_mm);
    const dvec2 normal = is_inside(side_) ? -out : out;
    const bool from_above = side_ == tool::Side::kTop;
    const dvec3 touch = hand.position_mm - hand.radius_mm * reach_of(hand.position_mm, side_);

    // Angle from straight sideways: positive is towards the back. The model's own +X points out of the clay.
    const bool leads_right = !left_;
    const double round = std::atan2(-normal.y, leads_right ? normal.x : -normal.x);
    const double held = std::clamp(round, -kMostToFront, kMostToBack);
    const double yaw = leads_right ? held : kPi - held;
    double lean = std::atan(hand.wall_lean) * (is_inside(side_) ? 0.6 : -0.6);
    double lowest = -std::asin(std::clamp((touch.y - kWheelClearanceMm) / kReachMm, 0.0, 1.0));
    if (hand.guided && is_inside(side_) && hand.below_rim_mm > 0.0) {
        lean = std::min(lean, most_lean_through_mouth(hand, touch));
        lowest = -kMostLean;  // a hand from above has no wheel below it
    }
    const double above = hand.digs ? kDigs : hand.guided ? kFlatOnRim : kFromAbove;
    const double pitch = from_above ? above : std::clamp(lean, std::max(lowest, -kMostLean), kMostLean);

    const double dt = was_known ? dt_s : 0.0;
    const bool jumps = away_mm_ >= kChangeMm;  // a hand that comes back takes its new angles at once
    const double follow_s = !hand.guided ? kFollowS : hand.touching ? kFollowFingerS : kHoverS;
    for (int axis = 0; axis < 3; ++axis)
        touch_mm_[axis] = eased(touch_mm_[axis], touch[axis], dt, follow_s);
    yaw_rad_ = jumps ? yaw : yaw_rad_ + eased(0.0, wrapped(yaw - yaw_rad_), dt, kTurnS);
    pitch_rad_ = jumps ? pitch : eased(pitch_rad_, pitch, dt, kTurnS);
    // In a moving picture a new hand comes from away.
    if (!was_known && dt_s > 0.0) away_mm_ = kGoneMm;
    away_mm_ = eased(away_mm_, hand.shown ? 0.0 : 1.1 * kGoneMm, dt_s, kComeS);
    if (hand.shown && away_mm_ < 0.05) away_mm_ = 0.0;
}

ToolPicture ToolPose::picture() const {
    ToolPicture picture;
    if (!is_known_ || away_mm_ >= kGoneMm) return picture;
    const bool inside = is_inside(side_);
    // Along the forearm, the way the hand came.
    const dvec3 back = inside ? dvec3(0.15, 1.0, 0.0) : dvec3(0.85, 0.15, left_ ? -0.45 : 0.45);
    const mat4 place = placed(touch_mm_, yaw_rad_, pitch_rad_);
    const auto at = [&](const dvec2& off_mm) {
        const dvec3 offset = back * away_mm_ + dvec3(off_mm.x, 0.0, left_ ? -off_mm.y : off_mm.y);
        return place * glm::translate(mat4(1.0F), vec3(offset));
    };
    const auto show = [&](ToolModel model, const dvec2& off_mm) {
        picture.tools.push_back({.model = model, .left = left_, .place = at(off_mm)});
    };
    const auto cast = [&](const Ball& ball, const dvec2& off_mm) {
        picture.shadows.push_back(shadow_of(ball, at(off_mm), left_));
    };
    constexpr dvec2 kAtClay(0.0);
    if (inside && narrow_) {
        show(ToolModel::kStick, kAtClay);
        cast(kToolBall, kAtClay);
        return picture;
    }
    if (tool_ == tool::Tool::kRib) show(ToolModel::kRib, kAtClay);
    if (tool_ == tool::Tool::kSponge) show(ToolModel::kSponge, kAtClay);
    if (tool_ == tool::Tool::kTrimmer) {
        // The model's handle hangs 24 degrees below level; a potter holds it the same angle above the wheel.
        show(ToolModel::kTrimmer, kAtClay);
        mat4& held = picture.tools.back().place;
        held = glm::rotate(held, static_cast<float>(48.0 * kDegree), vec3(0.0F, 0.0F, 1.0F));
        cast(kToolBall, kAtClay);
        return picture;
    }
    const dvec2 tips = tips_on(tool_);
    show(inside ? ToolModel::kHandInner : ToolModel::kHandOuter, tips);
    if (inside) {
        cast(kInnerBall, tips);
    } else {
        for (const Ball& ball : kOuterBalls)
            cast(ball, tips);
    }
    return picture;
}

}  // namespace onggi::wheel
