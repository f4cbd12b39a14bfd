#include "game/decoration/picking.h"

#include <algorithm>
#include <cmath>

namespace onggi::decoration {
namespace {

// A ring of the wall as a part of a cone: its radius at the middle of one row and of another.
struct Ring {
    double low_mm;
    double high_mm;
    double low_radius_mm;
    double high_radius_mm;
};

// The ray parameter of the first hit from outside; empty if the ray misses the ring.
std::optional<double> first_meeting(const Ring& ring, const dvec3& eye, const dvec3& ray) {
    const double rise = ring.high_mm - ring.low_mm;
    const double slope = (ring.high_radius_mm - ring.low_radius_mm) / rise;
    // x^2 + z^2 = (r0 + slope (y - y0))^2 along eye + t ray.
    const double base = ring.low_radius_mm + slope * (eye.y - ring.low_mm);
    const double grow = slope * ray.y;
    const double a = ray.x * ray.x + ray.z * ray.z - grow * grow;
    const double b = eye.x * ray.x + eye.z * ray.z - base * grow;
    const double c = eye.x * eye.x + eye.z * eye.z - base * base;
    const double root2 = b * b - a * c;
    if (root2 < 0.0 || std::abs(a) < 1e-12) return std::nullopt;
    const double root = std::sqrt(root2);
    std::optional<double> nearest;
    for (const double t : {(-b - root) / a, (-b + root) / a}) {
        if (t <= 0.0) continue;
        const double y = eye.y + t * ray.y;
        if (y < ring.low_mm || y > ring.high_mm) continue;
        // A hit is from outside if the ray runs against the outward normal.
        const double outward =
            (eye.x + t * ray.x) * ray.x + (eye.z + t * ray.z) * ray.z - slope * (base + grow * t) * ray.y;
        if (outward >= 0.0) continue;
        if (!nearest || t < *nearest) nearest = t;
    }
    return nearest;
}

double radius_of(const Wall& wall, int row) {
    return double{wall.round_mm[static_cast<std::size_t>(row)]} / kTurn;
}

}  // namespace

std::optional<WallPlace> pick(const Wall& wall, double scale, const dvec2& turned, const dvec3& eye_mm,
                              const dvec3& ray) {
    constexpr int kRowsARing = 4;
    const dvec3 eye = eye_mm / scale;
    const double row_mm = double{wall.height_mm} / kRows;
    std::optional<double> nearest;
    Ring met{};
    for (int row = 0; row + 1 < kRows; row += kRowsARing) {
        const int next = std::min(row + kRowsARing, kRows - 1);
        const Ring ring{(row + 0.5) * row_mm, (next + 0.5) * row_mm, radius_of(wall, row),
                        radius_of(wall, next)};
        const auto t = first_meeting(ring, eye, ray);
        if (!t || (nearest && *t >= *nearest)) continue;
        nearest = t;
        met = ring;
    }
    if (!nearest) return std::nullopt;
    const dvec3 at = eye + *nearest * ray;
    const double slope = (met.high_radius_mm - met.low_radius_mm) / (met.high_mm - met.low_mm);
    const double radius = std::hypot(at.x, at.z);
    const dvec3 normal = glm::normalize(dvec3(at.x / radius, -slope, at.z / radius));
    // Counter-clockwise from above is from +X towards -Z.
    const double angle = std::atan2(-at.z, at.x) - std::atan2(turned.y, turned.x);
    const double turns = angle / kTurn;
    return WallPlace{.turns = turns - std::floor(turns),
                     .height_mm = at.y,
                     .facing = -glm::dot(normal, glm::normalize(ray))};
}

dvec3 place_of(const Wall& wall, double scale, const dvec2& turned, double turns, double height_mm) {
    const double row =
        std::clamp(double{wall.row_of_height(static_cast<float>(height_mm))} - 0.5, 0.0, kRows - 1.0);
    const int below = static_cast<int>(row);
    const double radius =
        glm::mix(radius_of(wall, below), radius_of(wall, std::min(below + 1, kRows - 1)), row - below);
    const double angle = turns * kTurn + std::atan2(turned.y, turned.x);
    return scale * dvec3(radius * std::cos(angle), height_mm, -radius * std::sin(angle));
}

}  // namespace onggi::decoration
