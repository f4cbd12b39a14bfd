// The outline of a pot for sharing: from thousands of radii to the few points that a smooth line needs. Any
// thread but the haptic one. mm.
#pragma once

#include <vector>

#include "engine/core/result.h"
#include "game/share/export.h"

namespace onggi::share {

// One corner of the outline: a circle of this radius at this height.
struct ProfilePoint {
    double y_mm = 0.0;
    double radius_mm = 0.0;

    friend bool operator==(const ProfilePoint&, const ProfilePoint&) = default;
};

// Bottom first, from y = 0 to y = height, heights never falling. Two points at one height are a ledge.
using Profile = std::vector<ProfilePoint>;

// What a shape may be, so that every pot within it becomes a mesh without degenerate triangles in float
// metres.
constexpr double kMinHeightMm = 1.0;
constexpr double kMaxHeightMm = 2000.0;
constexpr double kMinRadiusMm = 0.1;
constexpr double kMaxRadiusMm = 1000.0;
constexpr std::size_t kMaxElementCount = 200000;

// kBadInput naming the element or the measure that is outside the limits above.
Result<void> check_shape(const PotShape& shape);

// The full outline: through the middle of each element, straight between them, upright in the lower half of
// the first and the upper half of the last. The elements are a staircase only because there are finitely
// many; a step is kept as a ledge only where it is one: where a straight slope in its place would be steeper
// than 4 : 1 and would cost more than a thousandth of the two elements' clay. Precondition: check_shape.
Profile full_profile(const PotShape& shape);

// The same clay in `count` elements of equal height: each new one holds the volume that lay within its
// height. Precondition: 1 <= count <= number of radii.
std::vector<float> resampled(std::span<const float> radii_mm, std::size_t count);

// Fewer points, such that no radius of `profile` is off by more than tolerance_mm; one pass, however rough
// the outline. A ledge higher than twice the tolerance stays as it is; a lower one becomes a slope, off by at
// most twice the tolerance.
// Precondition: tolerance_mm < kMinRadiusMm, or the line might cross the axis.
Profile simplified(const Profile& profile, double tolerance_mm);

// Of the solid of revolution, mm^3: frustums, pi/3 dy (a^2 + a b + b^2).
[[nodiscard]] double volume_mm3(const Profile& profile);

}  // namespace onggi::share
