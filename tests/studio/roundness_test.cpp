// Off-centre clay and sectors: felt once per revolution, centred by a steady hand, dented on a standing
// wheel.
#include <algorithm>

#include "tests/studio/bench.h"

namespace onggi::clay::studio {
namespace {

constexpr double kHandHeight = 20.05;

double off_centre(const Bench& bench) {
    const dvec2 c = bench.clay.centre_mm(bench.ring_at(kHandHeight));
    return std::sqrt(c.x * c.x + c.y * c.y);
}

Bench lump_off_centre(double e) {
    Bench bench({.mass_g = 500.0, .off_centre_mm = 0.0}, {50.0, 50.0, 40.0, 40.0, 400});
    bench.clay.set_centre({e, 0.0});
    return bench;
}

TEST(Centring, ASteadyHandAtTheSurfaceCentresAtHalfTheRate) {
    Bench bench = lump_off_centre(3.0);
    bench.at(59.0, kHandHeight);
    const double expected[] = {3.0, 1.80, 1.09, 0.66, 0.40, 0.24};  // 3 exp(-t/(2 tau_c)): half of each turn
    for (int second = 1; second <= 5; ++second) {
        bench.hold(1.0);
        EXPECT_NEAR(off_centre(bench), expected[second], 0.12) << second << " s";
    }
    EXPECT_NEAR(bench.outer_at(kHandHeight), 49.25, 0.1) << "centred, not coned away";
}

TEST(Centring, AHandTwoMillimetresAwayTouchesOnlyClayInReach) {
    Bench bench = lump_off_centre(3.0);
    bench.at(62.0, kHandHeight);
    bench.hold(10.0);
    EXPECT_NEAR(off_centre(bench), 2.25, 0.05);  // its distance and the yield depth
    EXPECT_EQ(bench.outer_at(kHandHeight), 50.0);
}

TEST(Centring, AnUnsteadyHandMakesItWorse) {
    Bench bench = lump_off_centre(0.0);
    bench.at(59.0, kHandHeight);
    // 2 mm at the wheel's own frequency.
    for (int k = 0; k < 6000; ++k) {
        const double angle = kThrowingSpeed * k / 1000.0;
        bench.at(59.0 + 2.0 * std::cos(angle), kHandHeight);
        if (k == 2000) {
            EXPECT_GT(off_centre(bench), 0.6);
        }
    }
    EXPECT_GT(off_centre(bench), 0.95);
    EXPECT_LT(off_centre(bench), 2.2);
}

TEST(Centring, OffCentreClayIsFeltOnceARevolution) {
    Bench bench = lump_off_centre(3.0);
    bench.parameters.centring_time_s = 100.0;
    double before = bench.at(60.0, kHandHeight).hand.stiffness_n.x;
    int beats = 0;
    double strongest = 0.0;
    for (int k = 0; k < 2000; ++k) {  // four turns
        const double force = bench.tick().hand.stiffness_n.x;
        if (force > 1.0 && before <= 1.0) ++beats;
        before = force;
        strongest = std::max(strongest, force);
    }
    EXPECT_EQ(beats, 4);
    EXPECT_GT(strongest, 5.0);
}

// A wall that a hand has dented from one side, on a standing wheel; the hand is in the dent.
Bench dented_wall(double held_s, double from_mm = 60.0, double rate_hz = 1000.0) {
    Bench bench({.mass_g = 500.0, .off_centre_mm = 0.0}, {50.0, 8.0, 12.0, 60.0, 600}, rate_hz);
    bench.turn_at(0.0);
    bench.at(from_mm, 40.05);
    bench.move({57.0, 40.05, 0.0}, 0.5);
    bench.hold(held_s);
    return bench;
}

TEST(Sectors, AStandingWheelDentsUnderTheHandOnly) {
    const Bench bench = dented_wall(2.0);
    const int ring = bench.ring_at(40.05);
    const auto row = bench.clay.residuals_mm(ring);
    ASSERT_EQ(row.size(), 256U);
    EXPECT_LT(row[0], -2.2F);
    EXPECT_LT(row[255], -2.2F);
    EXPECT_NEAR(row[128], 0.0F, 0.2F) << "the other side keeps its place, but for the mean";
    // The row moves no clay: its mean went into the radii.
    double mean = 0.0;
    for (const float w : row)
        mean += static_cast<double>(w) / 256.0;
    EXPECT_NEAR(mean, 0.0, 0.01);
    EXPECT_TRUE(bench.clay.residuals_mm(bench.ring_at(5.0)).empty());
    expect_sound(bench.clay);
}

TEST(Sectors, ATurningWheelUnderAHandRoundsThem) {
    Bench bench = dented_wall(1.0);
    const auto roughness = [&] {
        const auto row = bench.clay.residuals_mm(bench.ring_at(40.05));
        float most = 0.0F;
        for (const float w : row)
            most = std::max(most, std::fabs(w));
        return most;
    };
    const float dented = roughness();
    bench.lift();
    bench.turn_at(kThrowingSpeed);
    bench.hold(1.0);
    EXPECT_NEAR(roughness(), dented, 0.2F) << "nothing rounds it without a hand";
    bench.at(59.0, 40.05);
    bench.hold(1.5);
    EXPECT_LT(roughness(), 0.3F * dented);
    bench.hold(4.0);
    EXPECT_LT(roughness(), 0.02F * dented);
    expect_sound(bench.clay);
}

// A dent pressed while the wheel stands, rounded a little by a hand on the turning wheel, then left: what
// every point of the wall is at, R + w.
std::vector<double> dented_wall_at(double rate_hz) {
    Bench bench = dented_wall(0.5, 62.0, rate_hz);
    bench.lift();
    bench.turn_at(kThrowingSpeed);
    bench.at(59.0, 40.05);
    bench.hold(0.75);
    bench.lift();
    bench.turn_at(0.0);
    bench.hold(1.0);  // every row's mean has gone into its ring
    std::vector<double> wall;
    for (double y = 26.0; y < 55.0; y += 0.5) {
        const int ring = bench.ring_at(y);
        const auto row = bench.clay.residuals_mm(ring);
        for (std::size_t s = 0; s < 256; ++s) {
            const double w = row.empty() ? 0.0 : static_cast<double>(row[s]);
            wall.push_back(bench.clay.outer_mm()[static_cast<std::size_t>(ring)] + w);
        }
    }
    return wall;
}

TEST(Sectors, AreTheSameAtEveryRate) {
    const std::vector<double> fine = dented_wall_at(8000.0);
    const auto [least, most] = std::minmax_element(fine.begin(), fine.end());
    EXPECT_GT(*most - *least, 1.0) << "there is a dent to compare";
    for (const double rate : {500.0, 1000.0, 4000.0}) {
        const std::vector<double> other = dented_wall_at(rate);
        ASSERT_EQ(other.size(), fine.size());
        double sum = 0.0;
        for (std::size_t i = 0; i < fine.size(); ++i)
            sum += (fine[i] - other[i]) * (fine[i] - other[i]);
        const double rms = std::sqrt(sum / static_cast<double>(fine.size()));
        std::printf("a dent at %.0f Hz against 8 kHz: %.4f mm\n", rate, rms);
        EXPECT_LT(rms, 0.1) << rate << " Hz";
    }
}

TEST(Sectors, ADentIsFeltWhereItIs) {
    Bench bench = dented_wall(2.0);
    const double in_the_dent = bench.at(59.5, 40.05).hand.stiffness_n.x;
    bench.lift();
    const double beside_it = -bench.at(-59.5, 40.05).hand.stiffness_n.x;
    EXPECT_EQ(in_the_dent, 0.0);
    EXPECT_GT(beside_it, 0.5);
}

}  // namespace
}  // namespace onggi::clay::studio
