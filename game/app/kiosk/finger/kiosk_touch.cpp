#include "game/app/kiosk/finger/kiosk_touch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace onggi::app {
namespace {

// The steps of the lesson are measured on a lump of 1 kg with this foot; they scale with the lump.
constexpr double kLumpFootMm = 62.0;
constexpr double kComesS = 0.5;  // the hands approach before they press
constexpr double kStaysS = 0.3;  // the hands catch up with the finger before it is lifted
constexpr double kPressFromMm = 2.0;
constexpr double kPressToMm = 8.0;
constexpr double kPressS = 1.5;
constexpr double kOpenFloorMm = 15.0;
constexpr double kOpenAsideMm = 25.0;
constexpr double kOpenS = 2.0;
constexpr double kOpenDownFraction = 0.6;  // part of that time for the way down
constexpr double kRaiseMm = 40.0;
constexpr double kHighestRaiseMm = 190.0;
constexpr double kRaiseS = 2.5;
constexpr double kDrawnFromFraction = 0.2;  // of the height; below it the wheel head blocks a tool
constexpr double kDrawS = 3.6;

// The hands start after 3 mm of travel, and the offset between finger and wall at the touch decays. These
// values make a touch move the wall by the requested distance.
constexpr double kRunUpMm = 3.0;
constexpr double kBeyondFraction = 0.95;
constexpr double kSidewaysS = 0.25;
constexpr double kSidewaysStaysS = 0.15;

constexpr double kPullsBelowRimMm = 8.0;  // a pull starts below the zone that counts as the rim
constexpr double kPullMmPerS = 26.0;
constexpr double kPullStaysS = 0.25;
constexpr double kOpensByItselfS = 2.0;  // time of the other hand to open solid clay

constexpr double kDeepPerTravel = 1.5;  // depth of an opening per travel of the finger
constexpr double kDeepestFloorMm = 15.0;
constexpr double kOpenMmPerS = 24.0;  // resting thumbs keep opening
constexpr double kOpenEntersS = 0.5;

constexpr double kRimWithin = 0.8;  // of the outer radius; nearer the axis a touch opens a thick rim
constexpr double kLowerMmPerS = 12.0;
constexpr double kLowerStaysS = 0.4;

double scale_of(const pot::Pot& shape) {
    return std::clamp(wall_at(shape, 1.0).outer_mm / kLumpFootMm, 0.5, 2.0);
}

}  // namespace

TouchPath path_of_step(kiosk::ShownStep step, const pot::Pot& shape, double side) {
    const double scale = scale_of(shape);
    const double low_mm = kLowFraction * shape.height_mm;
    const double low_radius_mm = wall_at(shape, low_mm).outer_mm;
    const double top_mm = shape.height_mm;
    TouchPath path{.points = {}, .presses_from_s = kComesS};
    const auto goes = [&](double within_s, double radius_mm, double y_mm) {
        const double before_s = path.points.empty() ? 0.0 : path.points.back().at_s;
        path.points.push_back({before_s + within_s, {side * radius_mm, y_mm}});
    };
    switch (step) {
        case kiosk::ShownStep::kPress:
            goes(0.0, low_radius_mm + scale * kPressFromMm, low_mm);
            goes(kComesS, low_radius_mm + scale * kPressFromMm, low_mm);
            goes(kPressS, low_radius_mm - scale * kPressToMm, low_mm);
            break;
        case kiosk::ShownStep::kOpen:
            goes(0.0, 0.0, top_mm);
            goes(kComesS, 0.0, top_mm);
            goes(kOpenDownFraction * kOpenS, 0.0, kOpenFloorMm);
            goes((1.0 - kOpenDownFraction) * kOpenS, scale * kOpenAsideMm, kOpenFloorMm);
            break;
        case kiosk::ShownStep::kRaise:
            goes(0.0, low_radius_mm, low_mm);
            goes(kComesS, low_radius_mm, low_mm);
            goes(kRaiseS, rim_of(shape).outer_mm,
                 std::max(top_mm, std::min(top_mm + scale * kRaiseMm, scale * kHighestRaiseMm)));
            break;
        case kiosk::ShownStep::kDrawTool: {
            const double from_mm = kDrawnFromFraction * top_mm;
            goes(0.0, wall_at(shape, from_mm).outer_mm, from_mm);
            goes(kComesS, wall_at(shape, from_mm).outer_mm, from_mm);
            for (const double fraction : {0.4, 0.6, 0.8, 0.97})
                goes(kDrawS / 4.0, wall_at(shape, fraction * top_mm).outer_mm, fraction * top_mm);
            break;
        }
    }
    path.points.push_back({path.points.back().at_s + kStaysS, path.points.back().place_mm});
    return path;
}

TouchPath sideways_path(const dvec2& place_mm, double step_mm) {
    const dvec2 from = place_mm - dvec2(std::copysign(kRunUpMm, step_mm), 0.0);
    const dvec2 there = place_mm + dvec2(kBeyondFraction * step_mm, 0.0);
    return {.points = {{0.0, from}, {kSidewaysS, there}, {kSidewaysS + kSidewaysStaysS, there}},
            .presses_from_s = 0.0};
}

TouchPath pull_path(const pot::Pot& shape, double side, double rise_mm) {
    const double from_mm = std::max(0.5 * shape.height_mm, shape.height_mm - kPullsBelowRimMm);
    const double to_mm = shape.height_mm + (is_solid(shape) ? 2.0 : 1.0) * rise_mm;
    const double x_mm = side * rim_of(shape).outer_mm;
    const double there_s = (to_mm - from_mm) / kPullMmPerS;
    const double stays_s = is_solid(shape) ? kOpensByItselfS : kPullStaysS;
    return {.points = {{0.0, {x_mm, from_mm}}, {there_s, {x_mm, to_mm}}, {there_s + stays_s, {x_mm, to_mm}}},
            .presses_from_s = 0.0};
}

TouchPath open_path(const pot::Pot& shape, double side, double step_mm) {
    const double top_mm = shape.height_mm;
    if (shape.floor_mm > kDeepestFloorMm) {
        // Starts at the top and passes through the existing hollow.
        const double down_mm = (std::max(0.0, top_mm - shape.floor_mm) + step_mm) / kDeepPerTravel;
        return {.points = {{0.0, {0.0, top_mm}}, {down_mm / kOpenMmPerS, {0.0, top_mm - down_mm}}},
                .presses_from_s = 0.0};
    }
    const double wide_s = kOpenEntersS + step_mm / kOpenMmPerS;
    return {.points = {{0.0, {0.0, top_mm}},
                       {kOpenEntersS, {0.0, kDeepestFloorMm}},
                       {wide_s, {side * step_mm, kDeepestFloorMm}}},
            .presses_from_s = 0.0};
}

TouchPath lower_path(const pot::Pot& shape, double side, double step_mm) {
    const pot::Wall rim = rim_of(shape);
    const double x_mm = side * std::max(0.5 * (rim.outer_mm + rim.inner_mm), kRimWithin * rim.outer_mm);
    const double top_mm = shape.height_mm;
    const double there_s = step_mm / kLowerMmPerS;
    return {.points = {{0.0, {x_mm, top_mm}},
                       {there_s, {x_mm, top_mm - step_mm}},
                       {there_s + kLowerStaysS, {x_mm, top_mm - step_mm}}},
            .presses_from_s = 0.0};
}

void KioskTouch::begin(TouchPath path) {
    path_ = std::move(path);
    since_s_ = 0.0;
    if (runs()) place_mm_ = path_.points.front().place_mm;
}

void KioskTouch::pass_time(double dt_s) {
    if (!runs()) return;
    since_s_ += dt_s;
    const auto& points = path_.points;
    const auto next = std::find_if(points.begin(), points.end(),
                                   [&](const TouchPoint& point) { return point.at_s > since_s_; });
    if (next == points.end()) {
        place_mm_ = points.back().place_mm;
        stop();
    } else if (next != points.begin()) {
        const TouchPoint& before = *std::prev(next);
        const double fraction = (since_s_ - before.at_s) / (next->at_s - before.at_s);
        place_mm_ = glm::mix(before.place_mm, next->place_mm, glm::smoothstep(0.0, 1.0, fraction));
    }
}

}  // namespace onggi::app
