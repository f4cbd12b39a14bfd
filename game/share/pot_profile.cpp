// See pot_profile.h. Any thread but the haptic one.
#include "game/share/pot_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "game/share/slope_range.h"

namespace onggi::share {
namespace {

constexpr double kLedgeSteepness = 4.0;
constexpr double kLedgeVolumeShare = 1e-3;

// Replacing a step between two elements by a straight slope takes pi h/6 (a - b)^2 of clay away; the halves
// of the two elements that it spans hold pi h/2 (a^2 + b^2).
bool is_ledge(double below_mm, double above_mm, double element_height_mm) {
    const double step = std::abs(below_mm - above_mm);
    const double lost_share = step * step / (3.0 * (below_mm * below_mm + above_mm * above_mm));
    return step > kLedgeSteepness * element_height_mm && lost_share > kLedgeVolumeShare;
}

ProfilePoint on_line(const ProfilePoint& anchor, double slope, double y_mm) {
    return {y_mm, anchor.radius_mm + slope * (y_mm - anchor.y_mm)};
}

// Thins one stretch of rising heights, [first, last], and appends it: one line after another, each as long as
// its range of slopes lasts.
void append_thinned(Profile& out, const ProfilePoint* first, const ProfilePoint* last, double tolerance_mm) {
    out.push_back(*first);
    ProfilePoint anchor = *first;
    SlopeRange slopes;
    for (const ProfilePoint* point = first + 1; point <= last;) {
        if (slopes.pass(point->y_mm - anchor.y_mm, point->radius_mm - anchor.radius_mm, tolerance_mm)) {
            ++point;
            continue;
        }
        // Never at the first point after an anchor: there the range is still open on both sides.
        anchor = on_line(anchor, slopes.end(), (point - 1)->y_mm);
        out.push_back(anchor);
        slopes = {};
    }
    if (last != first) out.push_back(on_line(anchor, slopes.end(), last->y_mm));
}

}  // namespace

double clay_volume_mm3(const PotShape& shape) {
    if (shape.radii_mm.empty()) return 0.0;
    double sum_of_squares = 0.0;
    for (const float radius_mm : shape.radii_mm)
        sum_of_squares += double{radius_mm} * double{radius_mm};
    return std::numbers::pi * sum_of_squares * shape.height_mm / static_cast<double>(shape.radii_mm.size());
}

Result<void> check_shape(const PotShape& shape) {
    if (!(shape.height_mm >= kMinHeightMm && shape.height_mm <= kMaxHeightMm)) {
        return bad_input(fmt::format("pot: expected a height of {} to {} mm, found {}", kMinHeightMm,
                                     kMaxHeightMm, shape.height_mm));
    }
    if (shape.radii_mm.empty() || shape.radii_mm.size() > kMaxElementCount) {
        return bad_input(
            fmt::format("pot: expected 1 to {} elements, found {}", kMaxElementCount, shape.radii_mm.size()));
    }
    for (std::size_t i = 0; i < shape.radii_mm.size(); ++i) {
        const double radius_mm{shape.radii_mm[i]};
        if (!(radius_mm >= kMinRadiusMm && radius_mm <= kMaxRadiusMm)) {
            return bad_input(fmt::format("pot: element {}: expected a radius of {} to {} mm, found {}", i,
                                         kMinRadiusMm, kMaxRadiusMm, radius_mm));
        }
    }
    return {};
}

std::vector<float> resampled(std::span<const float> radii_mm, std::size_t count) {
    // Heights are measured in the elements of the result, squares summed from below: each new element takes
    // from each old one the share that it covers.
    const double old_height = static_cast<double>(count) / static_cast<double>(radii_mm.size());
    std::vector<double> squares(count, 0.0);
    for (std::size_t i = 0; i < radii_mm.size(); ++i) {
        const double square = double{radii_mm[i]} * double{radii_mm[i]};
        const double top = static_cast<double>(i + 1) * old_height;
        double from = static_cast<double>(i) * old_height;
        for (auto at = static_cast<std::size_t>(from); at < count && from < top; ++at) {
            const double to = std::min(top, static_cast<double>(at + 1));
            squares[at] += (to - from) * square;
            from = to;
        }
    }
    std::vector<float> out;
    out.reserve(count);
    for (const double square : squares)
        out.push_back(static_cast<float>(std::sqrt(square)));
    return out;
}

Profile full_profile(const PotShape& shape) {
    const std::size_t count = shape.radii_mm.size();
    const double element_height_mm = shape.height_mm / static_cast<double>(count);
    Profile profile;
    profile.reserve(count + 2);
    profile.push_back({0.0, double{shape.radii_mm.front()}});
    for (std::size_t i = 0; i < count; ++i) {
        const double radius_mm{shape.radii_mm[i]};
        if (i > 0) {
            const double below_mm{shape.radii_mm[i - 1]};
            if (is_ledge(below_mm, radius_mm, element_height_mm)) {
                const double boundary_mm = static_cast<double>(i) * element_height_mm;
                profile.push_back({boundary_mm, below_mm});
                profile.push_back({boundary_mm, radius_mm});
            }
        }
        profile.push_back({(static_cast<double>(i) + 0.5) * element_height_mm, radius_mm});
    }
    profile.push_back({shape.height_mm, double{shape.radii_mm.back()}});
    return profile;
}

Profile simplified(const Profile& profile, double tolerance_mm) {
    // A ledge that the tolerance swallows is two points at one height, which a line cannot pass: they become
    // one between them.
    Profile rising;
    rising.reserve(profile.size());
    for (const ProfilePoint& point : profile) {
        const bool on_last = !rising.empty() && point.y_mm <= rising.back().y_mm;
        if (on_last && std::abs(point.radius_mm - rising.back().radius_mm) <= 2.0 * tolerance_mm) {
            rising.back().radius_mm = 0.5 * (rising.back().radius_mm + point.radius_mm);
        } else {
            rising.push_back(point);
        }
    }
    Profile out;
    const ProfilePoint* const end = rising.data() + rising.size();
    for (const ProfilePoint* first = rising.data(); first < end;) {
        const ProfilePoint* last = first;
        while (last + 1 < end && (last + 1)->y_mm > last->y_mm)
            ++last;
        append_thinned(out, first, last, tolerance_mm);
        first = last + 1;
    }
    return out;
}

double volume_mm3(const Profile& profile) {
    double sum = 0.0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const double a = profile[i - 1].radius_mm;
        const double b = profile[i].radius_mm;
        sum += (profile[i].y_mm - profile[i - 1].y_mm) * (a * a + a * b + b * b) / 3.0;
    }
    return std::numbers::pi * sum;
}

}  // namespace onggi::share
