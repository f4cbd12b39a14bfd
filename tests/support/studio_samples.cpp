// See studio_samples.h. Any thread.
#include "tests/support/studio_samples.h"

#include <cmath>
#include <functional>

#include "tests/studio/throwing.h"

namespace onggi::support {
namespace {

using clay::Firing;
using clay::StudioClay;
using clay::studio::Bench;

constexpr double kRateHz = 500.0;

StudioClay thrown(const std::vector<clay::studio::Stroke>& strokes, clay::ClayBody body) {
    Bench bench({.mass_g = 500.0, .body = body}, kRateHz);
    clay::studio::throw_pot(bench, strokes);
    return bench.clay;
}

StudioClay wall(double outer_mm, double wall_mm, double floor_mm, double height_mm, int rings) {
    StudioClay pot({.mass_g = 500.0});
    pot.set_wall(outer_mm, wall_mm, floor_mm, height_mm, rings);
    return pot;
}

// Radii as functions of u = i/count, on the rings of a straight wall of 100 mm.
StudioClay turned(int count, const std::function<double(double)>& outer_mm,
                  const std::function<double(double)>& inner_mm) {
    StudioClay pot = wall(40.0, 6.0, 10.0, 100.0, count);
    std::vector<double> outer;
    std::vector<double> inner;
    for (int i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / count;
        outer.push_back(outer_mm(u));
        inner.push_back(inner_mm(u));
    }
    pot.set_profile(outer, inner);
    return pot;
}

// Two fingers' dents in a standing wall, one from outside and one from inside.
StudioClay dented() {
    Bench bench({.mass_g = 500.0}, kRateHz);
    bench.wall(45.0, 6.0, 12.0, 110.0, 1000);
    bench.turn_at(0.0);
    bench.at(80.0, 70.0);
    bench.move({50.0, 70.0, 0.0}, 0.6);
    bench.hold(0.5);
    bench.move({80.0, 70.0, 0.0}, 0.3);
    bench.move({80.0, 200.0, 0.0}, 0.3);
    bench.move({0.0, 200.0, 0.0}, 0.3);
    bench.move({0.0, 50.0, 0.0}, 0.5);
    bench.move({0.0, 50.0, 33.0}, 0.6);
    bench.hold(0.5);
    return bench.clay;
}

// A lump that was opened and raised beside the axis without being centred.
StudioClay lopsided() {
    Bench bench({.mass_g = 500.0}, kRateHz);
    bench.clay.set_centre({6.0, 2.0});
    constexpr std::ptrdiff_t kCentring = 3;  // strokes
    std::vector<clay::studio::Stroke> strokes = clay::studio::cylinder();
    strokes.erase(strokes.begin(), strokes.begin() + kCentring);
    clay::studio::throw_pot(bench, strokes);
    return bench.clay;
}

// Wide, wet and fast.
StudioClay spun_apart() {
    Bench bench({.mass_g = 1000.0, .liquidity_index = 0.95}, kRateHz);
    bench.wall(95.0, 7.0, 12.0, 70.0, 700);
    bench.clay.set_liquidity(0.95);
    bench.turn_at(7.0 * std::numbers::pi);
    bench.lift();
    bench.hold(2.0);
    return bench.clay;
}

}  // namespace

std::vector<StudioSample> all_studio_samples() {
    std::vector<StudioSample> pots;
    pots.push_back({.name = "studio_lump", .clay = StudioClay({.mass_g = 1000.0}), .off_axis_mm = 2.1});
    const StudioClay cylinder = thrown(clay::studio::cylinder(), clay::ClayBody::kPorcelain);
    const double off_mm = 0.7;  // what a steady hand leaves
    pots.push_back({.name = "studio_cylinder", .clay = cylinder, .off_axis_mm = off_mm});
    pots.push_back(
        {.name = "studio_cylinder_glazed", .clay = cylinder, .stage = Firing::kGlaze, .off_axis_mm = off_mm});
    pots.push_back({.name = "studio_vase_bisque",
                    .clay = thrown(clay::studio::vase(), clay::ClayBody::kEarthenware),
                    .stage = Firing::kBisque,
                    .off_axis_mm = off_mm});
    pots.push_back({.name = "studio_dented", .clay = dented(), .off_axis_mm = 8.0, .calm = false});
    pots.push_back({.name = "studio_lopsided", .clay = lopsided(), .off_axis_mm = 8.0, .calm = false});
    pots.push_back({.name = "studio_spun_apart", .clay = spun_apart(), .off_axis_mm = 4.0, .calm = false});
    pots.push_back({.name = "studio_tube", .clay = wall(45.0, 5.0, 0.0, 80.0, 400), .euler = 0});
    pots.push_back({.name = "studio_upside_down",
                    .clay = turned(
                        500, [](double) { return 40.0; }, [](double u) { return u < 0.8 ? 34.0 : 0.0; })});
    pots.push_back({.name = "studio_closed_over",
                    .clay = turned(
                        500, [](double u) { return 40.0 - 10.0 * u; },
                        [](double u) { return u > 0.2 && u < 0.8 ? 20.0 : 0.0; }),
                    .euler = 4,
                    .parts = 2});
    pots.push_back({.name = "studio_thin",
                    .clay = turned(
                        1000, [](double u) { return 50.0 + 20.0 * u * u; },
                        [](double u) { return u < 0.1 ? 0.0 : 49.0 + 20.0 * u * u; })});
    pots.push_back({.name = "studio_low_ring", .clay = wall(60.0, 8.0, 0.0, 3.0, 40), .euler = 0});
    pots.push_back({.name = "studio_jagged",
                    .clay = turned(
                        2000, [](double u) { return 50.0 + 8.0 * std::sin(4000.0 * u); },
                        [](double u) { return u < 0.1 ? 0.0 : 30.0 + 8.0 * std::sin(5000.0 * u); }),
                    .calm = false});
    return pots;
}

}  // namespace onggi::support
