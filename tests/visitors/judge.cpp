#include "tests/visitors/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "game/app/command_line/performance.h"
#include "game/clay/studio/pot.h"

namespace onggi::visitors {
namespace {

constexpr double kLeastMl = 60.0;
constexpr double kLeastHeightMm = 45.0;
constexpr double kThinnestMm = 2.5;
constexpr double kSteepest = 2.0;
constexpr double kMostSteep = 0.1;

double outer_at(const clay::studio::Rings& rings, double y) {
    return rings.outer_mm[clay::studio::Rings::at(rings.ring_at(y))];
}

}  // namespace

Verdict judge(const clay::StudioClay& clay, const std::vector<dvec2>& drawn) {
    const clay::studio::Rings& rings = clay.rings();
    const clay::PotMeasures measures = clay::measure_pot(rings, clay.lump().body);
    Verdict verdict{.height_mm = clay.height_mm(),
                    .capacity_ml = measures.capacity_ml,
                    .thinnest_mm = measures.thinnest_wall_mm,
                    .thickest_mm = measures.thickest_wall_mm};
    // Over a millimetre, the scale at which a slope is visible.
    int steep = 0;
    int steps = 0;
    for (double y = 0.5; y + 1.0 < verdict.height_mm; y += 1.0) {
        ++steps;
        if (std::fabs(outer_at(rings, y + 1.0) - outer_at(rings, y)) > kSteepest) ++steep;
    }
    verdict.steep_fraction = steps > 0 ? static_cast<double>(steep) / steps : 1.0;
    if (!drawn.empty()) {
        double sum = 0.0;
        int count = 0;
        for (const dvec2& point : drawn) {
            // Clay above the drawn rim, or missing below it, counts with its radius as the error.
            const double radius = point.y <= verdict.height_mm ? outer_at(rings, point.y) : 0.0;
            const double off = std::min(std::fabs(radius - point.x), 60.0);
            sum += off * off;
            ++count;
        }
        const double over = std::max(verdict.height_mm - drawn.back().y, 0.0);
        verdict.drawn_rms_mm = std::sqrt((sum + over * over) / count);
    }
    if (verdict.capacity_ml < kLeastMl)
        verdict.why_not = fmt::format("holds {:.0f} ml", verdict.capacity_ml);
    else if (verdict.height_mm < kLeastHeightMm)
        verdict.why_not = fmt::format("stands {:.0f} mm", verdict.height_mm);
    else if (verdict.thinnest_mm < kThinnestMm)
        verdict.why_not = fmt::format("is {:.1f} mm thin", verdict.thinnest_mm);
    else if (verdict.steep_fraction > kMostSteep)
        verdict.why_not = fmt::format("leans on {:.0f} % of its height", 100.0 * verdict.steep_fraction);
    verdict.is_pot = verdict.why_not.empty();
    return verdict;
}

Result<Verdict> judge_session(const std::string& file) {
    const auto pot = app::start_pot({.on = file});
    if (!pot) return pot.error();
    return judge(pot->value(), {});
}

std::string words_for(const Verdict& verdict) {
    return fmt::format(
        "{:.0f} ml, {:.0f} mm high, walls {:.1f} to {:.1f} mm, steep on {:.0f} % of its height",
        verdict.capacity_ml, verdict.height_mm, verdict.thinnest_mm, verdict.thickest_mm,
        100.0 * verdict.steep_fraction);
}

}  // namespace onggi::visitors
