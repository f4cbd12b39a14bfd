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
constexpr double kLeastDishMm = 24.0;  // the same, of a pot that is wide
constexpr double kWideFromMm = 160.0;
constexpr double kThinnestMm = 2.5;
constexpr double kSteepest = 2.0;
constexpr double kMostSteep = 0.1;

// A good pot.
constexpr double kGoodMl = 150.0;
constexpr double kGoodFromMm = 6.0;  // above the floor
constexpr double kGoodThickestMm = 15.0;
constexpr double kGoodMeanMm = 10.0;
constexpr double kHollowMm = 8.0;

double outer_at(const clay::studio::Rings& rings, double y) {
    return rings.outer_mm[clay::studio::Rings::at(rings.ring_at(y))];
}

double middle_at(const clay::studio::Rings& rings, double y) {
    const std::size_t at = clay::studio::Rings::at(rings.ring_at(y));
    return 0.5 * (rings.outer_mm[at] + rings.inner_mm[at]);
}

// Measures the wall across its lean, every half millimetre.
void measure_wall(const clay::StudioClay& clay, Verdict& verdict) {
    constexpr double kStepMm = 0.5;
    constexpr double kSlopeMm = 2.0;  // to either side
    constexpr double kLipMm = 2.5;    // the round of the lip counts with its width
    const clay::studio::Rings& rings = clay.rings();
    const double floor = clay.floor_mm();
    const double top = clay.height_mm();
    double sum = 0.0;
    int count = 0;
    verdict.thinnest_up_mm = verdict.thinnest_mm;
    for (double y = floor + kGoodFromMm; y < top; y += kStepMm) {
        const double low = std::max(y - kSlopeMm, floor + 0.5);
        const double high = std::min(y + kSlopeMm, top - 0.01);
        const double slope = (middle_at(rings, high) - middle_at(rings, low)) / std::max(high - low, 0.1);
        const double wall = rings.wall_mm(rings.ring_at(y)) / std::sqrt(1.0 + slope * slope);
        verdict.thickest_up_mm = std::max(verdict.thickest_up_mm, wall);
        if (y < top - kLipMm) verdict.thinnest_up_mm = std::min(verdict.thinnest_up_mm, wall);
        sum += wall;
        ++count;
    }
    verdict.mean_wall_mm = count > 0 ? sum / count : 0.0;
    if (top - floor <= kHollowMm || count == 0)
        verdict.why_not_good = "is solid";
    else if (verdict.capacity_ml < kGoodMl)
        verdict.why_not_good = fmt::format("holds {:.0f} ml", verdict.capacity_ml);
    else if (verdict.thickest_up_mm > kGoodThickestMm)
        verdict.why_not_good = fmt::format("has {:.1f} mm of wall", verdict.thickest_up_mm);
    else if (verdict.mean_wall_mm > kGoodMeanMm)
        verdict.why_not_good = fmt::format("has {:.1f} mm of wall in the mean", verdict.mean_wall_mm);
    else if (verdict.thinnest_up_mm < kThinnestMm)
        verdict.why_not_good = fmt::format("is {:.1f} mm thin", verdict.thinnest_up_mm);
    verdict.is_good = verdict.why_not_good.empty();
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
    const bool is_wide = 2.0 * outer_at(rings, verdict.height_mm - 1.0) > kWideFromMm;
    if (verdict.capacity_ml < kLeastMl)
        verdict.why_not = fmt::format("holds {:.0f} ml", verdict.capacity_ml);
    else if (verdict.height_mm < (is_wide ? kLeastDishMm : kLeastHeightMm))
        verdict.why_not = fmt::format("stands {:.0f} mm", verdict.height_mm);
    else if (verdict.thinnest_mm < kThinnestMm)
        verdict.why_not = fmt::format("is {:.1f} mm thin", verdict.thinnest_mm);
    else if (verdict.steep_fraction > kMostSteep && !is_wide)
        verdict.why_not = fmt::format("leans on {:.0f} % of its height", 100.0 * verdict.steep_fraction);
    verdict.is_pot = verdict.why_not.empty();
    measure_wall(clay, verdict);
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
