// Rings, ledger, split and join: the invariants of the stack of rings.

#include <algorithm>

#include "game/clay/exact_math.h"
#include "game/clay/studio/moves.h"
#include "game/clay/studio/rings.h"
#include "tests/studio/bench.h"

namespace onggi::clay::studio {
namespace {

TEST(ExactMath, LogarithmExponentialAndAngleAreWithinATrillionthOfTheLibrarys) {
    for (double x = 1e-6; x < 1e6; x *= 1.37)
        EXPECT_NEAR(natural_log(x), std::log(x), 1e-12) << x;
    for (double x = -30.0; x < 30.0; x += 0.173)
        EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 1e-12) << x;
    for (double a = 0.0; a < 6.283; a += 0.0037)
        EXPECT_NEAR(angle_of(3.0 * std::cos(a), 3.0 * std::sin(a)), a, 1e-12) << a;
    EXPECT_EQ(angle_of(0.0, 0.0), 0.0);
}

TEST(Lump, IsALowDomeOfTheMassAskedForALittleOffCentre) {
    const StudioClay clay({.mass_g = 500.0});
    EXPECT_EQ(clay.volume_mm3(), on_grid(500.0 / 1.9e-3));
    EXPECT_NEAR(clay.volume_mm3() * 1.9e-3, 500.0, 1e-6);
    EXPECT_NEAR(clay.outer_mm()[0], 49.1, 0.2);
    EXPECT_NEAR(clay.height_mm(), 39.3, 0.2);
    EXPECT_GT(clay.outer_mm()[0], clay.outer_mm().back());
    EXPECT_NEAR(clay.centre_mm(0).x, 2.0, 1e-6);
    expect_sound(clay);
}

TEST(Lump, RejectsAnInvalidLump) {
    EXPECT_FALSE(check(StudioLump{.mass_g = 0.0}));
    EXPECT_FALSE(check(StudioLump{.mass_g = 1e9}));
    EXPECT_FALSE(check(StudioLump{.liquidity_index = std::nan("")}));
    EXPECT_FALSE(check(StudioLump{.rings = 10}));
    EXPECT_FALSE(check(StudioLump{.sectors = 100}));
    EXPECT_TRUE(check(StudioLump{}));
    StudioParameters parameters;
    EXPECT_TRUE(check(parameters));
    parameters.rate_hz = 50.0;
    EXPECT_FALSE(check(parameters));
}

TEST(Rings, PlacesAreTheRunningSumOfHeights) {
    const StudioClay clay({.mass_g = 500.0});
    double sum = 0.0;
    for (int i = 0; i < clay.ring_count(); ++i) {
        const double height = clay.rings().height_mm[static_cast<std::size_t>(i)];
        EXPECT_NEAR(clay.centre_height_mm(i), sum + 0.5 * height, 1e-10);
        EXPECT_EQ(clay.rings().ring_at(sum + 0.5 * height), i);
        sum += height;
    }
    EXPECT_NEAR(clay.height_mm(), sum, 1e-10);
}

TEST(Rings, SplitAndJoinKeepEveryGrainAndTheHeight) {
    Bench bench;
    bench.wall(45.0, 6.5, 12.0, 100.0, 500);
    Rings rings = bench.clay.rings();
    const double before = rings.on_wheel_mm3();
    for (int i = 400; i >= 100; i -= 50)
        split_ring(rings, i);
    EXPECT_EQ(rings.count, 507);
    EXPECT_EQ(rings.on_wheel_mm3(), before);
    rings.place(0, rings.count);
    EXPECT_NEAR(rings.top_mm(), 100.0, 1e-6);
    for (int i = 300; i < 310; ++i)
        join_rings(rings, i);
    rings.place(0, rings.count);
    EXPECT_EQ(rings.count, 497);
    EXPECT_EQ(rings.on_wheel_mm3(), before);
    EXPECT_NEAR(rings.top_mm(), 100.0, 1e-6);
}

TEST(Rings, AreNeverJoinedAcrossTheFloor) {
    Bench bench;
    bench.wall(45.0, 6.5, 12.0, 100.0, 1000);
    Rings rings = bench.clay.rings();
    // Rings far below the usual height: each must be joined with a neighbour of the same kind.
    for (int i = 0; i < rings.count; ++i)
        tend_ring(rings, i, 0.5);
    rings.find_floor();
    rings.place(0, rings.count);
    EXPECT_NEAR(rings.floor_mm(), 12.0, 1e-6);
    EXPECT_LT(rings.count, 600);
    for (int i = rings.first_hollow; i < rings.count; ++i)
        EXPECT_NEAR(rings.wall_mm(i), 6.5, 1e-4);
}

TEST(Rings, RowsOfResidualsStayWithTheirRings) {
    Rings rings(16, 16);
    rings.reset(4);
    for (int i = 0; i < 4; ++i) {
        rings.volume_mm3[Rings::at(i)] = 100.0;
        rings.outer_mm[Rings::at(i)] = 20.0;
        rings.rough_mm[Rings::at(i)] = 1.0F;
        std::fill_n(rings.row_of(i), 16, static_cast<float>(i));
    }
    rings.settle(0, 4);
    split_ring(rings, 1);
    EXPECT_EQ(rings.row_of(2)[5], 1.0F);
    EXPECT_EQ(rings.row_of(3)[5], 2.0F);
    join_rings(rings, 3);
    EXPECT_NEAR(rings.row_of(3)[5], 2.5F, 1e-6F);
    EXPECT_EQ(rings.free_count, 12);
}

TEST(Wire, CutsTheRimLevelAndThePotOffWithoutLosingAGrain) {
    Bench bench;
    bench.wall(45.0, 6.5, 12.0, 100.0, 500);
    bench.input.wire = tool::Wire::kCutRim;
    bench.input.wire_height_mm = 90.0;
    bench.tick();
    EXPECT_NEAR(bench.clay.height_mm(), 90.0, 1e-5);
    EXPECT_NEAR(bench.clay.ledger().trimmings_mm3, std::numbers::pi * (45.0 * 45.0 - 38.5 * 38.5) * 10.0,
                1.0);
    EXPECT_EQ(bench.clay.ledger_error_mm3(), 0.0);
    bench.hold(0.01);
    EXPECT_NEAR(bench.clay.height_mm(), 90.0, 1e-5) << "one pull cuts once";

    bench.input.wire = tool::Wire::kNone;
    bench.tick();
    bench.input.wire = tool::Wire::kCutOff;
    bench.input.wire_height_mm = 2.0;
    bench.tick();
    EXPECT_TRUE(bench.clay.is_cut_off());
    EXPECT_NEAR(bench.clay.height_mm(), 88.0, 1e-5);
    EXPECT_EQ(bench.clay.ledger_error_mm3(), 0.0);
    expect_sound(bench.clay);
}

}  // namespace
}  // namespace onggi::clay::studio
