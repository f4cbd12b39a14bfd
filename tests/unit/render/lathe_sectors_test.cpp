#include "engine/render/shapes/frame_build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

constexpr LatheSeen kVase{.widest_px = 145.0F, .rim_px = 60.0F, .azimuth_rad = 1.2F, .pitch_rad = 0.35F};

float widest_sector(const std::vector<float>& angles) {
    float widest = 0.0F;
    for (std::size_t i = 1; i < angles.size(); ++i)
        widest = std::max(widest, angles[i] - angles[i - 1]);
    return widest;
}

TEST(LatheSectors, GoOnceRoundFromTheEyeAndAreTheSameOnBothSides) {
    const std::vector<float> angles = seen_sectors(kVase, {});
    ASSERT_GE(angles.size(), 3U);
    EXPECT_FLOAT_EQ(angles.front(), kVase.azimuth_rad);
    EXPECT_NEAR(angles.back(), kVase.azimuth_rad + kTurnF, 1e-5F);
    EXPECT_TRUE(std::is_sorted(angles.begin(), angles.end()));
    for (std::size_t i = 0; i < angles.size(); ++i) {
        EXPECT_NEAR(angles[i] - angles.front(), angles.back() - angles[angles.size() - 1 - i], 1e-5F);
    }
    // The one opposite the first.
    EXPECT_NEAR(angles[(angles.size() - 1) / 2], kVase.azimuth_rad + kPiF, 1e-5F);
}

TEST(LatheSectors, KeepEveryVisibleEdgeWithinItsErrorOfTheCircle) {
    const SectorBudget budget{.error_px = 0.35F, .max_sectors = 96};
    const std::vector<float> angles = seen_sectors(kVase, budget);
    for (std::size_t i = 1; i < angles.size(); ++i) {
        const float middle = 0.5F * (angles[i] + angles[i - 1]) - kVase.azimuth_rad;
        const float sag = 1.0F - std::cos(0.5F * (angles[i] - angles[i - 1]));
        // The visible part of the chord's distance from the circle.
        const float seen = std::hypot(std::sin(middle), std::cos(middle) * std::sin(kVase.pitch_rad));
        EXPECT_LE(kVase.rim_px * sag * seen, 1.2F * budget.error_px);
        if (std::abs(std::sin(middle)) > 0.85F) {
            EXPECT_LE(kVase.widest_px * sag, 1.2F * budget.error_px);
        }
    }
}

TEST(LatheSectors, AreFewerThanEvenOnesOfTheSameErrorAndNeverMoreThanMayBe) {
    const std::vector<float> angles = seen_sectors(kVase, {.error_px = 0.35F, .max_sectors = 96});
    const float even = 2.0F * std::acos(1.0F - 0.35F / kVase.widest_px);
    EXPECT_LT(static_cast<float>(angles.size()), 0.85F * kTurnF / even);
    EXPECT_LE(widest_sector(angles), 18.5F * kPiF / 180.0F);

    const LatheSeen large{.widest_px = 2000.0F, .rim_px = 2000.0F, .azimuth_rad = 0.0F, .pitch_rad = 0.8F};
    EXPECT_EQ(seen_sectors(large, {.error_px = 0.1F, .max_sectors = 48}).size(), 49U);
    EXPECT_GE(seen_sectors({}, {.error_px = 0.35F, .max_sectors = 48}).size(), 17U);
}

TEST(LatheSectors, RunEvenlyOverHalfATurnWhereThePotIsCut) {
    const Lathe whole;
    const std::vector<float> round = even_sectors(whole, 64);
    ASSERT_EQ(round.size(), 65U);
    EXPECT_FLOAT_EQ(round[16], 0.5F * kPiF);
    Lathe cut;
    cut.cut.emplace();
    cut.cut->towards_rad = 0.5F;
    const std::vector<float> half = even_sectors(cut, 64);
    EXPECT_FLOAT_EQ(half.front(), kPiF - 0.5F);
    EXPECT_FLOAT_EQ(half.back() - half.front(), kPiF);
}

}  // namespace
}  // namespace onggi::render
