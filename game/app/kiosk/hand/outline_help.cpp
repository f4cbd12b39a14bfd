#include "game/app/kiosk/hand/outline_help.h"

#include <algorithm>
#include <cmath>

namespace onggi::app {
namespace {

constexpr double kDrawnWithinMm = 6.0;
constexpr double kGrowsS = 0.5;

// 1 in the middle, and at the edge nothing, without a corner on the way.
double faded(double distance_mm) {
    const double fraction = std::min(std::abs(distance_mm) / kDrawnWithinMm, 1.0);
    const double rest = 1.0 - fraction * fraction;
    return rest * rest;
}

}  // namespace

double outline_help_after(int steps_done) {
    constexpr double kLessEachStep = 0.15;
    return std::clamp(1.0 - kLessEachStep * steps_done, 0.0, 1.0);
}

void OutlineHelp::set(std::span<const vec2> radius_height, double strength) {
    strength_ = radius_height.size() < 2 || !std::isfinite(strength) ? 0.0 : std::clamp(strength, 0.0, 1.0);
    // The old one stays while its help goes.
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

}  // namespace onggi::app
