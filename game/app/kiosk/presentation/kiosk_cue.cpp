#include "game/app/kiosk/presentation/kiosk_cue.h"

#include <algorithm>
#include <cmath>

#include "game/app/kiosk/finger/kiosk_finger.h"

namespace onggi::app {
namespace {

using clay::studio::Grip;
using clay::studio::GripGuard;
using screens::CueGuard;

constexpr double kKnownAfterS = 1.5;  // time for which the clay must follow
constexpr double kAgainAfterS = 6.0;  // time for which it must not follow
constexpr double kFollowsMmS = 3.0;   // slower hands make no progress
constexpr double kGuardSaysS = 0.6;
constexpr double kEasesS = 0.06;
constexpr double kHoldMm = 12.0;       // above and below a finger on a wall
constexpr double kThumbsMm = 17.0;     // radius of the first opening
constexpr double kRimFraction = 0.3;   // fraction of the depth that a palm on the rim holds
constexpr double kFeltFraction = 0.5;  // beyond this fraction of their window, hands hardly move the clay

CueHold about(double y_mm, double height_mm) {
    const double low_mm = std::clamp(y_mm - kHoldMm, 0.0, std::max(0.0, height_mm - 2.0 * kHoldMm));
    return {.low_mm = low_mm, .high_mm = std::min(low_mm + 2.0 * kHoldMm, height_mm)};
}

CueHold opening_of(const pot::Pot& shape) {
    const double mouth_mm = wall_at(shape, shape.height_mm - 0.5).inner_mm;
    return {
        .low_mm = shape.floor_mm, .high_mm = shape.height_mm, .opening_mm = std::max(kThumbsMm, mouth_mm)};
}

// The range that working hands hold, without the margin of their window, where they hardly move the clay.
CueHold hold_of_grip(const clay::studio::GripReport& grip, const pot::Pot& shape) {
    if (grip.grip == Grip::kOpen) return opening_of(shape);
    CueHold hold{.low_mm = grip.low_mm, .high_mm = std::min(grip.high_mm, shape.height_mm)};
    if (!grip.pulls && (grip.grip == Grip::kWall || grip.grip == Grip::kInside)) {
        const double y_mm = std::clamp(grip.hand_mm.y, hold.low_mm, hold.high_mm);
        const auto felt = [](double reach_mm) {
            return std::max(kFeltFraction * reach_mm, std::min(kHoldMm, reach_mm));
        };
        hold = {.low_mm = y_mm - felt(y_mm - hold.low_mm), .high_mm = y_mm + felt(hold.high_mm - y_mm)};
    }
    return hold;
}

CueGuard words_of(GripGuard guard) {
    switch (guard) {
        case GripGuard::kNone:
            break;
        case GripGuard::kNoMoreClay:
            return CueGuard::kNoMoreClay;
        case GripGuard::kAsNarrow:
            return CueGuard::kAsNarrow;
        case GripGuard::kAsWide:
            return CueGuard::kAsWide;
        case GripGuard::kAsLow:
            return CueGuard::kAsLow;
        case GripGuard::kNearLimit:
            return CueGuard::kNearLimit;
        case GripGuard::kAsHigh:
            return CueGuard::kAsHigh;
    }
    return CueGuard::kNone;
}

}  // namespace

std::optional<CueHold> hold_of_touch(const pot::Pot& shape, const dvec2& finger_mm, bool with_tool) {
    const auto& outer = shape.outer_mm;
    if (outer.empty() || finger_mm.y < 0.0) return std::nullopt;
    const double top_mm = shape.height_mm;
    const pot::Wall rim = wall_at(shape, top_mm - 0.01);
    const double y_mm = std::min(finger_mm.y, top_mm - 0.01);
    constexpr double kNearMm = 30.0;
    if (with_tool) {
        const bool is_near =
            std::abs(finger_mm.x) < wall_at(shape, y_mm).outer_mm + kNearMm && finger_mm.y < top_mm + kNearMm;
        return is_near ? std::optional(about(y_mm, top_mm)) : std::nullopt;
    }
    const Grip grip = clay::studio::grip_of_touch({.height_mm = top_mm,
                                                   .floor_mm = shape.floor_mm,
                                                   .outer_mm = wall_at(shape, y_mm).outer_mm,
                                                   .rim_outer_mm = rim.outer_mm,
                                                   .rim_inner_mm = rim.inner_mm},
                                                  finger_mm);
    switch (grip) {
        case Grip::kNone:
            break;
        case Grip::kOpen:
            return opening_of(shape);
        case Grip::kRim:
            return CueHold{top_mm - std::max(kHoldMm, kRimFraction * (top_mm - shape.floor_mm)), top_mm};
        case Grip::kAsking:
        case Grip::kWall:
        case Grip::kInside:
            return about(y_mm, top_mm);
    }
    return std::nullopt;
}

CueHold hold_of_step(const pot::Pot& shape, int step) {
    constexpr int kOpens = 1;
    return step == kOpens ? opening_of(shape) : about(kLowFraction * shape.height_mm, shape.height_mm);
}

std::optional<CueThread> thread_of(const clay::studio::GripReport& grip) {
    constexpr double kTogetherMm = 10.0;  // a hand hides a finger that is closer than this
    constexpr double kApartMm = 18.0;
    if (grip.grip == Grip::kNone) return std::nullopt;
    const double apart_mm = glm::length(grip.finger_mm - grip.hand_mm);
    if (!(apart_mm > kTogetherMm)) return std::nullopt;
    return CueThread{.finger_mm = grip.finger_mm,
                     .hand_mm = grip.hand_mm,
                     .strength = std::min((apart_mm - kTogetherMm) / (kApartMm - kTogetherMm), 1.0)};
}

void KioskCue::follow_progress(const CueMoment& moment, double dt_s) {
    const clay::studio::GripReport& grip = moment.grip;
    const double way_mm = glm::length(grip.hand_mm - hand_mm_);
    const bool follows =
        grip.grip != Grip::kNone && grip.guard == GripGuard::kNone && way_mm > kFollowsMmS * dt_s;
    hand_mm_ = grip.hand_mm;
    if (follows) came_on_s_ += dt_s;
    stood_s_ = follows ? 0.0 : stood_s_ + dt_s;
    if (stood_s_ >= kAgainAfterS) came_on_s_ = 0.0;
    is_known_ = came_on_s_ >= kKnownAfterS;
}

void KioskCue::follow_guard(const CueMoment& moment, double dt_s) {
    const bool same = moment.grip.guard == guard_ && moment.grip.grip != Grip::kNone;
    guard_s_ = same ? guard_s_ + dt_s : 0.0;
    guard_ = moment.grip.guard;
}

CueHold KioskCue::eased(const CueHold& hold, const CueMoment& moment, double dt_s) {
    const bool jumps = moment.still || !shown_ || (shown_->opening_mm > 0.0) != (hold.opening_mm > 0.0);
    const double fraction = jumps ? 1.0 : 1.0 - std::exp(-dt_s / kEasesS);
    const CueHold from = jumps ? hold : *shown_;
    return {.low_mm = from.low_mm + fraction * (hold.low_mm - from.low_mm),
            .high_mm = from.high_mm + fraction * (hold.high_mm - from.high_mm),
            .opening_mm = from.opening_mm + fraction * (hold.opening_mm - from.opening_mm)};
}

std::optional<CuePlace> KioskCue::look(const CueMoment& moment) {
    const double dt_s = std::clamp(moment.now_s - last_s_, 0.0, 0.1);
    last_s_ = moment.now_s;
    follow_progress(moment, dt_s);
    follow_guard(moment, dt_s);
    const clay::studio::GripReport& grip = moment.grip;
    // Who leads the hand by keys sees where it is, also while it works.
    CuePlace place{.marker_mm = moment.is_shown ? std::nullopt : moment.marker_mm};
    if (grip.grip != Grip::kNone) {
        if (guard_ != GripGuard::kNone && guard_s_ >= kGuardSaysS) place.guard = words_of(guard_);
        if (!moment.is_shown) place.thread = thread_of(grip);
        place.hand_side = grip.hand_mm.x < 0.0 ? -1.0 : 1.0;
        if (!is_known_ || moment.is_shown || place.guard != CueGuard::kNone)
            place.hold = grip.grip == Grip::kAsking ? hold_of_touch(moment.shape, grip.finger_mm)
                                                    : hold_of_grip(grip, moment.shape);
    } else {
        if (!moment.marker_mm) place.step = moment.wanted_step;
        if (moment.marker_mm) {
            place.hold = hold_of_touch(moment.shape, *moment.marker_mm, moment.with_tool);
        } else if (moment.hovers_mm && (!is_known_ || moment.wanted_step || moment.with_tool)) {
            place.hold = hold_of_touch(moment.shape, *moment.hovers_mm, moment.with_tool);
        }
        if (!place.hold && moment.wanted_step) place.hold = hold_of_step(moment.shape, *moment.wanted_step);
    }
    if (!place.hold) {
        shown_.reset();
        return place.thread || place.marker_mm ? std::optional(place) : std::nullopt;
    }
    place.hold = shown_ = eased(*place.hold, moment, dt_s);
    return place;
}

}  // namespace onggi::app
