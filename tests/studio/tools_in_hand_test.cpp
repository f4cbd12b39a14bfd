// Rib, sponge and wire in a hand that follows a finger: each does its job, and no tool can ruin a pot.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <span>

#include "game/clay/studio/pot.h"
#include "tests/studio/finger.h"

namespace onggi::clay::studio {
namespace {

constexpr double kHoleMm = 10.0;

// A cylinder with unsmoothed throwing rings, from a wavelength of 4 mm to one of 14.
Finger rough_pot(double rate_hz = 1000.0) {
    Finger finger(rate_hz);
    constexpr double kHeightMm = 120.0;
    finger.clay.set_wall(40.0, 8.0, kHoleMm, kHeightMm, 400);
    std::vector<double> outer(finger.clay.outer_mm().begin(), finger.clay.outer_mm().end());
    const std::vector<double> inner(finger.clay.inner_mm().begin(), finger.clay.inner_mm().end());
    for (std::size_t i = 0; i < outer.size(); ++i) {
        const double y_mm = kHeightMm * (static_cast<double>(i) + 0.5) / 400.0;
        outer[i] += 0.35 * std::sin(y_mm * 2.0 * std::numbers::pi / 4.0) +
                    0.35 * std::sin(y_mm * 2.0 * std::numbers::pi / 14.0);
    }
    finger.clay.set_profile(outer, inner);
    finger.wait(0.2);
    return finger;
}

// How far the outer face lies from its own mean over 30 mm, root of the mean square, between two heights.
double roughness_mm(const StudioClay& clay, double low_mm, double high_mm) {
    constexpr double kHalfMm = 15.0;
    double sum = 0.0;
    int counted = 0;
    const auto mean_at = [&](double y_mm) {
        double total = 0.0;
        int rings = 0;
        for (int i = 0; i < clay.ring_count(); ++i) {
            if (std::fabs(clay.centre_height_mm(i) - y_mm) > kHalfMm) continue;
            total += clay.outer_mm()[static_cast<std::size_t>(i)];
            ++rings;
        }
        return total / std::max(rings, 1);
    };
    for (int i = 0; i < clay.ring_count(); ++i) {
        const double y_mm = clay.centre_height_mm(i);
        if (y_mm < low_mm || y_mm > high_mm) continue;
        const double off = clay.outer_mm()[static_cast<std::size_t>(i)] - mean_at(y_mm);
        sum += off * off;
        ++counted;
    }
    return std::sqrt(sum / std::max(counted, 1));
}

double mean_liquidity(const StudioClay& clay, double low_mm, double high_mm) {
    double sum = 0.0;
    int counted = 0;
    for (int i = 0; i < clay.ring_count(); ++i) {
        const double y_mm = clay.centre_height_mm(i);
        if (y_mm < low_mm || y_mm > high_mm) continue;
        sum += static_cast<double>(clay.rings().liquidity[static_cast<std::size_t>(i)]);
        ++counted;
    }
    return sum / counted;
}

void draw_up(Finger& finger, tool::Tool tool, double seconds = 4.0) {
    finger.input.tool = tool;
    finger.input.radius_mm = 12.0;
    finger.stroke({41.0, 30.0}, {41.0, 100.0}, seconds);
}

TEST(ToolsInHand, ARibFairsTheWallAndKeepsItsHeight) {
    Finger finger = rough_pot();
    const double before_mm = roughness_mm(finger.clay, 45.0, 85.0);
    const double height_mm = finger.clay.height_mm();
    ASSERT_GT(before_mm, 0.3);
    draw_up(finger, tool::Tool::kRib);
    EXPECT_LT(roughness_mm(finger.clay, 45.0, 85.0), 0.25 * before_mm);
    EXPECT_NEAR(finger.clay.height_mm(), height_mm, 1.0);
    EXPECT_EQ(finger.forces.hand.contacts, 0) << "lifted at the end of the stroke";
}

TEST(ToolsInHand, ASpongeSmoothsWithoutFairing) {
    Finger by_sponge = rough_pot();
    Finger by_rib = rough_pot();
    const double before_mm = roughness_mm(by_sponge.clay, 45.0, 85.0);
    draw_up(by_sponge, tool::Tool::kSponge);
    draw_up(by_rib, tool::Tool::kRib);
    const double after_mm = roughness_mm(by_sponge.clay, 45.0, 85.0);
    EXPECT_LT(after_mm, 0.7 * before_mm);
    EXPECT_GT(after_mm, roughness_mm(by_rib.clay, 45.0, 85.0)) << "a soft thing follows the waves";
}

TEST(ToolsInHand, AWetSpongeGivesWaterAndASqueezedOneTakesIt) {
    Finger finger = rough_pot();
    finger.input.water = 1.0;
    const double fresh = mean_liquidity(finger.clay, 45.0, 85.0);
    draw_up(finger, tool::Tool::kSponge);
    const double wet = mean_liquidity(finger.clay, 45.0, 85.0);
    EXPECT_GT(wet, fresh + 0.02);
    finger.input.water = 0.0;
    draw_up(finger, tool::Tool::kSponge, 8.0);
    const double drained = mean_liquidity(finger.clay, 45.0, 85.0);
    EXPECT_LT(drained, wet - 0.5 * (wet - fresh));
    EXPECT_GT(drained, fresh - 0.02) << "what belongs to the clay stays in it";
}

TEST(ToolsInHand, TheWireLevelsTheRimToATenthOfAMillimetre) {
    Finger finger = rough_pot();
    finger.input.pressing = false;
    finger.input.wire = tool::Wire::kCutRim;
    finger.input.wire_height_mm = 113.3;
    finger.tick();
    finger.input.wire = tool::Wire::kNone;
    EXPECT_NEAR(finger.clay.height_mm(), 113.3, 0.1);
    finger.wait(0.1);
    EXPECT_NEAR(finger.clay.height_mm(), 113.3, 0.1);
    EXPECT_EQ(finger.clay.ledger_error_mm3(), 0.0);
    EXPECT_GT(finger.clay.ledger().trimmings_mm3, 0.0);
}

// Scrubs like a child: anywhere, in any direction, at any speed, for half a minute.
TEST(ToolsInHand, NoRibOrSpongeRuinsAPot) {
    for (const tool::Tool tool : {tool::Tool::kRib, tool::Tool::kSponge}) {
        Finger finger = rough_pot();
        std::minstd_rand random(tool == tool::Tool::kRib ? 7 : 11);
        std::uniform_real_distribution<double> across(-70.0, 70.0);
        std::uniform_real_distribution<double> up(-5.0, 140.0);
        const double volume_mm3 = finger.clay.volume_mm3();
        finger.input.tool = tool;
        finger.input.radius_mm = 20.0;
        finger.input.water = 0.25;
        for (int stroke = 0; stroke < 60; ++stroke) {
            const dvec2 to{across(random), up(random)};
            finger.stroke({across(random), up(random)}, to, 0.5);
        }
        EXPECT_EQ(finger.clay.failure().cause, Cause::kNone) << static_cast<int>(tool);
        EXPECT_GT(finger.clay.height_mm(), 105.0) << static_cast<int>(tool);
        EXPECT_GT(finger.clay.volume_mm3(), 0.98 * volume_mm3) << static_cast<int>(tool);
        EXPECT_LT(finger.clay.load_index(), 0.9);
    }
}

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST(ToolsInHand, LeaveAThrownPotAsTallAndAsWideInside) {
    for (const tool::Tool tool : {tool::Tool::kRib, tool::Tool::kSponge}) {
        Finger finger;
        finger.open();
        finger.pull(100.0);
        finger.pull(130.0);
        const double height_mm = finger.clay.height_mm();
        const double inside_mm = mean(finger.clay.inner_mm());
        const double outside_mm = mean(finger.clay.outer_mm());
        finger.input.tool = tool;
        finger.input.radius_mm = 12.0;
        for (int stroke = 0; stroke < 3; ++stroke)
            finger.stroke({45.0, 0.3 * height_mm}, {45.0, 0.8 * height_mm}, 2.0);
        EXPECT_NEAR(finger.clay.height_mm(), height_mm, 2.0) << static_cast<int>(tool);
        EXPECT_NEAR(mean(finger.clay.inner_mm()), inside_mm, 0.5) << static_cast<int>(tool);
        EXPECT_NEAR(mean(finger.clay.outer_mm()), outside_mm, 0.5) << static_cast<int>(tool);
    }
}

TEST(ToolsInHand, AFingerFarFromTheClayHasNoEffect) {
    Finger finger = rough_pot();
    const double before_mm = roughness_mm(finger.clay, 45.0, 85.0);
    const double height_mm = finger.clay.height_mm();
    finger.input.tool = tool::Tool::kRib;
    finger.stroke({90.0, 30.0}, {90.0, 100.0}, 0.5);
    finger.stroke({0.0, 170.0}, {20.0, 170.0}, 0.5);
    EXPECT_NEAR(roughness_mm(finger.clay, 45.0, 85.0), before_mm, 0.03) << "rings come together, no more";
    EXPECT_NEAR(finger.clay.height_mm(), height_mm, 0.01);
    EXPECT_EQ(finger.forces.side, Side::kFree);
}

TEST(ToolsInHand, AreTheSameOnceMoreToTheBit) {
    Finger one = rough_pot(4000.0);
    Finger other = rough_pot(4000.0);
    for (Finger* finger : {&one, &other}) {
        draw_up(*finger, tool::Tool::kRib, 1.0);
        draw_up(*finger, tool::Tool::kSponge, 1.0);
    }
    EXPECT_EQ(one.clay.state_hash(), other.clay.state_hash());
}

}  // namespace
}  // namespace onggi::clay::studio
