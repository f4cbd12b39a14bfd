#include "game/app/kiosk/finger/device_strokes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace onggi::app {
namespace {

constexpr double kStrokeMm = 30.0;
constexpr double kBackMm = 15.0;
constexpr double kRestsBelowMmS = 40.0;
constexpr double kRestsS = 0.15;

constexpr std::array<std::pair<dvec3, Stroke>, 5> kWays{{{{-1.0, 0.0, 0.0}, Stroke::kLeft},
                                                         {{1.0, 0.0, 0.0}, Stroke::kRight},
                                                         {{0.0, 1.0, 0.0}, Stroke::kPress},
                                                         {{0.0, 0.0, -1.0}, Stroke::kPress},
                                                         {{0.0, 0.0, 1.0}, Stroke::kAsk}}};

}  // namespace

bool DeviceStrokes::rests(const dvec3& tip_mm, double dt_s) {
    const double moved_mm = last_mm_ ? glm::length(tip_mm - *last_mm_) : 0.0;
    rests_s_ = last_mm_ && moved_mm <= kRestsBelowMmS * dt_s ? rests_s_ + dt_s : 0.0;
    last_mm_ = tip_mm;
    return rests_s_ >= kRestsS;
}

Stroke DeviceStrokes::look(const std::optional<dvec3>& tip_mm, double dt_s) {
    if (!tip_mm) {
        *this = {};
        return Stroke::kNone;
    }
    const bool is_at_rest = rests(*tip_mm, dt_s);
    if (!middle_mm_) {
        if (is_at_rest) middle_mm_ = *tip_mm;
        return Stroke::kNone;
    }
    const dvec3 from_middle_mm = *tip_mm - *middle_mm_;
    if (way_ != dvec3(0.0)) {
        const double along_mm = glm::dot(way_, from_middle_mm);
        farthest_mm_ = std::max(farthest_mm_, along_mm);
        turned_back_ = turned_back_ || farthest_mm_ - along_mm >= kBackMm;
        if (!turned_back_ || !is_at_rest) return Stroke::kNone;
        middle_mm_ = *tip_mm;
        way_ = dvec3(0.0);
        return Stroke::kNone;
    }
    const auto along = [&](const auto& way) { return glm::dot(way.first, from_middle_mm); };
    const auto* const longest = std::max_element(
        kWays.begin(), kWays.end(), [&](const auto& a, const auto& b) { return along(a) < along(b); });
    if (along(*longest) < kStrokeMm) return Stroke::kNone;
    way_ = longest->first;
    farthest_mm_ = along(*longest);
    turned_back_ = false;
    return longest->second;
}

}  // namespace onggi::app
