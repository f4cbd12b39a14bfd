#include "game/app/kiosk/finger/device_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace onggi::app {
namespace {

constexpr double kStrokeMm = 30.0;
constexpr double kBackMm = 15.0;
constexpr double kStaysMm = 8.0;  // a hand at rest trembles
constexpr double kRestsS = 0.6;   // slower than kStaysMm in this time is rest and no stroke
constexpr double kPausesS = 0.15;

constexpr std::array<std::pair<dvec3, Stroke>, 5> kWays{{{{-1.0, 0.0, 0.0}, Stroke::kLeft},
                                                         {{1.0, 0.0, 0.0}, Stroke::kRight},
                                                         {{0.0, 1.0, 0.0}, Stroke::kPress},
                                                         {{0.0, 0.0, -1.0}, Stroke::kPress},
                                                         {{0.0, 0.0, 1.0}, Stroke::kAsk}}};

}  // namespace

bool DeviceStrokes::comes_to_rest(const dvec3& tip_mm, double dt_s) {
    const double before_s = stayed_s_;
    const bool stays = stayed_at_mm_ && glm::distance(tip_mm, *stayed_at_mm_) <= kStaysMm;
    stayed_s_ = stays ? before_s + dt_s : 0.0;
    if (!stays) stayed_at_mm_ = tip_mm;
    return before_s < kRestsS && stayed_s_ >= kRestsS;
}

Stroke DeviceStrokes::look(const std::optional<dvec3>& tip_mm, double dt_s) {
    if (!tip_mm) {
        *this = {};
        return Stroke::kNone;
    }
    if (comes_to_rest(*tip_mm, dt_s)) {
        if (way_ != dvec3(0.0)) {
            held_ = turned_back_ ? dvec3(0.0) : way_;
        } else if (middle_mm_ && glm::dot(held_, *middle_mm_ - *tip_mm) >= kBackMm) {
            held_ = dvec3(0.0);
        }
        way_ = dvec3(0.0);
        middle_mm_ = *tip_mm;
    }
    if (!middle_mm_) return Stroke::kNone;
    const dvec3 from_middle_mm = *tip_mm - *middle_mm_;
    if (way_ != dvec3(0.0)) {
        const double along_mm = glm::dot(way_, from_middle_mm);
        farthest_mm_ = std::max(farthest_mm_, along_mm);
        turned_back_ = turned_back_ || farthest_mm_ - along_mm >= kBackMm;
        if (turned_back_ && std::abs(along_mm) <= kBackMm && stayed_s_ >= kPausesS) way_ = dvec3(0.0);
        return Stroke::kNone;
    }
    const auto along = [&](const auto& way) { return glm::dot(way.first, from_middle_mm); };
    const auto* const longest = std::max_element(
        kWays.begin(), kWays.end(), [&](const auto& a, const auto& b) { return along(a) < along(b); });
    if (along(*longest) < kStrokeMm) return Stroke::kNone;
    way_ = longest->first;
    farthest_mm_ = along(*longest);
    turned_back_ = std::exchange(held_, dvec3(0.0)) == -way_;
    return turned_back_ ? Stroke::kNone : longest->second;
}

}  // namespace onggi::app
