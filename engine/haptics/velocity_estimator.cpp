#include "engine/haptics/velocity_estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace onggi::haptics {
namespace {

// The step of a device that states none: too small to feel, and far above the rounding of a double.
constexpr double kLeastStepMm = 0.002;

// The least time between two stored positions. Slightly below 1 ms, so that rounding does not decide which
// tick is stored.
constexpr double kSpacingS = 0.00095;

}  // namespace

VelocityEstimator::VelocityEstimator(double step_mm) : step_mm_(std::max(step_mm, kLeastStepMm)) {}

dvec3 VelocityEstimator::update(const dvec3& position_mm, double dt_s) noexcept {
    if (!(std::isfinite(position_mm.x) && std::isfinite(position_mm.y) && std::isfinite(position_mm.z)))
        return velocity_mm_s_;
    now_s_ += dt_s;
    dvec3 velocity_mm_s(0.0);
    dvec3 low(-std::numeric_limits<double>::infinity());
    dvec3 high(std::numeric_limits<double>::infinity());
    std::array<bool, 3> open{true, true, true};
    for (std::size_t back = 0; back < count_ && (open[0] || open[1] || open[2]); ++back) {
        const Sample& sample = samples_[(newest_ + kMost - back) % kMost];
        const double age_s = now_s_ - sample.time_s;
        if (back > 0 && age_s > kWindowS * 1.01) break;
        const double per_s = 1.0 / age_s;
        const dvec3 slope = (position_mm - sample.position_mm) * per_s;
        const double width = step_mm_ * per_s;
        for (int axis = 0; axis < 3; ++axis) {
            auto& is_open = open[static_cast<std::size_t>(axis)];
            if (!is_open) continue;
            // A line to this position would miss a newer one by more than a step, so the window ends before
            // it.
            is_open = slope[axis] >= low[axis] && slope[axis] <= high[axis];
            if (!is_open) continue;
            velocity_mm_s[axis] = slope[axis];
            low[axis] = std::max(low[axis], slope[axis] - width);
            high[axis] = std::min(high[axis], slope[axis] + width);
        }
    }
    if (count_ == 0 || now_s_ - samples_[newest_].time_s >= kSpacingS) {
        newest_ = (newest_ + 1) % kMost;
        samples_[newest_] = {.position_mm = position_mm, .time_s = now_s_};
        count_ = std::min(count_ + 1, kMost);
    }
    return velocity_mm_s_ = velocity_mm_s;
}

}  // namespace onggi::haptics
