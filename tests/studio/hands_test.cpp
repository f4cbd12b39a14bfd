// Which side a hand is on, and what each move does to the clay: the known answers.
#include "tests/studio/bench.h"

namespace onggi::clay::studio {
namespace {

TEST(Flow, AHeldDepthDecaysIndependentlyOfTheRate) {
    for (const double rate : {500.0, 1000.0, 8000.0}) {
        Bench bench({.mass_g = 2000.0, .off_centre_mm = 0.0}, {60.0, 60.0, 100.0, 100.0, 1000}, rate);
        // One tau at the strength of 13 kPa is 0.1 s: set the strength to what the body has.
        bench.parameters.flow_time_s = 0.1 / std::sqrt(bench.clay.rings().strength_kpa[0] / 13.0);
        bench.parameters.yield_depth_mm = 0.0;
        bench.at(69.0, 50.05);
        bench.hold(0.1 - 1.0 / rate);
        const double left = bench.outer_at(50.05) - 59.0;
        EXPECT_NEAR(left, std::exp(-1.0), 0.001) << rate;
    }
}

TEST(Flow, AStillHandStopsAtTheYieldDepth) {
    Bench bench({.mass_g = 2000.0, .off_centre_mm = 0.0}, {60.0, 60.0, 100.0, 100.0, 1000});
    bench.at(69.0, 50.05);
    bench.hold(3.0);
    EXPECT_NEAR(bench.outer_at(50.05) - 59.0, 0.25, 0.001);
}

TEST(Side, IsAMatterOfHistory) {
    Bench bench({.mass_g = 500.0, .off_centre_mm = 0.0});
    bench.turn_at(0.0);  // the clay keeps still
    bench.wall(45.0, 6.5, 12.0, 100.0, 1000);
    const auto go = [&](double x, double y) {
        bench.move({x, y, 0.0}, 0.2);
        return bench.tick().side;
    };
    EXPECT_EQ(go(0.0, 130.0), Side::kFree);
    EXPECT_EQ(go(0.0, 50.0), Side::kIn);
    EXPECT_EQ(go(28.0, 50.0), Side::kIn);
    EXPECT_EQ(go(28.0, 130.0), Side::kFree);
    EXPECT_EQ(go(70.0, 130.0), Side::kFree);
    EXPECT_EQ(go(70.0, 60.0), Side::kOut);
    EXPECT_EQ(go(60.0, 112.0), Side::kFree);
    EXPECT_EQ(go(41.0, 105.0), Side::kTop);
}

TEST(Side, AFastHandDoesNotTunnelThroughAWall) {
    for (const double wall : {2.0, 3.0, 6.0}) {
        double height = 0.0;
        for (const double rate : {500.0, 1000.0, 4000.0}) {
            Bench bench({.mass_g = 500.0, .off_centre_mm = 0.0}, rate);
            bench.parameters.slumps = false;  // a neck that thin would not stand; see load_test
            bench.wall(40.0, wall, 12.0, 80.0, 800);
            bench.at(60.0, 50.05);
            const int ticks = static_cast<int>(0.09 * rate);
            double fastest = 0.0;
            double hardest = 0.0;
            // Over a millisecond: at a fast rate walls move in every other tick.
            const int apart = std::max(static_cast<int>(rate / 1000.0), 1);
            double before = bench.outer_at(50.05);
            for (int k = 1; k <= ticks; ++k) {  // 1 m/s radially inward, across the axis
                const StudioForces forces = bench.at(60.0 - 1000.0 * k / rate, 50.05);
                ASSERT_EQ(forces.side, Side::kOut);
                if (k % apart == 0) {
                    const double now = bench.outer_at(50.05);
                    fastest = std::max(fastest, (before - now) * rate / apart);
                    before = now;
                }
                hardest =
                    std::max(hardest, std::sqrt(glm::dot(forces.hand.stiffness_n, forces.hand.stiffness_n)));
                ASSERT_GE(forces.hand.stiffness_n.x, 0.0) << "it pushes back the way it came";
            }
            EXPECT_LE(fastest, 98.5) << wall << " mm at " << rate << " Hz";
            // A thin wall resists with its hinge only, 2 pi su t^2.
            const double hinge = 2.0 * std::numbers::pi * 0.013161 * wall * wall;
            EXPECT_LT(hardest, hinge * 1.35) << wall;
            EXPECT_GT(hardest, hinge * 0.6) << wall;
            bench.hold(2.0);
            EXPECT_NEAR(bench.outer_at(50.05), kNarrowestMm, 0.25) << wall << " mm at " << rate << " Hz";
            expect_sound(bench.clay);
            if (height == 0.0) height = bench.clay.height_mm();
            EXPECT_NEAR(bench.clay.height_mm(), height, 0.02 * height) << wall << " mm at " << rate << " Hz";
        }
    }
}

TEST(Move, SqueezingAWallRaisesItAndLeavesTheRestUntouchedToTheBit) {
    Bench bench({.mass_g = 2500.0, .off_centre_mm = 0.0}, {45.0, 6.5, 12.0, 160.0, 1600});
    const StudioClay before = bench.clay;
    bench.at(55.0, 128.05);
    bench.move({52.0, 128.05, 0.0}, 0.5);
    bench.hold(0.5);
    EXPECT_GT(bench.clay.height_mm(), 160.2);
    // The field reaches beta sqrt(R t) = 41.2 mm down from the push.
    int lowest = 0;
    while (bench.clay.outer_mm()[static_cast<std::size_t>(lowest)] ==
           before.outer_mm()[static_cast<std::size_t>(lowest)])
        ++lowest;
    EXPECT_NEAR(bench.clay.centre_height_mm(lowest), 128.0 - 2.5 * std::sqrt(41.75 * 6.5), 1.5);
    EXPECT_EQ(bench.clay.outer_mm()[200], before.outer_mm()[200]);
    EXPECT_EQ(bench.clay.inner_mm()[200], before.inner_mm()[200]);
    expect_sound(bench.clay);
}

TEST(Move, PressingTheRimLowersAndThickensIt) {
    Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0}, {45.0, 6.5, 12.0, 100.0, 1000});
    bench.at(41.75, 115.0);
    bench.move({41.75, 110.0, 0.0}, 0.1);
    bench.move({41.75, 107.0, 0.0}, 1.0);
    const StudioForces forces = bench.hold(3.0);
    EXPECT_EQ(forces.side, Side::kTop);
    EXPECT_GT(forces.hand.stiffness_n.y, 0.5);
    EXPECT_NEAR(bench.clay.height_mm(), 97.25, 0.1);  // 3 mm less the yield depth
    // The zone of four walls, 26 mm, carries 8/15 of itself: 2.75 mm out of 13.9 thicken the rim by exp(0.2).
    // Over two walls with (1 - s)^2 it was 10.65, a flange.
    EXPECT_NEAR(bench.wall_at(bench.clay.height_mm()), 7.9, 0.4);
    EXPECT_EQ(bench.outer_at(60.0), 45.0);
    expect_sound(bench.clay);
}

TEST(Move, ARimPressedAllTheWayStaysAWallAndBecomesNoFlange) {
    for (const double wall : {4.0, 6.5, 15.0}) {
        Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0}, {45.0, wall, 12.0, 70.0, 700});
        bench.at(45.0 - 0.5 * wall, 85.0);
        bench.move({45.0 - 0.5 * wall, 5.0, 0.0}, 8.0);
        const double height = bench.clay.height_mm();
        EXPECT_LT(height, 60.0) << wall << " mm";
        EXPECT_NEAR(bench.clay.floor_mm(), 12.0, 0.2) << wall << " mm";
        // On average no thicker than 1.8 times the rest of the wall; slightly more at the rim.
        EXPECT_GT(height - 12.0, bench.wall_at(height) / 2.0) << wall << " mm";
        EXPECT_GT(height - 12.0, 8.0) << wall << " mm";
        // Half way up the wall is almost as wide as at the rim.
        EXPECT_LT(bench.outer_at(height) - bench.outer_at(0.5 * (12.0 + height)), 4.0) << wall << " mm";
        bench.hold(3.0);
        EXPECT_NEAR(bench.clay.height_mm(), height, 0.1) << wall << " mm";
        expect_sound(bench.clay);
    }
}

TEST(Move, ALumpPressedOnTopSpreadsAsAWholeAndStaysALump) {
    for (const bool forgiving : {false, true}) {
        Bench bench({.mass_g = 1000.0});
        bench.parameters.forgiving = forgiving;
        bench.input.water = 1.0;
        bench.at(25.0, 64.0);
        EXPECT_EQ(bench.move({25.0, 58.0, 0.0}, 0.2).side, Side::kTop);
        bench.move({25.0, 20.0, 0.0}, 1.0);
        bench.hold(2.0);
        const double height = bench.clay.height_mm();
        EXPECT_LT(height, 36.0) << "it gives way";
        EXPECT_GT(height, 30.0);
        // Still a dome: no ring overhangs the one below it.
        const auto outer = bench.clay.outer_mm();
        for (std::size_t i = 1; i < outer.size(); ++i)
            ASSERT_LT(outer[i], outer[i - 1] + 0.05) << "ring " << i;
        EXPECT_LT(outer[0], 80.0);
        bench.hold(20.0);
        EXPECT_GT(bench.clay.height_mm(), 30.0) << "resistance grows without end";
        expect_sound(bench.clay);
    }
}

TEST(Move, AColumnPressedOnTopKeepsItsSidesUpright) {
    Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0}, {30.0, 30.0, 120.0, 120.0, 1200});
    bench.input.side = tool::Side::kTop;
    bench.at(10.0, 135.0);
    bench.move({10.0, 90.0, 0.0}, 3.0);
    EXPECT_NEAR(bench.clay.height_mm(), 80.0, 3.0);
    EXPECT_NEAR(bench.outer_at(75.0), bench.outer_at(5.0), 0.5);
    // By volume: 30 sqrt(120/h).
    EXPECT_NEAR(bench.outer_at(40.0), 30.0 * std::sqrt(120.0 / bench.clay.height_mm()), 0.3);
    expect_sound(bench.clay);
}

TEST(Move, ACollarNarrowsThickensAndRaisesAFreeWall) {
    const auto collar = [](double chi) {
        Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0}, {45.0, 4.0, 12.0, 100.0, 1000});
        bench.parameters.hoop_fraction_chi = chi;
        bench.at(60.0, 70.05);
        for (double x = 55.0; x > 45.25; x -= 0.001)
            bench.at(x, 70.05);
        bench.hold(1.0);
        return std::pair{bench.clay.height_mm(), bench.wall_at(70.05)};
    };
    const auto [tall, thin] = collar(0.0);
    const auto [middle_height, middle_wall] = collar(0.5);
    const auto [low, thick] = collar(1.0);
    EXPECT_GT(tall, middle_height);
    EXPECT_GT(middle_height, low);
    EXPECT_LT(thin, middle_wall);
    EXPECT_LT(middle_wall, thick);
    // ln t = chi |ln R'/R| for the wall part alone; a tenth of the push is local and thins it.
    EXPECT_NEAR(middle_wall, 4.05, 0.25);
    EXPECT_NEAR(thin, 3.64, 0.25);
    EXPECT_NEAR(thick, 4.50, 0.3);
}

TEST(Move, PushingTheInsideMakesABelly) {
    Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0}, {45.0, 5.0, 12.0, 100.0, 1000});
    bench.at(0.0, 130.0);
    bench.move({0.0, 60.0, 0.0}, 0.2);
    bench.move({38.0, 60.0, 0.0}, 2.0);
    const StudioForces forces = bench.hold(0.5);
    EXPECT_EQ(forces.side, Side::kIn);
    EXPECT_LT(forces.hand.stiffness_n.x, 0.0);
    EXPECT_GT(bench.outer_at(60.0), 50.5);
    EXPECT_EQ(bench.outer_at(5.0), 45.0);
    EXPECT_LT(bench.clay.height_mm(), 100.5);
    expect_sound(bench.clay);
}

TEST(Move, PressingDownAtTheAxisOpensTheLumpAndKeepsTheFloor) {
    Bench bench({.mass_g = 500.0, .off_centre_mm = 0.0});
    bench.at(0.0, 70.0);
    EXPECT_EQ(bench.move({0.0, 40.0, 0.0}, 2.0).side, Side::kIn);
    const StudioForces down = bench.move({0.0, 8.0, 0.0}, 4.0);
    EXPECT_GT(down.hand.stiffness_n.y, 3.0) << "the floor holds";
    bench.hold(1.0);
    EXPECT_NEAR(bench.clay.floor_mm(), 12.0, 0.5);
    EXPECT_NEAR(bench.inner_at(22.0), 9.75, 0.3);
    EXPECT_GT(bench.clay.height_mm(), StudioClay({.mass_g = 500.0}).height_mm() + 0.8)
        << "displaced clay rises";
    expect_sound(bench.clay);
}

TEST(Move, ComingStraightDownNearTheAxisOpensTheLumpToTheFloor) {
    for (const double mass : {500.0, 1000.0, 2500.0}) {
        for (const double x : {0.0, 0.3, 2.0, 5.0, 8.0, 9.0}) {
            Bench bench({.mass_g = mass});  // off centre, as a lump is
            const double before = bench.clay.height_mm();
            bench.input.water = 1.0;
            bench.at(x, before + 30.0);
            EXPECT_EQ(bench.move({x, 10.0, 0.0}, 5.0).side, Side::kIn) << mass << " g at " << x;
            bench.hold(1.0);
            EXPECT_NEAR(bench.clay.floor_mm(), 12.0, 0.5) << mass << " g at " << x;
            EXPECT_NEAR(bench.inner_at(25.0), 9.75 + x, 0.5) << mass << " g at " << x;
            EXPECT_GT(bench.clay.height_mm(), before) << mass << " g at " << x;
            expect_sound(bench.clay);
        }
    }
}

TEST(Side, NearTheAxisIsInsideAndOverTheRimIsOnTop) {
    Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0});
    const Rings& lump = bench.clay.rings();
    const double top = lump.top_mm();
    const double outer = lump.outer_mm[Rings::at(lump.count - 1)];
    EXPECT_NEAR(opening_radius_mm(lump, 10.0), outer / 3.0, 1e-9);
    EXPECT_NEAR(opening_radius_mm(lump, 24.0), 18.0, 1e-9);
    EXPECT_NEAR(opening_radius_mm(lump, 40.0), 0.5 * outer, 1e-9);
    EXPECT_EQ(next_side(Side::kFree, lump, top + 8.0, 13.0, 10.0), Side::kIn);
    EXPECT_EQ(next_side(Side::kFree, lump, top + 8.0, 14.0, 10.0), Side::kTop);
    // A hand inside stays inside even above a bore that is too small to see.
    EXPECT_EQ(next_side(Side::kIn, lump, top + 8.0, 13.0, 10.0), Side::kIn);
    EXPECT_EQ(next_side(Side::kIn, lump, top + 8.0, 14.0, 10.0), Side::kTop);

    bench.wall(45.0, 6.5, 12.0, 100.0, 1000);
    EXPECT_NEAR(opening_radius_mm(bench.clay.rings(), 10.0), 38.5, 1e-9) << "a mouth is what it is";
    bench.wall(12.0, 8.0, 12.0, 100.0, 1000);
    EXPECT_NEAR(opening_radius_mm(bench.clay.rings(), 20.0), 8.0, 1e-9) << "a neck keeps its rim";
}

TEST(Move, AnAssistedPinchThinsTheWallToItsGapAndRaisesIt) {
    Bench bench({.mass_g = 1500.0, .off_centre_mm = 0.0}, {45.0, 9.0, 12.0, 80.0, 800});
    bench.input.assist_gap_mm = 6.0;
    bench.at(60.0, 16.0);
    bench.move({54.0, 16.0, 0.0}, 0.5);
    // Surfaces 6 mm apart about the wall's middle; 20 mm/s up.
    bench.move({53.5, 16.0, 0.0}, 0.2);
    const StudioForces forces = bench.move({53.5, 90.0, 0.0}, 3.7);
    EXPECT_EQ(forces.second_side, Side::kIn);
    EXPECT_GT(bench.clay.height_mm(), 95.0);
    EXPECT_LT(bench.wall_at(50.0), 7.6);
    EXPECT_GT(bench.wall_at(50.0), 6.0);
    expect_sound(bench.clay);
}

TEST(Move, ASpongeFairsAWaveAndKeepsTheVolume) {
    for (const tool::Tool tool : {tool::Tool::kSponge, tool::Tool::kRib}) {
        Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0}, {45.0, 8.0, 12.0, 100.0, 1000});
        // A groove by a small hand.
        bench.input.radius_mm = 2.0;
        bench.at(46.9, 60.0);
        bench.move({45.5, 60.0, 0.0}, 0.5);
        bench.lift();
        const double volume = bench.clay.volume_mm3();
        const double groove = bench.outer_at(66.0) - bench.outer_at(60.0);
        ASSERT_GT(groove, 0.5);
        bench.input.radius_mm = 10.0;
        bench.input.tool = tool;
        bench.at(60.0, 60.0);
        bench.move({53.8, 60.0, 0.0}, 0.2);
        bench.hold(3.0);
        EXPECT_LT(bench.outer_at(66.0) - bench.outer_at(60.0), 0.5 * groove);
        EXPECT_EQ(bench.clay.volume_mm3() + bench.clay.ledger().slip_mm3, volume);
        expect_sound(bench.clay);
    }
}

TEST(Move, TheTrimmerTakesClayToTheTrimmings) {
    Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0}, {45.0, 8.0, 12.0, 100.0, 1000});
    bench.input.tool = tool::Tool::kTrimmer;
    bench.at(60.0, 40.0);
    bench.move({53.0, 40.0, 0.0}, 4.0);
    bench.hold(1.0);
    EXPECT_NEAR(bench.outer_at(40.0), 43.25, 0.05);
    EXPECT_NEAR(bench.inner_at(40.0), 37.0, 1e-9);
    EXPECT_NEAR(bench.clay.height_mm(), 100.0, 1e-4);
    EXPECT_GT(bench.clay.ledger().trimmings_mm3, 500.0);
    EXPECT_EQ(bench.clay.ledger_error_mm3(), 0.0);
}

TEST(Move, TheTrimmerCutsAFootAndNeverThroughTheWall) {
    Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0}, {45.0, 8.0, 12.0, 100.0, 1000});
    bench.clay.set_liquidity(0.0);  // leather-hard
    bench.input.tool = tool::Tool::kTrimmer;
    bench.input.radius_mm = 4.0;
    // Round the foot, whose clay is solid: a step of three millimetres, and nothing above it.
    bench.at(60.0, 5.0);
    bench.move({46.0 - 0.25, 5.0, 0.0}, 2.0);
    bench.hold(1.0);
    // The tip less the yield depth, and measured: 0.08 mm deeper with this tool, 0.04 mm with one of 10 mm
    // radius, at any height, water and patience.
    EXPECT_NEAR(bench.outer_at(5.0), 42.0, 0.1);
    EXPECT_EQ(bench.outer_at(12.5), 45.0);
    // Straight through the wall, which stops at the thinnest there is.
    bench.at(60.0, 60.0);
    bench.move({38.0, 60.0, 0.0}, 2.0);
    bench.hold(2.0);
    EXPECT_NEAR(bench.wall_at(60.0), kThinnestWallMm, 1e-6);
    EXPECT_NEAR(bench.wall_at(80.0), 8.0, 1e-9);
    EXPECT_NEAR(bench.clay.height_mm(), 100.0, 1e-4);
    expect_sound(bench.clay);
}

}  // namespace
}  // namespace onggi::clay::studio
