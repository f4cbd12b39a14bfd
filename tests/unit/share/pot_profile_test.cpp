#include "game/share/pot_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/pot_samples.h"

namespace onggi::share {
namespace {

TEST(FullProfile, RunsThroughTheMiddlesAndIsUprightAtTheEnds) {
    const std::vector<float> radii_mm{60.0F, 59.0F, 58.5F, 58.5F};
    const Profile expected{{0.0, 60.0}, {5.0, 60.0}, {15.0, 59.0}, {25.0, 58.5}, {35.0, 58.5}, {40.0, 58.5}};
    EXPECT_EQ(full_profile({40.0, radii_mm}), expected);
}

TEST(FullProfile, KeepsAStepThatIsOneAsALedge) {
    const std::vector<float> radii_mm{60.0F, 10.0F};
    const Profile expected{{0.0, 60.0}, {1.0, 60.0}, {2.0, 60.0}, {2.0, 10.0}, {3.0, 10.0}, {4.0, 10.0}};
    EXPECT_EQ(full_profile({4.0, radii_mm}), expected);
    EXPECT_NEAR(volume_mm3(expected), clay_volume_mm3({4.0, radii_mm}), 1e-9);
}

TEST(FullProfile, LosesLessThanAThousandthOfAnyPotsClay) {
    for (const support::PotSample& pot : support::all_pot_samples()) {
        const double clay = clay_volume_mm3(pot.shape());
        EXPECT_NEAR(volume_mm3(full_profile(pot.shape())), clay, 1e-3 * clay) << pot.name;
    }
}

TEST(ClayVolume, IsTheSumOfTheElements) {
    const std::vector<float> radii_mm{10.0F, 20.0F};
    EXPECT_NEAR(clay_volume_mm3({6.0, radii_mm}), M_PI * (100.0 + 400.0) * 3.0, 1e-9);
    EXPECT_EQ(clay_volume_mm3({6.0, {}}), 0.0);
}

TEST(Volume, OfAConeIsAThirdOfItsCylinder) {
    EXPECT_NEAR(volume_mm3({{0.0, 30.0}, {90.0, 0.0}}), M_PI * 900.0 * 90.0 / 3.0, 1e-9);
}

// Linear between points; at a ledge the upper side.
double radius_on(const Profile& profile, double y_mm) {
    const auto above = std::upper_bound(profile.begin(), profile.end(), y_mm,
                                        [](double y, const ProfilePoint& point) { return y < point.y_mm; });
    if (above == profile.end()) return profile.back().radius_mm;
    const ProfilePoint& a = *(above - 1);
    const double share = (y_mm - a.y_mm) / (above->y_mm - a.y_mm);
    return (1.0 - share) * a.radius_mm + share * above->radius_mm;
}

TEST(Simplified, StaysWithinItsToleranceOfEveryPoint) {
    for (const support::PotSample& pot : support::all_pot_samples()) {
        if (!pot.hand_made) continue;
        const Profile full = full_profile(pot.shape());
        for (const double tolerance_mm : {0.008, 0.064}) {
            const Profile thin = simplified(full, tolerance_mm);
            EXPECT_EQ(thin.front().y_mm, 0.0);
            EXPECT_EQ(thin.back().y_mm, pot.height_mm);
            for (const ProfilePoint& point : full) {
                if (&point != &full.back() && (&point + 1)->y_mm == point.y_mm)
                    continue;  // a ledge's lower side
                ASSERT_NEAR(radius_on(thin, point.y_mm), point.radius_mm, tolerance_mm + 1e-9)
                    << pot.name << " at " << point.y_mm;
            }
        }
    }
}

TEST(Simplified, NeedsFewPointsForSmoothWallsAndTwoForStraightOnes) {
    const Profile straight{{0.0, 60.0}, {50.0, 60.0}, {120.0, 60.0}, {200.0, 60.0}};
    EXPECT_EQ(simplified(straight, 0.008), (Profile{{0.0, 60.0}, {200.0, 60.0}}));
    const Profile cone{{0.0, 10.0}, {50.0, 20.0}, {100.0, 30.0}};
    EXPECT_EQ(simplified(cone, 0.008), (Profile{{0.0, 10.0}, {100.0, 30.0}}));
    const support::PotSample vase = support::vase(200000);
    EXPECT_LT(simplified(full_profile(vase.shape()), 0.008).size(), 200U);
}

TEST(Simplified, KeepsCornersAndLedges) {
    const Profile stepped{{0.0, 60.0}, {50.0, 60.0}, {50.0, 30.0}, {100.0, 30.0}, {150.0, 60.0}};
    EXPECT_EQ(simplified(stepped, 0.008), stepped);
}

TEST(Simplified, SwallowsALedgeBelowItsTolerance) {
    const Profile stepped{{0.0, 60.0}, {50.0, 60.0}, {50.0, 59.95}, {100.0, 59.95}};
    const Profile thin = simplified(stepped, 0.05);
    ASSERT_EQ(thin.size(), 2U);
    EXPECT_NEAR(thin[0].radius_mm, 59.975, 0.05);
}

TEST(Resampled, KeepsTheClayOfEachHeight) {
    const std::vector<float> radii_mm{10.0F, 20.0F, 30.0F};
    EXPECT_EQ(resampled(radii_mm, 3), radii_mm);
    const std::vector<float> halves = resampled(radii_mm, 2);
    ASSERT_EQ(halves.size(), 2U);
    EXPECT_FLOAT_EQ(halves[0], std::sqrt((100.0F + 0.5F * 400.0F) / 1.5F));
    EXPECT_FLOAT_EQ(halves[1], std::sqrt((0.5F * 400.0F + 900.0F) / 1.5F));
    for (const support::PotSample& pot : support::all_pot_samples()) {
        for (const std::size_t count : {std::size_t{1}, (pot.radii_mm.size() + 1) / 2, pot.radii_mm.size()}) {
            const double clay = clay_volume_mm3(pot.shape());
            const std::vector<float> fewer = resampled(pot.radii_mm, count);
            EXPECT_NEAR(clay_volume_mm3({pot.height_mm, fewer}), clay, 1e-6 * clay)
                << pot.name << ' ' << count;
        }
    }
}

}  // namespace
}  // namespace onggi::share
