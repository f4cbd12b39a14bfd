#include "game/heritage/jar.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace onggi::heritage {
namespace {

// A visitor's lump and typical wall thickness.
ThrownClay visitors_clay() {
    constexpr double kVisitorsWallMm = 8.0;
    return {.most_g = clay::StudioLump{}.mass_g, .wall_mm = kVisitorsWallMm};
}

}  // namespace

bool is_of_two_bowls(const Target& target) {
    return target.note == "two joined bowls";
}

JarOfTwo jar_of_two(const Target& target, clay::ClayBody body, const ThrownClay& clay) {
    constexpr int kSteps = 40;
    JarOfTwo jar{.size = thrown_size(target, body, {.most_g = 2.0 * clay.most_g, .wall_mm = clay.wall_mm}),
                 .bowl_mm = {},
                 .mouth_mm = 0.0};
    const auto widest = std::max_element(
        target.outline.begin(), target.outline.end(),
        [](const OutlinePoint& a, const OutlinePoint& b) { return a.radius_mm < b.radius_mm; });
    const double scale = jar.size.wet_scale;
    for (int i = 0; i <= kSteps; ++i) {
        const double y_mm = widest->y_mm * i / kSteps;
        jar.bowl_mm.emplace_back(target.radius_at(y_mm) * scale, y_mm * scale);
    }
    jar.mouth_mm = 2.0 * target.outline.back().radius_mm * scale;
    return jar;
}

JarOfTwo jar_of(const Target& target) {
    return jar_of_two(target, clay::ClayBody::kStoneware, visitors_clay());
}

ThrownSize size_on_this_wheel(const Target& target) {
    if (is_of_two_bowls(target)) return jar_of(target).size;
    return thrown_size(target, clay::ClayBody::kStoneware, visitors_clay());
}

std::vector<vec2> outline_of(const Target& target, double scale) {
    constexpr int kSteps = 40;
    std::vector<vec2> outline;
    for (int i = 0; i <= kSteps; ++i) {
        const double y_mm = target.height_mm * i / kSteps;
        outline.push_back(vec2(target.radius_at(y_mm) * scale, y_mm * scale));
    }
    return outline;
}

std::vector<vec2> wet_outline(const Target& target) {
    return outline_of(target, size_on_this_wheel(target).wet_scale);
}

double off_round_mm(const clay::StudioClay& clay) {
    const auto outer = clay.outer_mm();
    const auto widest = static_cast<int>(std::max_element(outer.begin(), outer.end()) - outer.begin());
    const dvec2 from_axis_mm = clay.centre_mm(widest) - clay.centre_mm(0);
    const auto residuals = clay.residuals_mm(widest);
    const int sectors = clay.sector_count();
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (int s = 0; s < sectors; ++s) {
        const double angle = kTurn * s / sectors;
        const double radius_mm = outer[static_cast<std::size_t>(widest)] +
                                 (residuals.empty() ? 0.0 : double{residuals[static_cast<std::size_t>(s)]});
        const double away_mm =
            glm::length(from_axis_mm + radius_mm * dvec2(std::cos(angle), std::sin(angle)));
        least = std::min(least, away_mm);
        most = std::max(most, away_mm);
    }
    return (most - least) * clay::shrunk_scale(clay.lump().body, clay::Firing::kGlaze);
}

}  // namespace onggi::heritage
