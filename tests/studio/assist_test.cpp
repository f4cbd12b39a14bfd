// The assist (second hand): it supports a wall, carries it along, and squeezes only while moving up.
#include <algorithm>

#include "tests/studio/bench.h"

namespace onggi::clay::studio {
namespace {

// The largest change of a radius between two pots of the same clay, above the floor and below the rim.
double moved_mm(const StudioClay& before, const StudioClay& after) {
    double moved = 0.0;
    for (double y = before.floor_mm() + 1.0; y < std::min(before.height_mm(), after.height_mm()) - 1.0;
         y += 0.25) {
        const auto was = static_cast<std::size_t>(before.rings().ring_at(y));
        const auto is = static_cast<std::size_t>(after.rings().ring_at(y));
        moved = std::max({moved, std::fabs(after.outer_mm()[is] - before.outer_mm()[was]),
                          std::fabs(after.inner_mm()[is] - before.inner_mm()[was])});
    }
    return moved;
}

// A kilogram, opened to the floor and a little wider, the hand still inside.
void open_up(Bench& bench) {
    const double r1 = bench.input.radius_mm;
    bench.input.water = 1.0;
    bench.at(0.0, 90.0);
    bench.move({0.0, r1 + 10.0, 0.0}, 4.0);
    bench.move({4.0, r1 + 10.0, 0.0}, 1.0);
    bench.hold(1.0);
}

TEST(Assist, AHandHeldStillIsSupportedNotSqueezed) {
    for (const double off_centre : {0.0, 2.0}) {
        for (const double radius : {10.0, 12.6}) {
            Bench bench({.mass_g = 1000.0, .off_centre_mm = off_centre});
            bench.input.radius_mm = radius;
            open_up(bench);
            const StudioClay inside = bench.clay;
            bench.input.assist_gap_mm = 6.0;
            const StudioForces held = bench.hold(5.0);
            EXPECT_EQ(held.second_side, Side::kOut);
            EXPECT_LT(moved_mm(inside, bench.clay), 0.5) << "inside, " << radius;
            EXPECT_NEAR(bench.clay.height_mm(), inside.height_mm(), 1.0);

            bench.lift();
            bench.input.assist_gap_mm = 0.0;
            bench.at(100.0, 32.0);
            bench.move({bench.outer_at(32.0) + radius - 0.5, 32.0, 0.0}, 1.0);
            bench.hold(2.0);
            const StudioClay outside = bench.clay;
            bench.input.assist_gap_mm = 6.0;
            EXPECT_EQ(bench.hold(5.0).second_side, Side::kIn);
            EXPECT_LT(moved_mm(outside, bench.clay), 0.5) << "outside, " << radius;
            EXPECT_NEAR(bench.clay.height_mm(), outside.height_mm(), 1.0);
            expect_sound(bench.clay);
        }
    }
}

TEST(Assist, AHandSetIntoAThickWallRaisesNoChimney) {
    for (const double x : {10.0, 20.0, 30.0}) {
        const auto height = [x](double gap) {
            Bench bench({.mass_g = 1000.0});
            bench.input.radius_mm = 12.6;
            bench.at(0.0, 90.0);
            bench.move({0.0, 20.0, 0.0}, 4.0);
            bench.input.assist_gap_mm = gap;
            bench.at(x, 25.0);
            bench.hold(3.0);
            expect_sound(bench.clay);
            return bench.clay.height_mm();
        };
        // It was 70 to 93 mm with the second hand.
        EXPECT_LT(height(6.0), height(0.0) + 0.5) << x;
        EXPECT_LT(height(6.0), 62.0) << x;
    }
}

TEST(Assist, ATremblingHandDoesNotSqueeze) {
    Bench bench({.mass_g = 1000.0});
    open_up(bench);
    const StudioClay before = bench.clay;
    const dvec3 at = bench.input.position_mm;
    bench.input.assist_gap_mm = 6.0;
    // A tenth of a millimetre up and down at 10 Hz: up to 6 mm/s.
    for (int k = 0; k < 5000; ++k)
        bench.at(at.x, at.y + 0.1 * std::sin(2.0 * std::numbers::pi * 0.01 * k));
    EXPECT_LT(moved_mm(before, bench.clay), 0.5);
    EXPECT_NEAR(bench.clay.height_mm(), before.height_mm(), 1.0);
}

TEST(Assist, SqueezesOnTheWayUpAndNotOnTheWayDown) {
    const auto stroke = [](double from, double to) {
        Bench bench({.mass_g = 1500.0, .off_centre_mm = 0.0}, {45.0, 9.0, 12.0, 80.0, 800});
        bench.input.assist_gap_mm = 6.0;
        bench.at(70.0, from);
        bench.move({54.7, from, 0.0}, 0.5);
        bench.move({54.7, to, 0.0}, 2.0);
        expect_sound(bench.clay);
        return bench.wall_at(45.0);
    };
    EXPECT_NEAR(stroke(65.0, 25.0), 9.0, 0.1);
    EXPECT_LT(stroke(25.0, 65.0), 7.0);
    EXPECT_GT(stroke(25.0, 65.0), 5.9) << "the gap is the least there is";
}

TEST(Assist, AThickWallTakesSeveralPulls) {
    Bench bench({.mass_g = 1000.0});
    open_up(bench);
    bench.input.shaft_mm = 9.0;
    bench.move({20.0, 20.0, 0.0}, 3.0);
    bench.move({0.0, 100.0, 0.0}, 1.0);
    bench.input.shaft_mm = 0.0;
    double height = bench.clay.height_mm();
    double wall = bench.wall_at(30.0);
    EXPECT_GT(wall, 30.0);
    for (int pull = 0; pull < 2; ++pull) {
        bench.input.assist_gap_mm = 0.0;
        bench.lift();
        bench.at(90.0, 20.0);
        bench.move({bench.outer_at(20.0) + 9.5, 20.0, 0.0}, 0.7);
        bench.input.assist_gap_mm = 6.0;
        bench.move({60.0, height + 40.0, 0.0}, (height + 20.0) / 20.0);
        EXPECT_GT(bench.clay.height_mm(), height + 5.0) << "pull " << pull;
        EXPECT_LT(bench.clay.height_mm(), 2.0 * height) << "no chimney by pull " << pull;
        EXPECT_LT(bench.wall_at(30.0), wall - 2.0) << "pull " << pull;
        EXPECT_GT(bench.wall_at(30.0), 0.4 * wall) << "pull " << pull;
        height = bench.clay.height_mm();
        wall = bench.wall_at(30.0);
    }
    expect_sound(bench.clay);
}

TEST(Assist, SolidClayHasNoOtherSideToHold) {
    Bench bench({.mass_g = 1000.0});
    bench.input.assist_gap_mm = 6.0;
    bench.at(100.0, 25.0);
    const StudioForces on_lump = bench.move({60.0, 25.0, 0.0}, 1.0);
    EXPECT_EQ(on_lump.side, Side::kOut);
    EXPECT_FALSE(on_lump.has_second);
    bench.wall(45.0, 9.0, 30.0, 80.0, 800);
    bench.at(100.0, 20.0);
    EXPECT_FALSE(bench.move({54.0, 20.0, 0.0}, 0.5).has_second) << "beside the floor";
    EXPECT_TRUE(bench.move({54.0, 45.0, 0.0}, 0.5).has_second);
    EXPECT_NEAR(bench.clay.floor_mm(), 30.0, 0.5) << "nor does it bore";
}

struct Carried {
    double inner_mm;
    double outer_mm;
    double wall_mm;
    double height_mm;
};

// A ball inside a wall of 45 mm radius that goes 8 mm outward at half its height.
Carried belly(double wall, double gap, double rate_hz = 1000.0) {
    Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0}, {45.0, wall, 12.0, 100.0, 1000}, rate_hz);
    const double start = 45.0 - wall - bench.input.radius_mm;
    bench.at(0.0, 130.0);
    bench.move({0.0, 60.0, 0.0}, 0.3);
    bench.move({start, 60.0, 0.0}, 0.3);
    bench.input.assist_gap_mm = gap;
    bench.move({start + 8.0, 60.0, 0.0}, 2.0);
    bench.hold(0.5);
    expect_sound(bench.clay);
    return {bench.inner_at(60.0) - (45.0 - wall), bench.outer_at(60.0) - 45.0, bench.wall_at(60.0),
            bench.clay.height_mm()};
}

TEST(Assist, AWallHeldByBothIsCarriedOutwardAndNotSqueezed) {
    for (const double wall : {4.0, 6.5, 10.0}) {
        const Carried alone = belly(wall, 0.0);
        const Carried held = belly(wall, 5.0);
        EXPECT_GT(held.inner_mm, 7.5) << wall;
        EXPECT_GT(held.outer_mm, alone.outer_mm) << wall;
        EXPECT_GT(held.wall_mm, alone.wall_mm) << wall;
        // Clay that moves from radius R to R + d thins to t R/(R + d) in any case.
        const double middle = 45.0 - 0.5 * wall;
        EXPECT_NEAR(held.wall_mm, wall * middle / (middle + 0.5 * (held.inner_mm + held.outer_mm)),
                    0.08 * wall)
            << wall;
        EXPECT_LT(held.height_mm, 100.5) << "what is carried does not rise: " << wall;
    }
}

TEST(Assist, TwoRealHandsCarryTheWall) {
    Bench bench({.mass_g = 1000.0, .off_centre_mm = 0.0}, {45.0, 8.0, 12.0, 100.0, 1000});
    bench.input.second.present = true;
    const double squeezed = 0.5;  // by both together
    const auto hold_at = [&](double outward) {
        bench.input.second.position_mm = {55.0 - 0.5 * squeezed + outward, 60.0, 0.0};
        return bench.at(27.0 + 0.5 * squeezed + outward, 60.0);
    };
    for (int k = 0; k < 500; ++k)
        hold_at(0.0);
    const double held = bench.wall_at(60.0);
    EXPECT_NEAR(held, 8.0, 0.1) << "each within the yield";
    StudioForces forces;
    for (int k = 1; k <= 4000; ++k)
        forces = hold_at(8.0 * k / 4000.0);
    EXPECT_EQ(forces.side, Side::kIn);
    EXPECT_EQ(forces.second_side, Side::kOut);
    // Two balls support a belly less than a whole hand, but more than nothing behind it.
    const Carried alone = belly(8.0, 0.0);
    EXPECT_NEAR(bench.inner_at(60.0), 45.0, 0.6);
    EXPECT_GT(bench.outer_at(60.0), 45.0 + alone.outer_mm + 0.3);
    EXPECT_GT(bench.wall_at(60.0), alone.wall_mm + 0.3);
    EXPECT_LT(bench.clay.height_mm(), 100.5);
    expect_sound(bench.clay);
}

TEST(Rate, MakesNoDifferenceToTwoHandsNorToAPress) {
    const auto pressed = [](double rate_hz) {
        Bench bench({.mass_g = 1000.0}, rate_hz);
        bench.at(25.0, 62.0);
        bench.move({25.0, 40.0, 0.0}, 1.5);
        return bench.clay.height_mm();
    };
    const auto pulled = [](double rate_hz) {
        Bench bench({.mass_g = 1500.0, .off_centre_mm = 0.0}, {45.0, 9.0, 12.0, 80.0, 800}, rate_hz);
        bench.input.assist_gap_mm = 6.0;
        bench.at(70.0, 20.0);
        bench.move({54.5, 20.0, 0.0}, 0.5);
        bench.move({54.5, 90.0, 0.0}, 3.5);
        return bench.clay.height_mm();
    };
    const Carried fine = belly(8.0, 5.0, 8000.0);
    for (const double rate : {500.0, 1000.0, 4000.0}) {
        const Carried other = belly(8.0, 5.0, rate);
        EXPECT_NEAR(other.outer_mm, fine.outer_mm, 0.1) << rate;
        EXPECT_NEAR(other.inner_mm, fine.inner_mm, 0.1) << rate;
        EXPECT_NEAR(pulled(rate), pulled(8000.0), 0.3) << rate;
        EXPECT_NEAR(pressed(rate), pressed(8000.0), 0.3) << rate;
    }
}

}  // namespace
}  // namespace onggi::clay::studio
