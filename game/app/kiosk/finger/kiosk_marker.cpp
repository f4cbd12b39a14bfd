#include "game/app/kiosk/finger/kiosk_marker.h"

#include <algorithm>
#include <cmath>

namespace onggi::app {
namespace {

constexpr double kWalkMm = 5.0;  // along the wall
constexpr double kIntoWallMm = 3.0;
constexpr double kPullMm = 6.0;
constexpr double kOpenMm = 8.0;
constexpr double kLowerMm = 6.0;
// Larger, because a single switch must wait for the scan before each press.
constexpr double kSwitchPullMm = 12.0;
constexpr double kLowestMm = 5.0;

}  // namespace

void KioskMarker::come(double side) {
    if (is_shown_) return;
    is_shown_ = true;
    is_over_ = false;
    side_ = side;
    fraction_ = kLowFraction;
}

// In small steps, because on a leaning wall a millimetre along the wall is less than that in height.
void KioskMarker::walk(double way_mm, const pot::Pot& shape) {
    constexpr double kFineMm = 0.5;
    const double height_mm = shape.height_mm;
    const double direction = way_mm < 0.0 ? -1.0 : 1.0;
    double y_mm = fraction_ * height_mm;
    double radius_mm = wall_at(shape, std::min(y_mm, height_mm - kFineMm)).outer_mm;
    for (double gone_mm = 0.0; gone_mm < std::abs(way_mm);) {
        const double next_mm = y_mm + direction * kFineMm;
        if (next_mm < kLowestMm) break;
        if (next_mm >= height_mm) {
            y_mm = height_mm;
            break;
        }
        const double next_radius_mm = wall_at(shape, next_mm).outer_mm;
        gone_mm += std::hypot(kFineMm, next_radius_mm - radius_mm);
        y_mm = next_mm;
        radius_mm = next_radius_mm;
    }
    fraction_ = height_mm > 0.0 ? y_mm / height_mm : kLowFraction;
}

std::optional<dvec2> KioskMarker::place_mm(const pot::Pot& shape) const {
    if (!is_shown_ || !(shape.height_mm > 0.0)) return std::nullopt;
    if (is_over_) return dvec2(0.0, shape.height_mm);
    const double radius_mm =
        is_at_rim() ? rim_of(shape).outer_mm : wall_at(shape, fraction_ * shape.height_mm).outer_mm;
    return dvec2(side_ * radius_mm, fraction_ * shape.height_mm);
}

TouchPath KioskMarker::move_wall(double direction, const pot::Pot& shape) const {
    // Stays below the rim, where a touch could press the rim down.
    constexpr double kOffRimMm = 6.0;
    const double y_mm =
        std::clamp(fraction_ * shape.height_mm, 0.0, std::max(0.0, shape.height_mm - kOffRimMm));
    return sideways_path({side_ * wall_at(shape, y_mm).outer_mm, y_mm}, direction * kIntoWallMm);
}

std::optional<TouchPath> KioskMarker::key(FingerKey key, const pot::Pot& shape, double side) {
    come(side);
    const double direction = key == FingerKey::kLeft ? -1.0 : 1.0;
    switch (key) {
        case FingerKey::kUp:
            if (is_at_rim() && !is_solid(shape)) {
                is_over_ = false;
                return pull_path(shape, side_, kPullMm);
            }
            if (is_at_rim()) {
                is_over_ = true;
            } else {
                walk(kWalkMm, shape);
            }
            return std::nullopt;
        case FingerKey::kDown:
            if (is_over_) return open_path(shape, side_, kOpenMm);
            walk(-kWalkMm, shape);
            return std::nullopt;
        case FingerKey::kLeft:
        case FingerKey::kRight:
            if (!is_over_) return move_wall(direction, shape);
            is_over_ = false;
            side_ = direction;
            return std::nullopt;
    }
    return std::nullopt;
}

TouchPath KioskMarker::button(FingerKey key, const pot::Pot& shape, double side) {
    come(side);
    is_over_ = false;
    switch (key) {
        case FingerKey::kUp:
            return pull_path(shape, side_, kSwitchPullMm);
        case FingerKey::kDown:
            return is_solid(shape) ? path_of_step(kiosk::ShownStep::kOpen, shape, side_)
                                   : lower_path(shape, side_, kLowerMm);
        case FingerKey::kLeft:
            return move_wall(-1.0, shape);
        case FingerKey::kRight:
            break;
    }
    return move_wall(1.0, shape);
}

}  // namespace onggi::app
