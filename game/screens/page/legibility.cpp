#include "game/screens/page/legibility.h"

#include <algorithm>
#include <cmath>

#include "game/screens/page/design.h"
#include "game/screens/page/layout.h"

namespace onggi::screens {
namespace {

constexpr double kDegreesPerRad = 180.0 / kPi;

}  // namespace

double px_per_mm(int width_px, int height_px, double diagonal_inch) {
    constexpr double kMmPerInch = 25.4;
    return std::hypot(width_px, height_px) / (diagonal_inch * kMmPerInch);
}

double capital_degrees(double size_u, double mm_per_u, double distance_mm) {
    return kDegreesPerRad * std::atan(size_u * mm_per_u * design::kCapitalFraction / distance_mm);
}

double smallest_text_degrees(int width_px, int height_px, double px_per_mm, double distance_mm) {
    const double mm_per_u = static_cast<double>(px_per_u_of(width_px, height_px)) / px_per_mm;
    return capital_degrees(double{design::kLeastTextSize}, mm_per_u, distance_mm);
}

double smallest_target_mm(int width_px, int height_px, double px_per_mm) {
    return double{design::kLeastTarget} * double{px_per_u_of(width_px, height_px)} / px_per_mm;
}

float legible_scale(double mm_per_u, double distance_mm) {
    constexpr double kMostScale = 2.0;
    const double capital_mm = distance_mm * std::tan(kLeastCapitalDegrees / kDegreesPerRad);
    const double size_u = capital_mm / (design::kCapitalFraction * mm_per_u);
    return static_cast<float>(std::clamp(size_u / double{design::kLeastTextSize}, 1.0, kMostScale));
}

}  // namespace onggi::screens
