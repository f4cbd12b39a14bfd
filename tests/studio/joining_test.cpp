// Joining two pots rim to rim: what stays, is turned over and is cut out; the joined pot can be thrown on.
#include "game/clay/studio/joining.h"

#include <algorithm>

#include "game/clay/studio/pot.h"
#include "game/clay/studio/strength.h"
#include "tests/studio/bench.h"

namespace onggi::clay::studio {
namespace {

constexpr double kFloorMm = 10.0;

StudioClay bowl(double outer_mm, double wall_mm, double height_mm, int rings = 400) {
    StudioClay pot({.mass_g = 500.0});
    pot.set_wall(outer_mm, wall_mm, kFloorMm, height_mm, rings);
    return pot;
}

// A wall that opens from `foot` to `rim`, both outer radii.
StudioClay flared(double foot_mm, double rim_mm, double wall_mm, double height_mm, int rings = 600) {
    StudioClay pot = bowl(foot_mm, wall_mm, height_mm, rings);
    std::vector<double> outer;
    std::vector<double> inner;
    for (int i = 0; i < rings; ++i) {
        const double u = (i + 0.5) / rings;
        outer.push_back(foot_mm + (rim_mm - foot_mm) * u);
        inner.push_back(u * height_mm < kFloorMm ? 0.0 : outer.back() - wall_mm);
    }
    pot.set_profile(outer, inner);
    return pot;
}

double floor_mm3(const StudioClay& pot) {
    double sum = 0.0;
    for (int i = 0; i < pot.rings().first_hollow; ++i)
        sum += pot.rings().volume_mm3[static_cast<std::size_t>(i)];
    return sum;
}

TEST(Joining, KeepsEveryGrainAndCutsTheUpperFloorOut) {
    const StudioClay lower = bowl(50.0, 6.0, 60.0);
    const StudioClay upper = bowl(50.0, 5.0, 80.0, 500);
    const auto pot = join_pots(lower, upper, {});
    ASSERT_TRUE(pot) << pot.error().message;
    expect_sound(*pot);
    EXPECT_EQ(pot->volume_mm3(), lower.volume_mm3() + upper.volume_mm3() - floor_mm3(upper));
    EXPECT_EQ(pot->ledger().trimmings_mm3, floor_mm3(upper));
    EXPECT_EQ(pot->ledger().lump_mm3, lower.volume_mm3() + upper.volume_mm3());
    EXPECT_EQ(pot->ledger_error_mm3(), 0.0);
    EXPECT_DOUBLE_EQ(pot->lump().mass_g, 1000.0);
    EXPECT_EQ(pot->ring_count(), 400 + 500 - upper.rings().first_hollow);
    // 60 + 70 mm, less what the ridge takes: 2.5 mm to either side hold (8/15) 2.5 of full ridge, whose 0.8
    // mm of wall in 6.3 sinks by an eighth: 2 x 1.33 x 0.8/6.3 = 0.34 mm. Easing one wall to the mean of 5.5
    // thickens one side as it thins the other: 15 (8/15) 0.5/5.25 of rise against as much of sinking.
    EXPECT_NEAR(pot->height_mm(), 130.0, 0.6);
    EXPECT_NEAR(pot->height_mm(), 130.0 - 0.34, 0.15);
}

TEST(Joining, TurnsTheUpperPotUpsideDown) {
    const StudioClay lower = flared(35.0, 60.0, 6.0, 70.0);
    const StudioClay upper = flared(30.0, 60.0, 6.0, 90.0);
    const auto pot = join_pots(lower, upper, {.ridge_mm = 0.0});
    ASSERT_TRUE(pot) << pot.error().message;
    const Rings& rings = pot->rings();
    const auto outer_at = [&](double y) { return rings.outer_mm[Rings::at(rings.ring_at(y))]; };
    // The wall of both at once: 35 to 60 over 70 mm, and back to the floor's radius 30 + 30/9 over 80.
    for (double y = 1.0; y < 69.0; y += 4.0)
        EXPECT_NEAR(outer_at(y), 35.0 + 25.0 * y / 70.0, 0.2) << y;
    for (double y = 71.0; y < 149.0; y += 4.0)
        EXPECT_NEAR(outer_at(y), 30.0 + 30.0 * (160.0 - y) / 90.0, 0.2) << y;
    EXPECT_NEAR(2.0 * rings.outer_mm[Rings::at(rings.count - 1)], 2.0 * (30.0 + 30.0 / 9.0), 0.2);
    EXPECT_NEAR(rings.floor_mm(), kFloorMm, 0.2);
}

TEST(Joining, MirrorsDentsAndCentresAsTurningOverDoes) {
    Bench bench;
    bench.clay = bowl(50.0, 6.0, 60.0);
    bench.turn_at(0.0);
    // A dent at an eighth of a turn from direction 0: +X towards -Z.
    const double c = std::sqrt(0.5);
    bench.at(90.0 * c, 40.0, -90.0 * c);
    bench.move({55.0 * c, 40.0, -55.0 * c}, 0.5);
    bench.hold(0.5);
    StudioClay upper = bench.clay;
    upper.set_centre({0.5, 1.5});
    const auto deepest = [](const StudioClay& pot, double y) {
        const auto row = pot.residuals_mm(pot.rings().ring_at(y));
        return row.empty() ? -1 : static_cast<int>(std::min_element(row.begin(), row.end()) - row.begin());
    };
    const int sectors = upper.sector_count();
    EXPECT_NEAR(deepest(upper, 40.0), sectors / 8, 2);
    const auto pot = join_pots(bowl(50.0, 6.0, 60.0), upper, {});
    ASSERT_TRUE(pot) << pot.error().message;
    // 40 mm above the upper foot is 20 mm above the seam.
    EXPECT_NEAR(deepest(*pot, 80.0), sectors - 1 - deepest(upper, 40.0), 1);
    EXPECT_EQ(deepest(*pot, 20.0), -1) << "the lower pot stays round";
    const int top = pot->ring_count() - 1;
    EXPECT_FLOAT_EQ(static_cast<float>(pot->centre_mm(top).x), 0.5F);
    EXPECT_FLOAT_EQ(static_cast<float>(pot->centre_mm(top).y), -1.5F);
    EXPECT_EQ(pot->centre_mm(0).x, 0.0);
    // Turned over twice it is unchanged.
    const auto again = join_pots(bowl(50.0, 6.0, 60.0), *pot, {});
    ASSERT_TRUE(again) << again.error().message;
    const double y = again->height_mm() - (80.0 - kFloorMm);
    EXPECT_NEAR(deepest(*again, y), deepest(upper, 40.0), 1);
}

TEST(Joining, CarriesWaterStrengthAndLoad) {
    StudioClay lower = bowl(50.0, 6.0, 60.0);
    StudioClay upper = bowl(50.0, 6.0, 60.0);
    lower.set_liquidity(0.9);
    upper.set_liquidity(0.4);
    const auto pot = join_pots(lower, upper, {});
    ASSERT_TRUE(pot) << pot.error().message;
    const Rings& rings = pot->rings();
    for (int i = 0; i < rings.count; ++i) {
        const StudioClay& from = i < lower.ring_count() ? lower : upper;
        EXPECT_EQ(rings.liquidity[Rings::at(i)], from.rings().liquidity[0]);
        EXPECT_EQ(rings.strength_kpa[Rings::at(i)], from.rings().strength_kpa[0]);
    }
    // Standing, the wall just above the lower floor carries 100 mm of wall: rho g h = 1.9e-6 kg/mm^3 x 9.81
    // m/s^2 x 100 mm = 1.86e-3 N/mm^2 = 1.86 kPa. The index is that over 2 su of the lower clay.
    Bench bench;
    bench.clay = *pot;
    bench.turn_at(0.0);
    bench.lift();
    bench.hold(0.2);
    const double su = strength_kpa(0.9);
    EXPECT_NEAR(bench.clay.load_index(), 1.9e-6 * 9.81 * 100.0 * 1000.0 / (2.0 * su), 0.05);
    EXPECT_EQ(bench.clay.load_cause(), Cause::kWeight);
}

TEST(Joining, LeavesTheSeamALittleVisible) {
    const auto pot = join_pots(bowl(50.0, 6.0, 60.0), bowl(50.0, 6.0, 60.0), {});
    ASSERT_TRUE(pot);
    const Rings& rings = pot->rings();
    double widest = 0.0;
    double where = 0.0;
    for (int i = 0; i < rings.count; ++i) {
        if (rings.outer_mm[Rings::at(i)] > widest) {
            widest = rings.outer_mm[Rings::at(i)];
            where = rings.centre_mm(i);
        }
    }
    EXPECT_NEAR(widest, 50.4, 0.01);
    EXPECT_NEAR(where, 60.0, 0.5);
    EXPECT_NEAR(rings.outer_mm[Rings::at(rings.ring_at(55.0))], 50.0, 1e-9);
    EXPECT_NEAR(rings.wall_mm(rings.ring_at(where)), 6.8, 0.02);
}

TEST(Joining, BlendsDifferentRimsOnlyNearTheSeam) {
    const StudioClay lower = bowl(52.0, 6.0, 60.0);
    const StudioClay upper = bowl(48.0, 5.0, 60.0);
    const auto pot = join_pots(lower, upper, {.ridge_mm = 0.0});
    ASSERT_TRUE(pot) << pot.error().message;
    expect_sound(*pot);
    const Rings& rings = pot->rings();
    const int rim = lower.ring_count() - 1;
    // Mean radii 49 and 45.5, walls 6 and 5: they meet at 47.25 and 5.5.
    for (const int i : {rim, rim + 1}) {
        EXPECT_NEAR(rings.outer_mm[Rings::at(i)], 47.25 + 2.75, 0.02);
        EXPECT_NEAR(rings.inner_mm[Rings::at(i)], 47.25 - 2.75, 0.02);
    }
    EXPECT_EQ(rings.outer_mm[Rings::at(rings.ring_at(44.0))], 52.0);
    EXPECT_EQ(rings.outer_mm[Rings::at(rings.ring_at(77.0))], 48.0);
}

TEST(Joining, OpensTheMouthAsWideAsAsked) {
    const StudioClay upper = flared(30.0, 60.0, 6.0, 90.0);
    const auto pot = join_pots(flared(35.0, 60.0, 6.0, 70.0), upper, {.bore_mm = 80.0});
    ASSERT_TRUE(pot) << pot.error().message;
    EXPECT_NEAR(2.0 * pot->inner_mm().back(), 80.0, 0.3);
    EXPECT_GE(2.0 * pot->inner_mm().back(), 80.0);
    EXPECT_GT(pot->ledger().trimmings_mm3, floor_mm3(upper));
    EXPECT_EQ(pot->ledger_error_mm3(), 0.0);
}

TEST(Joining, MakesAStateThatIsReadBackAndTickedToTheSameBits) {
    const auto joined = join_pots(flared(35.0, 60.0, 6.0, 70.0), flared(30.0, 58.0, 6.0, 90.0), {});
    ASSERT_TRUE(joined);
    Bench a;
    a.clay = *joined;
    auto read = StudioClay::from_start_state(joined->start_state());
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->state_hash(), joined->state_hash());
    Bench b;
    b.clay = std::move(read).value();
    // A collar for the mouth, on the joined pot.
    for (Bench* bench : {&a, &b}) {
        bench->turn_at(kThrowingSpeed);
        bench->at(80.0, 145.0);
        bench->move({41.0, 145.0, 0.0}, 1.0);
        bench->move({40.0, 145.0, 0.0}, 1.0);
        bench->move({80.0, 145.0, 0.0}, 0.5);
    }
    EXPECT_EQ(a.clay.state_hash(), b.clay.state_hash());
    EXPECT_NE(a.clay.state_hash(), joined->state_hash());
    expect_sound(a.clay);
    EXPECT_LT(a.outer_at(a.clay.height_mm() - 3.0), joined->outer_mm().back() + 1.0);
    EXPECT_EQ(a.clay.failure().cause, Cause::kNone) << sentence(a.clay.failure());
}

TEST(Joining, SetsTheUpperPotAsideAndEasesHalfOfThatOnEitherSide) {
    const StudioClay straight = bowl(50.0, 6.0, 60.0);
    constexpr double kRightMm = 4.0;
    const auto pot = join_pots(straight, straight, {.shift_mm = {kRightMm, 0.0}});
    ASSERT_TRUE(pot) << pot.error().message;
    expect_sound(*pot);
    EXPECT_EQ(pot->ledger_error_mm3(), 0.0);
    const double foot_mm = pot->centre_mm(0).x;
    EXPECT_NEAR(pot->centre_mm(pot->ring_count() - 1).x - foot_mm, kRightMm, 1e-5);
    double last_mm = foot_mm;
    for (int ring = 1; ring < pot->ring_count(); ++ring) {
        const double x_mm = pot->centre_mm(ring).x;
        EXPECT_GE(x_mm, last_mm - 1e-5) << "never back";
        EXPECT_LT(x_mm - last_mm, 0.1) << "and without a step, at ring " << ring;
        last_mm = x_mm;
    }
    const int at_seam = pot->rings().ring_at(60.0);
    EXPECT_NEAR(pot->centre_mm(at_seam).x - foot_mm, 0.5 * kRightMm, 0.05);
}

TEST(Joining, FindsTheBoreOfAMouthByItsOuterWidth) {
    const StudioClay pot = flared(30.0, 60.0, 6.0, 70.0);
    EXPECT_NEAR(bore_at_width_mm(pot, 90.0), 90.0 - 12.0, 0.2);
    EXPECT_EQ(bore_at_width_mm(pot, 40.0), 0.0) << "its foot is wider, and solid";
    EXPECT_EQ(bore_at_width_mm(pot, 200.0), 0.0) << "it is nowhere so wide";
    EXPECT_NEAR(rim_step_mm(bowl(50.0, 6.0, 60.0), bowl(47.0, 4.0, 60.0)), 2.0, 1e-9);
}

std::string refusal(const StudioClay& lower, const StudioClay& upper, const Joining& joining = {}) {
    const auto pot = join_pots(lower, upper, joining);
    EXPECT_FALSE(pot);
    if (pot) return {};
    EXPECT_EQ(pot.error().kind, ErrorKind::kBadInput);
    return pot.error().message;
}

TEST(Joining, RefusesRimsThatDoNotMeet) {
    const StudioClay good = bowl(50.0, 6.0, 60.0);
    EXPECT_NE(refusal(StudioClay({.mass_g = 500.0}), good).find("the lower pot: expected an open rim"),
              std::string::npos);
    EXPECT_NE(refusal(good, StudioClay({.mass_g = 500.0})).find("the upper pot: expected an open rim"),
              std::string::npos);
    EXPECT_NE(refusal(good, bowl(30.0, 6.0, 60.0)).find("expected rims that meet, found 94.0 mm"),
              std::string::npos);
    EXPECT_NE(refusal(good, good, {.bore_mm = 200.0}).find("expected a mouth narrower"), std::string::npos);
    StudioClay heavy({.mass_g = 4800.0});
    heavy.set_wall(50.0, 6.0, kFloorMm, 60.0, 400);
    EXPECT_NE(refusal(good, heavy).find("both pots together"), std::string::npos);
    EXPECT_NE(refusal(bowl(50.0, 6.0, 190.0), bowl(50.0, 6.0, 190.0)).find("expected both pots within 350"),
              std::string::npos);
    StudioClay fewer({.mass_g = 500.0, .sectors = 64});
    fewer.set_wall(50.0, 6.0, kFloorMm, 60.0, 400);
    EXPECT_NE(refusal(good, fewer).find("as many sectors"), std::string::npos);
    StudioClay white({.mass_g = 500.0, .body = ClayBody::kPorcelain});
    white.set_wall(50.0, 6.0, kFloorMm, 60.0, 400);
    EXPECT_NE(refusal(good, white).find("one clay body"), std::string::npos);
}

}  // namespace
}  // namespace onggi::clay::studio
