#include "game/sharing/outline_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace onggi::sharing {
namespace {

constexpr std::size_t kMostPoints = 160;
constexpr double kMostMm = 2000.0;

bool is_drawn(const OutlinePoint& point) {
    // Not-a-number is no number from 0 to kMostMm.
    return point.radius_mm >= 0.0 && point.radius_mm <= kMostMm && std::abs(point.height_mm) <= kMostMm;
}

std::vector<OutlinePoint> thinned(std::span<const OutlinePoint> outline) {
    const auto* end = outline.data();
    while (end != outline.data() + outline.size() && is_drawn(*end))
        ++end;
    const auto count = static_cast<std::size_t>(end - outline.data());
    std::vector<OutlinePoint> points;
    const std::size_t kept = std::min(count, kMostPoints);
    for (std::size_t i = 0; i < kept; ++i)
        points.push_back(outline[kept < 2 ? 0 : i * (count - 1) / (kept - 1)]);
    return points;
}

double height_of(const std::vector<OutlinePoint>& points) {
    double most = 0.0;
    for (const OutlinePoint& point : points)
        most = std::max(most, point.height_mm);
    return most;
}

double radius_of(const std::vector<OutlinePoint>& points) {
    double most = 0.0;
    for (const OutlinePoint& point : points)
        most = std::max(most, point.radius_mm);
    return most;
}

// Up the right side and down the left.
std::string path_of(const std::vector<OutlinePoint>& points, double middle, double foot, double scale) {
    std::string path;
    const auto add = [&](const OutlinePoint& point, double side) {
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L',
                            middle + side * point.radius_mm * scale, foot - point.height_mm * scale);
    };
    for (const OutlinePoint& point : points)
        add(point, 1.0);
    for (auto point = points.rbegin(); point != points.rend(); ++point)
        add(*point, -1.0);
    return path + "Z";
}

}  // namespace

std::string outline_numbers(std::span<const OutlinePoint> outline) {
    std::string text;
    for (const OutlinePoint& point : thinned(outline)) {
        if (!text.empty()) text += ' ';
        // As short as they can be: 54.2, 5.
        const auto tenth = [](double value) { return std::round(value * 10.0) / 10.0 + 0.0; };
        text += fmt::format("{},{}", tenth(point.radius_mm), tenth(point.height_mm));
    }
    return text;
}

std::string two_pots_svg(std::span<const OutlinePoint> ours, std::span<const OutlinePoint> nearest) {
    constexpr double kWidth = 132.0;
    constexpr double kHeight = 112.0;
    constexpr double kBoard = 4.0;
    constexpr double kGap = 10.0;
    const auto our_points = thinned(ours);
    const auto their_points = thinned(nearest);
    const double wide = 2.0 * (radius_of(our_points) + radius_of(their_points));
    const double high = std::max(height_of(our_points), height_of(their_points));
    if (our_points.size() < 2 || their_points.size() < 2 || wide <= 0.0 || high <= 0.0) return {};
    const double scale = std::min((kWidth - kGap) / wide, (kHeight - kBoard - 2.0) / high);
    const double left = (kWidth - kGap - wide * scale) / 2.0;
    const double foot = kHeight - kBoard;
    const double our_middle = left + radius_of(our_points) * scale;
    const double their_middle = kWidth - left - radius_of(their_points) * scale;
    return fmt::format(
        "<svg viewBox=\"0 0 {0} {1}\" aria-hidden=\"true\"><path class=\"ours\" d=\"{2}\"/>"
        "<path class=\"theirs\" d=\"{3}\"/><path class=\"board\" d=\"M0 {4}H{0}\"/></svg>",
        kWidth, kHeight, path_of(our_points, our_middle, foot, scale),
        path_of(their_points, their_middle, foot, scale), kHeight - kBoard / 2.0);
}

}  // namespace onggi::sharing
