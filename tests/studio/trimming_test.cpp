// Trimming a foot with a guided trimmer: what it removes, and what it never removes.
#include "game/clay/studio/studio_clay.h"

#include "tests/studio/bench.h"

namespace onggi::clay::studio {
namespace {

constexpr double kFloorMm = 12.0;

// A thick-footed pot on a wheel that turns, and a finger beside it.
Bench thick_pot(bool forgiving = true) {
    Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0}, {50.0, 14.0, kFloorMm, 90.0, 900});
    bench.input.guided = true;
    bench.input.pressing = false;
    bench.input.tool = tool::Tool::kTrimmer;
    bench.input.radius_mm = 7.0;
    bench.parameters.forgiving = forgiving;
    bench.at(60.0, 20.0);
    bench.hold(1.0);
    return bench;
}

void shave(Bench& bench, double y_mm, double to_mm, double seconds = 3.0) {
    bench.input.pressing = true;
    bench.at(bench.outer_at(y_mm), y_mm);
    bench.move({to_mm, y_mm, 0.0}, seconds);
    bench.hold(1.0);
    bench.input.pressing = false;
}

TEST(Trimming, ShavesDownToTheFingerAndKeepsTheLedger) {
    Bench bench = thick_pot();
    const double before = bench.clay.volume_mm3();
    shave(bench, 30.0, 45.0);
    EXPECT_NEAR(bench.outer_at(30.0), 45.0, 0.15);
    EXPECT_NEAR(bench.inner_at(30.0), 36.0, 1e-9) << "the inside is as it was";
    EXPECT_NEAR(bench.clay.height_mm(), 90.0, 1e-3);
    EXPECT_EQ(bench.clay.ledger().trimmings_mm3, before - bench.clay.volume_mm3());
    EXPECT_GT(bench.clay.ledger().trimmings_mm3, 5000.0);
    EXPECT_EQ(bench.clay.ledger_error_mm3(), 0.0);
    EXPECT_NEAR(bench.outer_at(60.0), 50.0, 1e-9) << "and nothing far away";
    expect_sound(bench.clay);
}

TEST(Trimming, NeverLeavesAWallUnderThreeMillimetres) {
    Bench bench = thick_pot();
    for (const double y_mm : {70.0, 45.0, 25.0, 14.0, 11.0, 8.0, 3.0})
        shave(bench, y_mm, 8.0, 2.0);
    const Rings& rings = bench.clay.rings();
    for (int i = 0; i < rings.count; ++i) {
        if (rings.is_hollow(i)) {
            EXPECT_GE(rings.wall_mm(i), kTrimmedWallMm - 1e-6) << "at " << rings.centre_mm(i);
        } else {
            EXPECT_GE(rings.outer_mm[Rings::at(i)], kTrimmedFootMm - 1e-6) << "at " << rings.centre_mm(i);
        }
    }
    // Round the corner of the floor there are three millimetres too.
    const int below = rings.ring_at(kFloorMm - 1.0);
    EXPECT_GE(rings.outer_mm[Rings::at(below)], 36.0 + kTrimmedWallMm - 1e-6);
    EXPECT_EQ(bench.clay.failure().cause, Cause::kNone) << "leather-hard clay stands on the rest";
    EXPECT_NEAR(bench.clay.height_mm(), 90.0, 1e-3);
    expect_sound(bench.clay);
}

TEST(Trimming, GoesFurtherOnAnUnforgivingWheel) {
    Bench bench = thick_pot(false);
    shave(bench, 45.0, 30.0);
    EXPECT_LT(bench.wall_at(45.0), kTrimmedWallMm);
    EXPECT_GE(bench.wall_at(45.0), kThinnestWallMm - 1e-6);
}

TEST(Trimming, DriesThePotAtItsFirstTouchAndNotBefore) {
    Bench bench = thick_pot();
    EXPECT_FALSE(bench.clay.is_leather_hard());
    shave(bench, 30.0, 48.0);
    EXPECT_TRUE(bench.clay.is_leather_hard());
    EXPECT_EQ(bench.clay.film(), 0.0);
    EXPECT_LT(bench.clay.load_index(), 0.1);
}

TEST(Trimming, LeavesNoPrintOnAWheelThatStands) {
    Bench bench = thick_pot();
    shave(bench, 30.0, 48.0);
    bench.turn_at(0.0);
    const double outer = bench.outer_at(30.0);
    bench.input.pressing = true;
    bench.at(40.0, 30.0);
    bench.hold(1.0);
    EXPECT_EQ(bench.outer_at(30.0), outer);
    EXPECT_TRUE(bench.clay.residuals_mm(bench.clay.rings().ring_at(30.0)).empty());
}

TEST(Trimming, IsOfferedByTheWallAboveTheFloor) {
    EXPECT_NEAR(foot_wall_mm(thick_pot().clay.rings()), 14.0, 0.1);
    EXPECT_EQ(foot_wall_mm(StudioClay({.mass_g = 500.0}).rings()), 0.0) << "of a lump";
}

}  // namespace
}  // namespace onggi::clay::studio
