// Whole pots: the shape from 500 g, independence of the tick rate, and a potter's measures.
#include "game/clay/studio/pot.h"

#include <algorithm>

#include "tests/studio/throwing.h"

namespace onggi::clay::studio {
namespace {

// The wall of a cylinder of 500 g, 90 mm wide and 120 mm high on a floor of 12 mm, by volume: 6.6 mm.
double wall_by_volume(double outer, double height, double floor) {
    const double wall_mm3 = 500.0 / kDensityGPerMm3 - std::numbers::pi * outer * outer * floor;
    const double inner2 = outer * outer - wall_mm3 / (std::numbers::pi * (height - floor));
    return outer - std::sqrt(inner2);
}

TEST(Pot, FiveHundredGramsMakeACylinderOfNinetyByAHundredAndTwentyWithWallsOfSixAndAHalf) {
    EXPECT_NEAR(wall_by_volume(45.0, 120.0, 12.0), 6.6, 0.05);
    Bench bench;
    throw_pot(bench, cylinder());
    expect_sound(bench.clay);
    EXPECT_EQ(bench.clay.failure().cause, Cause::kNone) << sentence(bench.clay.failure());
    const PotMeasures pot = measure_pot(bench.clay.rings(), ClayBody::kStoneware);
    EXPECT_NEAR(pot.mass_g, 500.0, 1e-3);
    EXPECT_NEAR(pot.height_mm, 120.0, 4.0);
    EXPECT_NEAR(pot.widest_mm, 90.0, 3.0);
    // Opened to a floor of 12 mm; pressing the foot in raises it, and the assist does not lower it again.
    EXPECT_NEAR(pot.floor_mm, 14.4, 0.6);
    double mean = 0.0;
    int heights = 0;
    for (double y = 24.0; y < pot.height_mm - 8.0; y += 1.0, ++heights)
        mean += bench.wall_at(y);
    mean /= heights;
    EXPECT_NEAR(mean, 6.6, 0.66);
    std::printf("cylinder: %.1f x %.1f mm, wall %.2f mm, %.0f ml, %d rings\n", pot.widest_mm, pot.height_mm,
                mean, pot.capacity_ml, bench.clay.ring_count());
}

struct Profile {
    std::vector<double> outer;
    std::vector<double> inner;
    double height = 0.0;
};

Profile thrown_at(double rate_hz, const std::vector<Stroke>& strokes) {
    Bench bench({.mass_g = 500.0}, rate_hz);
    throw_pot(bench, strokes);
    expect_sound(bench.clay);
    Profile profile;
    profile.height = bench.clay.height_mm();
    // Between ring centres, so that ring boundaries do not matter; away from the step at the floor.
    const Rings& rings = bench.clay.rings();
    const auto between = [&](const std::vector<double>& column, double y) {
        int low = rings.ring_at(y);
        if (rings.centre_mm(low) > y) --low;
        low = std::clamp(low, 0, rings.count - 2);
        const double a = rings.centre_mm(low);
        const double part = (y - a) / (rings.centre_mm(low + 1) - a);
        return column[Rings::at(low)] + part * (column[Rings::at(low + 1)] - column[Rings::at(low)]);
    };
    for (double y = 14.0; y < profile.height - 2.0; y += 0.5) {
        profile.outer.push_back(between(rings.outer_mm, y));
        profile.inner.push_back(between(rings.inner_mm, y));
    }
    return profile;
}

double rms(const std::vector<double>& a, const std::vector<double>& b) {
    const std::size_t n = std::min(a.size(), b.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(n));
}

TEST(Rate, MakesNoDifferenceToAPot) {
    for (const auto& [name, strokes] : {std::pair{"cylinder", cylinder()}, std::pair{"vase", vase()}}) {
        const Profile fine = thrown_at(8000.0, strokes);
        double coarse = 0.0;
        for (const double rate : {500.0, 1000.0, 4000.0}) {
            const Profile other = thrown_at(rate, strokes);
            const double outer = rms(fine.outer, other.outer);
            const double inner = rms(fine.inner, other.inner);
            std::printf("%s at %.0f Hz against 8 kHz: outer %.4f inner %.4f height %.3f mm\n", name, rate,
                        outer, inner, other.height - fine.height);
            EXPECT_LT(outer, 0.1) << name << " at " << rate;
            EXPECT_LT(inner, 0.1) << name << " at " << rate;
            EXPECT_NEAR(other.height, fine.height, 0.4) << name << " at " << rate;
            if (rate == 500.0) coarse = outer;
            if (rate == 4000.0) {
                EXPECT_LT(outer, coarse) << "the error falls with the step";
            }
        }
    }
}

TEST(Rings, SettleOnAFinishedVaseAndDoNotSwing) {
    Bench bench;
    throw_pot(bench, vase());
    const auto changes = [&] { return bench.clay.splits() + bench.clay.joins(); };
    bench.at(120.0, 80.0);
    bench.move({bench.outer_at(80.0) + 7.0, 80.0, 0.0}, 1.0);
    bench.hold(5.0);
    const std::uint64_t after_push = changes();
    bench.hold(15.0);
    EXPECT_EQ(changes(), after_push);
}

TEST(Pot, ShrinksByItsBody) {
    EXPECT_DOUBLE_EQ(shrunk_scale(ClayBody::kStoneware, Firing::kGlaze), 0.88);
    EXPECT_DOUBLE_EQ(shrunk_scale(ClayBody::kPorcelain, Firing::kGlaze), 0.86);
    EXPECT_DOUBLE_EQ(shrunk_scale(ClayBody::kEarthenware, Firing::kGlaze), 0.92);
    EXPECT_DOUBLE_EQ(wet_scale_of_fired(ClayBody::kStoneware) * 0.88, 1.0);
    for (const ClayBody body : {ClayBody::kStoneware, ClayBody::kPorcelain, ClayBody::kEarthenware}) {
        EXPECT_GT(shrunk_scale(body, Firing::kWet), shrunk_scale(body, Firing::kDry));
        EXPECT_GT(shrunk_scale(body, Firing::kDry), shrunk_scale(body, Firing::kBisque));
        EXPECT_GT(shrunk_scale(body, Firing::kBisque), shrunk_scale(body, Firing::kGlaze));
    }
}

TEST(Pot, KnowsItsWeightItsCapacityAndItsWalls) {
    Bench bench;
    bench.wall(45.0, 6.5, 12.0, 112.0, 1000);
    const PotMeasures wet = measure_pot(bench.clay.rings(), ClayBody::kStoneware);
    // 38.5 mm of radius, 100 mm deep: 465.7 ml.
    EXPECT_NEAR(wet.capacity_ml, 465.66, 0.5);
    EXPECT_NEAR(wet.thinnest_wall_mm, 6.5, 1e-9);
    EXPECT_NEAR(wet.thickest_wall_mm, 6.5, 1e-9);
    EXPECT_NEAR(wet.mouth_mm, 90.0, 1e-9);
    EXPECT_NEAR(wet.foot_mm, 90.0, 1e-9);
    EXPECT_NEAR(wall_thickness_mm(bench.clay.rings(), 50.0), 6.5, 1e-9);
    EXPECT_NEAR(wall_thickness_mm(bench.clay.rings(), 5.0), 45.0, 1e-9);
    EXPECT_EQ(wall_thickness_mm(bench.clay.rings(), 200.0), 0.0);
    const PotMeasures fired = measure_pot(bench.clay.rings(), ClayBody::kStoneware, Firing::kGlaze);
    EXPECT_NEAR(fired.height_mm, 112.0 * 0.88, 1e-5);
    EXPECT_NEAR(fired.capacity_ml, wet.capacity_ml * 0.88 * 0.88 * 0.88, 1e-6);
    EXPECT_NEAR(fired.mass_g, wet.mass_g * 0.72, 1e-6);
}

}  // namespace
}  // namespace onggi::clay::studio
