// The clay's stresses and when it collapses; every stress is computed by hand in a comment.
#include "game/clay/studio/load.h"

#include <array>
#include <bit>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/core/units.h"
#include "game/clay/studio/strength.h"
#include "tests/studio/bench.h"

namespace onggi::clay::studio {
namespace {

TEST(Strength, FollowsTheLiquidityIndex) {
    EXPECT_NEAR(strength_kpa(0.0), 180.0, 1e-9);
    EXPECT_NEAR(strength_kpa(1.0), 2.3, 1e-9);
    EXPECT_NEAR(strength_kpa(0.6), 180.0 * std::pow(2.3 / 180.0, 0.6), 1e-9);  // 13.2 kPa
    EXPECT_NEAR(strength_kpa(0.9), 3.56, 0.01);
    EXPECT_NEAR(flow_time_s(13.0, 0.1), 0.1, 1e-12);
    EXPECT_NEAR(flow_time_s(3.25, 0.1), 0.05, 1e-12) << "wetter clay gives way faster";
}

TEST(Load, OfACylinderIsItsWeight) {
    Bench bench;
    bench.wall(45.0, 6.0, 12.0, 112.0, 1000);
    Above above;
    for (int i = 999; i > bench.clay.rings().first_hollow; --i)
        above.volume_mm3 += bench.clay.rings().volume_mm3[static_cast<std::size_t>(i)];
    above.volume_radius_mm4 = above.volume_mm3 * 42.0;
    const Stress stress = stress_in(bench.clay.rings(), bench.clay.rings().first_hollow, above, 0.0, 0.0);
    // 100 mm of clay: 1900 kg/m^3 x 9.81 m/s^2 x 0.1 m = 1.864 kPa, whatever the wall.
    EXPECT_NEAR(stress.weight_kpa, -1.864, 0.002);
    EXPECT_NEAR(stress.bending_kpa, 0.0, 1e-9);
    EXPECT_EQ(stress.cause(), Cause::kWeight);
}

TEST(Load, OfSpinIsHoopStress) {
    Bench bench;
    bench.wall(100.0, 6.0, 12.0, 60.0, 600);
    const double w = units::rad_s_from_rev_min(200.0);
    const Stress stress = stress_in(bench.clay.rings(), 500, {}, w, 0.0);
    // 1900 x (20.94)^2 x 0.1^2 = 8334 Pa.
    EXPECT_NEAR(stress.spin_kpa, 8.334, 0.01);
    // A solid disc carries 0.41 times this.
    EXPECT_NEAR(stress_in(bench.clay.rings(), 5, {}, w, 0.0).spin_kpa, 0.41 * 8.334, 0.01);
    EXPECT_EQ(stress.cause(), Cause::kSpin);
}

TEST(Load, OfTheHandsIsTwist) {
    Bench bench;
    bench.wall(45.0, 2.0, 12.0, 60.0, 600);
    // 500 N mm on a mean radius of 44 mm and 2 mm of wall: 500/(2 pi 44^2 2) N/mm^2 = 20.55 kPa.
    const Stress stress = stress_in(bench.clay.rings(), 300, {}, 0.0, 500.0);
    EXPECT_NEAR(stress.twist_kpa, 20.55, 0.01);
    EXPECT_NEAR(stress.equivalent_kpa(), std::sqrt(3.0) * 20.55, 0.2);
    EXPECT_EQ(stress.cause(), Cause::kTwist);
}

// A bowl's wall: the mean radius grows from low to high over the hollow rings.
void flare(Bench& bench, double low, double high, double wall, double height, double liquidity) {
    bench.clay.set_liquidity(liquidity);
    const int rings = 800;
    bench.wall(low, wall, 8.0, height, rings);
    StudioClay& clay = bench.clay;
    // As a thrower would: from the bytes of a state, so that every bound is checked.
    Rings shaped = clay.rings();
    for (int i = shaped.first_hollow; i < shaped.count; ++i) {
        const double part =
            static_cast<double>(i - shaped.first_hollow) / (shaped.count - shaped.first_hollow);
        const double mean = low + (high - low) * part * (2.0 - part) - 0.5 * wall;
        const std::size_t at = Rings::at(i);
        shaped.outer_mm[at] = mean + 0.5 * wall;
        shaped.inner_mm[at] = mean - 0.5 * wall;
    }
    clay.set_profile(shaped.outer_mm, shaped.inner_mm);
}

struct Outcome {
    double index = 0.0;
    Failure failure;
    double height_before = 0.0;
    double height = 0.0;
    double widest = 0.0;
};

Outcome spin_bowl(double liquidity, double rev_min, bool forgiving = false) {
    Bench bench({.mass_g = 1500.0, .rings = 1000});
    flare(bench, 45.0, 100.0, 6.5, 75.0, liquidity);
    bench.parameters.forgiving = forgiving;
    bench.parameters.wheel = WheelParameters();  // which a hand slows
    bench.clay.set_wheel_speed(0.0);
    bench.input.wheel_button = true;
    bench.input.wheel_speed_rev_min = rev_min;
    bench.lift();
    Outcome outcome;
    outcome.height_before = bench.clay.height_mm();
    for (int k = 0; k < 4000; ++k) {
        bench.tick();
        outcome.index = std::max(outcome.index, bench.clay.load_index());
    }
    expect_sound(bench.clay);
    outcome.failure = bench.clay.failure();
    outcome.height = bench.clay.height_mm();
    for (const double outer : bench.clay.outer_mm())
        outcome.widest = std::max(outcome.widest, outer);
    return outcome;
}

TEST(Slump, ABowlTwentyCentimetresWideOfWetClayStandsAtSixtyTurnsAndFailsAtTwoHundred) {
    const Outcome slow = spin_bowl(0.9, 60.0);
    EXPECT_EQ(slow.failure.cause, Cause::kNone) << sentence(slow.failure);
    EXPECT_LT(slow.index, 1.0);
    EXPECT_GT(slow.index, 0.1);
    EXPECT_NEAR(slow.height, slow.height_before, 0.05);

    const Outcome fast = spin_bowl(0.9, 200.0);
    EXPECT_EQ(fast.failure.cause, Cause::kSpin);
    EXPECT_GT(fast.index, 1.1);
    EXPECT_LT(fast.height, fast.height_before - 3.0);
    EXPECT_GT(fast.widest, 105.0);
    EXPECT_LE(fast.widest, kWidestMm);
    EXPECT_NE(sentence(fast.failure).find("spun"), std::string::npos) << sentence(fast.failure);
}

TEST(Slump, StiffClayOfThatBowlStandsAtTwoHundred) {
    // Spin: 1900 x (20.94)^2 x 0.1^2 Pa = 8.33 kPa of tension around, against 2 su(0.5) = 40.7 kPa.
    const Outcome outcome = spin_bowl(0.5, 200.0);
    EXPECT_EQ(outcome.failure.cause, Cause::kNone) << sentence(outcome.failure);
    EXPECT_LT(outcome.index, 0.5);
    EXPECT_NEAR(outcome.height, outcome.height_before, 0.05);
}

// A cylinder 300 mm high on a floor of 12: its foot carries 1900 x 9.81 x 0.288 Pa = 5.37 kPa of pressure
// along the wall, whatever its thickness. Against 2 su: 4.60 kPa at LI 1.0 (index 1.17), 11.03 kPa at 0.8
// (0.49).
TEST(Slump, ATallCylinderSagsAtTheLiquidLimitAndStandsAFifthBelowIt) {
    const auto stand = [](double liquidity) {
        Bench bench({.mass_g = 2500.0, .rings = 1000});
        bench.clay.set_liquidity(liquidity);
        bench.wall(45.0, 6.0, 12.0, 300.0, 1500);
        bench.turn_at(units::rad_s_from_rev_min(20.0));
        bench.lift();
        bench.hold(3.0);
        expect_sound(bench.clay);
        return std::tuple{bench.clay.failure(), bench.clay.load_index(), bench.clay.height_mm()};
    };
    const auto [wet, wet_index, wet_height] = stand(1.0);
    EXPECT_EQ(wet.cause, Cause::kWeight) << sentence(wet);
    EXPECT_NEAR(wet.stress_kpa / (2.0 * wet.strength_kpa), wet.load_index, 1e-6);
    EXPECT_LT(wet.height_mm, 60.0) << "near the foot";
    EXPECT_LT(wet_height, 299.0);
    const auto [stiff, stiff_index, stiff_height] = stand(0.8);
    EXPECT_EQ(stiff.cause, Cause::kNone) << sentence(stiff);
    EXPECT_NEAR(stiff_index, 5.37 / 11.03, 0.03);
    EXPECT_NEAR(stiff_height, 300.0, 0.01);
}

// A neck 20 mm in mean radius with 3 mm of wall, under a flare of 50 mm on which a hand drags with 3 N: it
// carries 3 x 50 = 150 N mm, which is 150/(2 pi 20^2 3) N/mm^2 = 19.9 kPa of shear, equivalent to sqrt(3)
// times that, 34.5 kPa. Against 2 su: 7.1 kPa at LI 0.9 (index 4.8), 40.7 kPa at 0.5 (0.85).
// A leaning wall with a solid base, a lid, rough rows and water that differs from ring to ring.
Rings uneven_rings() {
    Bench bench({.mass_g = 500.0, .rings = 1000, .sectors = 64, .off_centre_mm = 0.0},
                {30.0, 4.0, 8.0, 70.0, 700});
    Rings shaped = bench.clay.rings();
    for (int i = 0; i < shaped.count; ++i) {
        const double lean = 0.1 * std::max(shaped.centre_mm(i) - 20.0, 0.0) + 0.01 * (i % 7);
        shaped.outer_mm[Rings::at(i)] += lean;
        if (shaped.is_hollow(i)) shaped.inner_mm[Rings::at(i)] = i > 690 ? 0.0 : 26.0 + lean;
    }
    bench.clay.set_profile(shaped.outer_mm, shaped.inner_mm);
    Rings rings = bench.clay.rings();
    for (int i = 0; i < rings.count; ++i) {
        set_liquidity(rings, i, 0.55 + 0.01 * (i % 13));
        rings.film[Rings::at(i)] = 0.1F * static_cast<float>(i % 3);
        if (i % 5 != 0) continue;
        rings.rough_mm[Rings::at(i)] = 0.4F;
        for (int s = 0; s < rings.sectors; ++s)
            rings.row_of(i)[s] = 0.05F * static_cast<float>((i + s) % 8);
    }
    return rings;
}

// The bits of everything that the sweep writes.
std::vector<float> swept(const Rings& rings, const LoadSweep& sweep) {
    std::vector<float> values;
    const auto add = [&](const std::vector<float>& column) {
        values.insert(values.end(), column.begin(), column.begin() + rings.count);
    };
    for (const auto* column :
         {&rings.load_index, &rings.shear, &rings.slump_rate, &rings.slump_above, &rings.slump_axial,
          &rings.slump_hoop, &rings.liquidity, &rings.film, &rings.strength_kpa, &rings.rough_mm})
        add(*column);
    for (const auto* column : {&rings.outer_mm, &rings.inner_mm, &rings.height_mm}) {
        for (int i = 0; i < rings.count; ++i) {
            const auto bits = std::bit_cast<std::array<float, 2>>((*column)[Rings::at(i)]);
            values.insert(values.end(), bits.begin(), bits.end());
        }
    }
    for (const double value :
         {sweep.above.volume_mm3, sweep.above.volume_radius_mm4, sweep.peak_index, sweep.peak_height_mm,
          sweep.growing_peak, sweep.growing_height_mm, sweep.failure.height_mm, sweep.failure.stress_kpa}) {
        const auto bits = std::bit_cast<std::array<float, 2>>(value);
        values.insert(values.end(), bits.begin(), bits.end());
    }
    for (const int value : {sweep.next, static_cast<int>(sweep.peak_cause),
                            static_cast<int>(sweep.growing_cause), static_cast<int>(sweep.failure.cause)})
        values.push_back(std::bit_cast<float>(value));
    values.push_back(sweep.running);
    return values;
}

TEST(Load, IsTheSameToTheBitWhetherRingsAreWeighedOneByOneOrTogether) {
    for (const auto& turned : {std::pair{0.0, 0.0}, {12.0, 300.0}, {45.0, 0.0}, {20.0, 60000.0}}) {
        const double speed = turned.first;
        const double twist = turned.second;
        const auto after_rounds = [&](int rings_a_call) {
            Rings rings = uneven_rings();
            LoadSweep sweep;
            restart(sweep, rings);
            for (int k = 0; k < 40 * 700; k += rings_a_call) {
                sweep.credit = rings_a_call;
                // The clay would settle the places after each call; here every call sees the same ones.
                sweep_load(sweep, rings,
                           {.wheel_speed_rad_s = speed,
                            .twist_n_mm = twist,
                            .twist_height_mm = 40.0,
                            .evaporation_g_mm2_s = 5.6e-8,
                            .diffusivity_mm2_s = 5e-3,
                            .dt_s = 0.0});
            }
            return swept(rings, sweep);
        };
        const std::vector<float> together = after_rounds(700);
        for (const int rings_a_call : {1, 20, 35, 100}) {
            const std::vector<float> apart = after_rounds(rings_a_call);
            ASSERT_EQ(together.size(), apart.size());
            EXPECT_EQ(std::memcmp(together.data(), apart.data(), together.size() * sizeof(float)), 0)
                << rings_a_call << " rings a call, " << speed << " rad/s, " << twist << " N mm";
        }
    }
}

TEST(Slump, ADraggingHandTwistsAThinWetNeckOffAndAStiffOneStands) {
    const auto twist = [](double liquidity, double drag_n) {
        Bench bench({.mass_g = 500.0, .rings = 1000, .off_centre_mm = 0.0});
        bench.clay.set_liquidity(liquidity);
        bench.wall(21.5, 3.0, 8.0, 70.0, 700);
        Rings shaped = bench.clay.rings();
        for (int i = shaped.first_hollow; i < shaped.count; ++i) {
            // Straight up to 30 mm, then a flare to 50 mm at 66.
            const double part = std::clamp((shaped.centre_mm(i) - 30.0) / 36.0, 0.0, 1.0);
            const double mean = 20.0 + 30.0 * part * part;
            shaped.outer_mm[Rings::at(i)] = mean + 1.5;
            shaped.inner_mm[Rings::at(i)] = mean - 1.5;
        }
        bench.clay.set_profile(shaped.outer_mm, shaped.inner_mm);
        Rings rings = bench.clay.rings();
        LoadSweep sweep;
        restart(sweep, rings);
        bool torn = false;
        double first_index = 0.0;  // of the first check of all rings, before any collapse
        for (int k = 0; k < 5000 && !torn; ++k) {
            sweep_load(sweep, rings,
                       {.wheel_speed_rad_s = 1.0,
                        .twist_n_mm = drag_n * 50.0,
                        .twist_height_mm = 68.0,
                        .dt_s = 0.001});
            torn = sweep.tear_at >= 0;
            if (first_index == 0.0) first_index = sweep.peak_index;
        }
        return std::tuple{sweep.failure, first_index, torn};
    };
    const auto [wet, wet_index, wet_torn] = twist(0.9, 3.0);
    EXPECT_EQ(wet.cause, Cause::kTwist) << sentence(wet);
    EXPECT_NEAR(wet_index, 34.5 / 7.12, 0.1);
    EXPECT_TRUE(wet_torn);
    const auto [stiff, stiff_index, stiff_torn] = twist(0.5, 3.0);
    EXPECT_EQ(stiff.cause, Cause::kNone) << sentence(stiff);
    EXPECT_NEAR(stiff_index, 34.5 / 40.7, 0.02);
    EXPECT_FALSE(stiff_torn);
    const auto [left, left_index, left_torn] = twist(0.9, 0.0);
    EXPECT_EQ(left.cause, Cause::kNone) << "it is the hand that does it: " << sentence(left);
    EXPECT_LT(left_index, 0.9);
    EXPECT_FALSE(left_torn);
}

TEST(Slump, OrdinaryClayOfThatBowlStandsAtTwoHundred) {
    const Outcome outcome = spin_bowl(0.6, 200.0);
    EXPECT_EQ(outcome.failure.cause, Cause::kNone) << sentence(outcome.failure);
    EXPECT_LT(outcome.index, 0.6);
}

TEST(Slump, AForgivingWheelSlowsBeforeTheClayGivesWay) {
    const Outcome outcome = spin_bowl(0.9, 200.0, true);
    EXPECT_EQ(outcome.failure.cause, Cause::kNone) << sentence(outcome.failure);
    EXPECT_GT(outcome.index, 0.7);
    EXPECT_LT(outcome.index, 1.0);
    EXPECT_NEAR(outcome.height, outcome.height_before, 0.05);
}

TEST(Slump, AFlatRimOfWetClaySags) {
    Bench bench({.mass_g = 2500.0, .rings = 1000});
    flare(bench, 40.0, 140.0, 4.0, 60.0, 1.0);
    bench.turn_at(units::rad_s_from_rev_min(20.0));
    bench.lift();
    const double before = bench.clay.height_mm();
    bench.hold(3.0);
    EXPECT_EQ(bench.clay.failure().cause, Cause::kOverhang) << sentence(bench.clay.failure());
    EXPECT_LT(bench.clay.height_mm(), before - 1.0);
    EXPECT_NE(sentence(bench.clay.failure()).find("sagged"), std::string::npos);
    expect_sound(bench.clay);
}

TEST(Slump, ATallWallOfSlurrySinksUnderItsWeight) {
    Bench bench({.mass_g = 2500.0, .rings = 1000});
    bench.clay.set_liquidity(1.1);  // su = 1.49 kPa: 2 su carry 160 mm of clay
    bench.wall(45.0, 6.0, 12.0, 220.0, 1000);
    bench.turn_at(units::rad_s_from_rev_min(20.0));
    bench.lift();
    bench.hold(2.0);
    EXPECT_EQ(bench.clay.failure().cause, Cause::kWeight) << sentence(bench.clay.failure());
    EXPECT_LT(bench.clay.failure().height_mm, 70.0) << "at the bottom, which carries the whole pot";
    EXPECT_LT(bench.clay.height_mm(), 219.0);
    // The bulge is below.
    EXPECT_GT(bench.outer_at(25.0), 45.5);
    expect_sound(bench.clay);
}

TEST(Slump, DryHandsTearAThinWetWallOff) {
    Bench bench({.mass_g = 500.0, .rings = 1000, .off_centre_mm = 0.0});
    bench.clay.set_liquidity(0.9);
    bench.wall(30.0, 1.6, 12.0, 90.0, 900);
    bench.parameters.friction_dry = 1.5;  // a hand that sticks
    bench.parameters.largest_force_n = 100.0;
    // Two real hands, 0.2 mm apart: the assist would not squeeze without an upward motion.
    bench.input.second.present = true;
    bench.input.second.position_mm = {17.8, 70.05, 0.0};
    bench.at(45.0, 70.05);
    bench.move({38.0, 70.05, 0.0}, 0.5);
    bench.hold(4.0);
    ASSERT_NE(bench.clay.failure().cause, Cause::kNone);
    EXPECT_EQ(bench.clay.failure().cause, Cause::kTwist) << sentence(bench.clay.failure());
    EXPECT_TRUE(bench.clay.failure().torn);
    EXPECT_GT(bench.clay.ledger().trimmings_mm3, 1000.0);
    expect_sound(bench.clay);
}

TEST(Water, TheSpongeWetsTheTouchedClayAndFrictionFalls) {
    Bench bench({.mass_g = 500.0, .off_centre_mm = 0.0}, {45.0, 6.5, 12.0, 80.0, 800});
    bench.at(54.5, 50.05);
    const auto rubbing = [&] { return bench.tick().hand; };
    const ContactForces dry = rubbing();
    const double dry_ratio =
        std::sqrt(glm::dot(dry.friction_n, dry.friction_n) / glm::dot(dry.stiffness_n, dry.stiffness_n));
    EXPECT_NEAR(dry_ratio, 0.5, 0.01);
    bench.input.water = 1.0;
    const ContactForces wet = rubbing();
    const double wet_ratio =
        std::sqrt(glm::dot(wet.friction_n, wet.friction_n) / glm::dot(wet.stiffness_n, wet.stiffness_n));
    EXPECT_NEAR(wet_ratio, 0.2, 0.01);

    bench.input.tool = tool::Tool::kSponge;
    bench.parameters.sponge_water_ml_s = 0.5;
    bench.hold(4.0);
    const Rings& rings = bench.clay.rings();
    EXPECT_GT(rings.liquidity[Rings::at(bench.ring_at(50.0))], rings.liquidity[0] + 0.02F);
    EXPECT_LT(rings.strength_kpa[Rings::at(bench.ring_at(50.0))], 0.95F * rings.strength_kpa[0]);
    EXPECT_GT(bench.clay.ledger().slip_mm3, 0.0);
    EXPECT_EQ(bench.clay.ledger_error_mm3(), 0.0);
}

TEST(Water, PassesFromRingToRing) {
    Bench bench({.mass_g = 500.0}, {45.0, 6.0, 12.0, 80.0, 800});
    Rings rings = bench.clay.rings();
    for (int i = 0; i < rings.count; ++i)
        set_liquidity(rings, i, rings.centre_mm(i) > 50.0 ? 0.8 : 0.6);
    const auto water = [&] {
        double sum = 0.0;
        for (int i = 0; i < rings.count; ++i)
            sum += static_cast<double>(rings.liquidity[Rings::at(i)]) * rings.volume_mm3[Rings::at(i)];
        return sum;
    };
    const double before = water();
    // Five minutes in steps of 0.4 s: diffusion over sqrt(4 x 0.005 x 300) = 2.4 mm to either side.
    for (int step = 0; step < 750; ++step) {
        // In the order of the load's rounds, which has no preference up or down.
        for (int round = 0; round < 16; ++round) {
            for (int i = rings.count - 1; i >= 0; --i) {
                if (((i ^ round) & 15) == 0)
                    refresh_ring(rings, i, {.elapsed_s = 0.4, .diffusivity_mm2_s = 5e-3});
            }
        }
    }
    const auto at = [&](double y) {
        return static_cast<double>(rings.liquidity[Rings::at(rings.ring_at(y))]);
    };
    EXPECT_NEAR(water(), before, 1e-5 * before) << "none is lost";
    EXPECT_NEAR(at(50.0), 0.7, 0.01);
    // 0.7 +- 0.1 erf(d/2.449), in the rings whose middles are 1.05 mm above the step and 0.95 mm below it.
    EXPECT_NEAR(at(51.0), 0.7456, 0.006);
    EXPECT_NEAR(at(49.0), 0.6583, 0.006);
    EXPECT_NEAR(at(70.0), 0.8, 1e-4);
    EXPECT_NEAR(at(30.0), 0.6, 1e-4);
    EXPECT_NEAR(static_cast<double>(rings.strength_kpa[Rings::at(rings.ring_at(70.0))]), strength_kpa(0.8),
                0.01);
}

TEST(Water, AWetHandLeavesAFilmThatSlidesAndSoaksIn) {
    Bench bench({.mass_g = 500.0, .off_centre_mm = 0.0}, {45.0, 6.0, 12.0, 80.0, 800});
    bench.input.water = 1.0;
    bench.at(54.5, 50.05);
    bench.hold(0.5);
    bench.input.water = 0.0;
    bench.lift();
    const Rings& rings = bench.clay.rings();
    const auto touched = Rings::at(bench.ring_at(50.05));
    EXPECT_GT(rings.film[touched], 0.9F);
    EXPECT_EQ(rings.film[Rings::at(bench.ring_at(20.0))], 0.0F) << "it was not there";
    bench.hold(20.0);
    EXPECT_NEAR(static_cast<double>(rings.film[touched]), std::exp(-1.0), 0.05);
    // Soaked in: 0.63 of 1e-5 g/mm^2 on one of two faces, over 6 mm of 1.52e-3 g/mm^3 dry clay, an index of
    // 0.2.
    EXPECT_NEAR(static_cast<double>(rings.liquidity[touched]) - 0.6, 0.63 * 1e-5 / (6.0 * 1.52e-3 * 0.2),
                1e-3);
}

TEST(Water, DriesFromThinWallsFaster) {
    Bench bench({.mass_g = 500.0}, {45.0, 5.0, 12.0, 80.0, 800});
    bench.parameters.evaporation_g_mm2_s = 5.6e-5;  // a thousand times the air's
    bench.lift();
    bench.hold(2.4);
    const Rings& rings = bench.clay.rings();
    // 5.6e-5 g/mm^2 s x 2/5 mm^-1 x 2.4 s over 1.52e-3 g/mm^3 dry clay and an index of 0.2: 0.177.
    EXPECT_NEAR(0.6 - static_cast<double>(rings.liquidity[Rings::at(bench.ring_at(50.0))]), 0.177, 0.04);
    EXPECT_GT(rings.liquidity[0], rings.liquidity[Rings::at(bench.ring_at(50.0))] + 0.1F);
}

TEST(Wheel, TakesItsTimeAndFeelsTheHand) {
    PoweredWheel wheel;
    const WheelParameters electric;
    int ticks = 0;
    while (wheel.speed_rad_s() < 0.95 * kThrowingSpeed && ticks < 10000) {
        wheel.step(kThrowingSpeed, 0.0, 0.001, electric);
        ++ticks;
    }
    // 6 N m on 0.12 kg m^2 is 50 rad/s^2: 12.6 rad/s in a quarter of a second.
    EXPECT_GT(ticks, 200);
    EXPECT_LT(ticks, 400);
    EXPECT_NEAR(wheel.heading().cosine * wheel.heading().cosine + wheel.heading().sine * wheel.heading().sine,
                1.0, 1e-12);
    for (int k = 0; k < 5000; ++k)
        wheel.step(kThrowingSpeed, 0.0, 0.001, electric);
    const double free = wheel.speed_rad_s();
    for (int k = 0; k < 5000; ++k)
        wheel.step(kThrowingSpeed, 1000.0, 0.001, electric);
    EXPECT_LT(wheel.speed_rad_s(), free - 0.2);
    for (int k = 0; k < 5000; ++k)
        wheel.step(kThrowingSpeed, 20000.0, 0.001, electric);
    EXPECT_EQ(wheel.speed_rad_s(), 0.0) << "more than the motor has stops it, and does not turn it back";
}

TEST(Wheel, AKickWheelRunsOnByItself) {
    PoweredWheel kicked({}, kThrowingSpeed);
    for (int k = 0; k < 10000; ++k)
        kicked.step(0.0, 0.0, 0.001, kick_wheel());
    // Drag 25 N mm s on 1.8 kg m^2: a time of 72 s; after 10 s 87 % are left.
    EXPECT_NEAR(kicked.speed_rad_s() / kThrowingSpeed, std::exp(-10.0 / 72.0), 0.001);
    PoweredWheel braked({}, kThrowingSpeed);
    for (int k = 0; k < 1000; ++k)
        braked.step(0.0, 0.0, 0.001, WheelParameters());
    EXPECT_LT(braked.speed_rad_s(), 0.05 * kThrowingSpeed);
}

}  // namespace
}  // namespace onggi::clay::studio
