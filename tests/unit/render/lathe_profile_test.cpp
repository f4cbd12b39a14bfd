#include "engine/render/shapes/lathe_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/render/lathe_samples.h"

namespace onggi::render {
namespace {

LatheProfile solid(const std::vector<float>& radii, float rounding_mm) {
    LatheProfile profile;
    build_profile({.radii_mm = radii, .element_height_mm = 0.1F, .edge_rounding_mm = rounding_mm}, profile);
    return profile;
}

// The volume enclosed by a walk with the clay on its left, turned about the axis: pi r^2 dy over all pieces.
double volume_mm3(const LatheProfile& profile) {
    double volume = 0.0;
    for (std::size_t i = 1; i < profile.points.size(); ++i) {
        const ProfilePoint& a = profile.points[i - 1];
        const ProfilePoint& b = profile.points[i];
        const double ra = a.radius_mm;
        const double rb = b.radius_mm;
        volume += 3.14159265358979 / 3.0 * (ra * ra + ra * rb + rb * rb) * (b.y_mm - a.y_mm);
    }
    return volume;
}

TEST(LatheProfile, EnclosesTheClayOfACylinderAndNotItsInside) {
    const Cylinder pot;
    const LatheProfile profile = pot.profile(0.0F);
    const double expected = 3.14159265358979 * (50.0 * 50.0 * 100.0 - 45.0 * 45.0 * 90.0);
    EXPECT_NEAR(volume_mm3(profile) / expected, 1.0, 1e-3);
    EXPECT_TRUE(profile.hollow);
    EXPECT_NEAR(profile.floor_mm, 10.0F, 1e-3F);
    EXPECT_EQ(profile.points.front().y_mm, 0.0F);
    EXPECT_EQ(profile.points.back().radius_mm, 0.0F);
    EXPECT_NEAR(profile.points.back().y_mm, 10.0F, 1e-3F);
}

TEST(LatheProfile, RoundsAThinRimIntoAHalfCircleOfHalfTheWall) {
    const LatheProfile profile = Cylinder(50.0F, 5.0F).profile(4.0F);
    EXPECT_FLOAT_EQ(profile.rounding_mm, 2.5F);
    for (std::size_t i = profile.edge; i < profile.inside; ++i) {
        const ProfilePoint& point = profile.points[i];
        EXPECT_NEAR(std::hypot(point.radius_mm - 47.5F, point.y_mm - 97.5F), 2.5F, 1e-3F) << i;
    }
    EXPECT_EQ(profile.inside - profile.edge, 2U * kQuarterSteps - 1);
}

TEST(LatheProfile, RoundsBothEdgesOfAThickRimAndLeavesItFlatBetween) {
    const LatheProfile profile = Cylinder(50.0F, 30.0F).profile(4.0F);
    float flat = 0.0F;
    for (std::size_t i = profile.edge; i <= profile.inside; ++i) {
        const float run = profile.points[i - 1].radius_mm - profile.points[i].radius_mm;
        EXPECT_GE(run, -1e-5F);
        flat = std::max(flat, run);
    }
    EXPECT_NEAR(flat, 22.0F, 1e-3F);
}

TEST(LatheProfile, ClosesASolidPotAcrossItsTopWithTheLargestEdgeThatFits) {
    const std::vector<float> radii(2000, 60.0F);
    const LatheProfile profile = solid(radii, 2.5F);
    EXPECT_FALSE(profile.hollow);
    EXPECT_FLOAT_EQ(profile.rounding_mm, 2.5F);
    EXPECT_FLOAT_EQ(profile.points[profile.edge - 1].y_mm, 197.5F);
    EXPECT_NEAR(profile.points.back().y_mm, 200.0F, 1e-3F);
    std::vector<float> pointed = radii;
    pointed.back() = 2.0F;
    EXPECT_FLOAT_EQ(solid(pointed, 2.5F).rounding_mm, 1.0F);
    EXPECT_GE(solid({60.0F}, 2.5F).points.size(), 2U);
    EXPECT_TRUE(solid({}, 2.5F).empty());
}

TEST(LatheProfile, TakesALumpThatIsClosedOnTopForSolid) {
    Cylinder pot;
    pot.inner.assign(pot.inner.size(), 0.0F);
    EXPECT_FALSE(pot.profile().hollow);
    // A hollow under a closed top cannot be seen and is not drawn.
    Cylinder closed;
    closed.inner.back() = 0.0F;
    EXPECT_FALSE(closed.profile().hollow);
}

TEST(LatheProfile, LeavesOutRingsOfNoHeightAndRadiiThatAreNotNumbers) {
    Cylinder pot;
    pot.outer[300] = std::numeric_limits<float>::quiet_NaN();
    pot.top[500] = pot.top[499];
    const LatheProfile profile = pot.profile();
    for (std::size_t i = 1; i < profile.points.size(); ++i) {
        EXPECT_TRUE(std::isfinite(profile.points[i].radius_mm)) << i;
        EXPECT_TRUE(std::isfinite(profile.points[i].along_mm)) << i;
        EXPECT_GE(profile.points[i].along_mm, profile.points[i - 1].along_mm) << i;
    }
}

TEST(LatheProfile, SamplesBothFacesByHeight) {
    const Cylinder pot(50.0F, 5.0F, 10.0F, 100.0F);
    const LatheSamples samples = samples_of(pot.profile(2.0F));
    EXPECT_FLOAT_EQ(samples.outer_mm[samples.at(50.0F)], 50.0F);
    EXPECT_FLOAT_EQ(samples.inner_mm[samples.at(50.0F)], 45.0F);
    EXPECT_EQ(samples.inner_mm[samples.at(5.0F)], 0.0F);
    EXPECT_LT(samples.outer_mm.back(), 49.0F) << "the rounded rim";
    EXPECT_GT(samples.inner_mm.back(), 46.0F);
    EXPECT_EQ(samples.at(-3.0F), 0U);
    EXPECT_EQ(samples.at(1e9F), LatheSamples::kCount - 1U);
}

vec2 unpacked(std::uint32_t texel) {
    return vec2(texel & 0xFFFFU, texel >> 16U) * (2.0F / 65535.0F) - 1.0F;
}

vec2 normal_at(const NormalTexels& texels, float place) {
    const auto& packed =
        texels[static_cast<std::size_t>(std::lround(place * shaders::kProfileTexels - 0.5F))];
    return unpacked(packed);
}

TEST(LatheProfile, PointsNormalsOutOfTheClayOnWallsRimAndFloor) {
    const LatheProfile profile = Cylinder().profile();
    NormalTexels texels{};
    profile_normals(profile, 0.5F, texels);
    const auto at_point = [&](std::size_t i) {
        return normal_at(texels, texture_place(profile, profile.points[i].along_mm));
    };
    EXPECT_NEAR(at_point(profile.edge / 2).x, 1.0F, 1e-3F);
    EXPECT_NEAR(at_point((profile.edge + profile.inside) / 2).y, 1.0F, 0.05F);
    EXPECT_NEAR(at_point((profile.inside + profile.floor) / 2).x, -1.0F, 1e-3F);
    EXPECT_NEAR(at_point(profile.floor + 1).y, 1.0F, 1e-3F);
    EXPECT_EQ(profile_normal(profile, 40.0F, 2.0F), vec2(1.0F, 0.0F));
}

TEST(LatheProfile, LeansNormalsByTheSlopeOfTheWall) {
    std::vector<float> radii;
    for (int i = 0; i < 2000; ++i)
        radii.push_back(80.0F - 0.025F * static_cast<float>(i));
    const LatheProfile profile = solid(radii, 0.0F);
    NormalTexels texels{};
    profile_normals(profile, 0.5F, texels);
    const vec2 expected = glm::normalize(vec2(1.0F, 0.25F));
    for (const float along : {10.0F, 100.0F, 180.0F}) {
        const vec2 normal = normal_at(texels, texture_place(profile, along));
        EXPECT_NEAR(normal.x, expected.x, 2e-3F) << along;
        EXPECT_NEAR(normal.y, expected.y, 2e-3F) << along;
    }
}

TEST(LatheProfile, FadesGroovesFinerThanAPixel) {
    std::vector<float> radii;
    for (int i = 0; i < 2000; ++i)
        radii.push_back(i / 2 % 2 == 0 ? 60.0F : 60.3F);  // 0.4 mm from groove to groove
    const LatheProfile profile = solid(radii, 0.0F);
    const auto steepest = [&](float footprint_mm) {
        NormalTexels texels{};
        profile_normals(profile, footprint_mm, texels);
        float most = 0.0F;
        for (std::size_t i = 16; i < shaders::kProfileTexels / 2; ++i)
            most = std::max(most, std::abs(unpacked(texels[i]).y));
        return most;
    };
    EXPECT_GT(steepest(0.2F), 0.3F);
    EXPECT_LT(steepest(6.0F), 0.12F);
}

}  // namespace
}  // namespace onggi::render
