// See synthetic_pot.h.
#include "tests/unit/support/synthetic_pot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace onggi::support {
namespace {

constexpr double kPotHeightMm = 200.0;
constexpr double kViewHeightMm = 260.0;

double radius_mm(double y_mm) {
    return 45.0 + 12.0 * std::sin(y_mm * 0.025) + 0.5 * std::sin(y_mm * 0.7);
}

double srgb(double linear) {
    const double c = std::clamp(linear, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

using Colour = std::array<double, 3>;

// The linear colour of one sample: the wall under one lamp, or the background.
Colour sample(const PotPicture& picture, double x_mm, double y_mm) {
    const double radius = radius_mm(y_mm) + picture.wider_mm;
    if (y_mm < 0.0 || y_mm > kPotHeightMm || std::abs(x_mm) >= radius) return {0.05, 0.055, 0.06};
    const double side = x_mm / radius;
    const double slope = (radius_mm(y_mm + 0.01) - radius_mm(y_mm - 0.01)) / 0.02;
    const double length = std::sqrt(1.0 + slope * slope);
    const double nx = side / length;
    const double ny = -slope / length;
    const double nz = std::sqrt(1.0 - side * side) / length;
    // A lamp up left, and half way to the eye for the highlight.
    const double diffuse = std::max(0.0, -0.5 * nx + 0.4 * ny + 0.768 * nz);
    const double half = std::max(0.0, -0.266 * nx + 0.213 * ny + 0.940 * nz);
    const double shine = 0.12 * std::pow(half, 40.0);
    const double light = picture.light * diffuse;
    return {0.36 * (light + 0.08) + shine, 0.29 * (light + 0.08) + shine, 0.215 * (light + 0.08) + shine};
}

}  // namespace

asset::Image draw_pot(const PotPicture& picture) {
    constexpr std::array<std::array<double, 2>, 4> kSamples{
        {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}};
    const double mm_per_px = kViewHeightMm / picture.height;
    asset::Image image{picture.width, picture.height, {}};
    image.rgba.reserve(static_cast<std::size_t>(picture.width * picture.height) * 4);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            Colour sum{};
            for (const auto& [dx, dy] : kSamples) {
                const double x_mm = (x + dx - 0.5 * picture.width - picture.shift_px) * mm_per_px;
                const double y_mm = kViewHeightMm - 30.0 - (y + dy) * mm_per_px;
                const Colour colour = sample(picture, x_mm, y_mm);
                for (std::size_t c = 0; c < 3; ++c)
                    sum[c] += 0.25 * colour[c];
            }
            for (const double channel : sum) {
                image.rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0 * srgb(channel))));
            }
            image.rgba.push_back(255);
        }
    }
    return image;
}

}  // namespace onggi::support
