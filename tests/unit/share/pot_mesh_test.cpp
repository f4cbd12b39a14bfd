#include "game/share/pot_mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/hash.h"
#include "tests/support/pot_samples.h"

namespace onggi::share {
namespace {

TEST(UnitCircle, IsTheCircleThatLibmKnows) {
    for (const int n : {4, 12, 48, 64, 96, 128}) {
        const std::vector<dvec2> circle = unit_circle(n);
        ASSERT_EQ(circle.size(), static_cast<std::size_t>(n));
        for (int k = 0; k < n; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / n;
            EXPECT_NEAR(circle[static_cast<std::size_t>(k)].x, std::cos(angle), 1e-14) << k << " of " << n;
            EXPECT_NEAR(circle[static_cast<std::size_t>(k)].y, std::sin(angle), 1e-14) << k << " of " << n;
        }
    }
}

TEST(PotMesh, OfASmoothPotIsOfTheFinestSetting) {
    for (const support::PotSample& pot : support::all_pot_samples()) {
        const PotMesh built = build_pot_mesh(pot.shape());
        EXPECT_LE(built.mesh.triangle_count(), kMaxTriangles) << pot.name;
        if (!pot.hand_made) continue;
        EXPECT_EQ(built.tolerance_mm, 0.008) << pot.name;
        EXPECT_EQ(built.sectors, 128) << pot.name;
        EXPECT_EQ(built.elements, pot.radii_mm.size()) << pot.name;
        EXPECT_NEAR(built.radius_scale, 1.0002, 1e-4) << pot.name;
    }
}

TEST(PotMesh, OfRoughnessIsCoarserAndKeepsItsClayInPlace) {
    std::vector<float> radii_mm;
    for (int i = 0; i < 2000; ++i)
        radii_mm.push_back(i % 2 == 0 ? 60.0F : 2.0F);
    const PotMesh built = build_pot_mesh({200.0, radii_mm});
    EXPECT_LE(built.mesh.triangle_count(), kMaxTriangles);
    EXPECT_EQ(built.sectors, 48);
    EXPECT_EQ(built.elements, 1000U);
    // Every height holds the mean of a wide and a narrow element; the scale is the polygon's alone.
    for (const ProfilePoint& point : built.profile) {
        EXPECT_NEAR(point.radius_mm, built.radius_scale * std::sqrt(0.5 * (3600.0 + 4.0)), 1e-4);
    }
    EXPECT_NEAR(built.radius_scale, 1.0014, 1e-4);
}

// The outline's normal (x outward, y up) of the wall's vertices at one height, all of which must agree.
dvec2 wall_normal_at(const asset::Mesh& mesh, double y_m) {
    dvec2 found(0.0);
    int count = 0;
    for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
        const dvec3 position(mesh.positions_m[i]);
        const dvec3 normal(mesh.normals[i]);
        if (std::abs(position.y - y_m) > 1e-6) continue;
        const dvec3 outward = glm::normalize(dvec3(position.x, 0.0, position.z));
        const dvec2 in_plane(glm::dot(outward, normal), normal.y);
        EXPECT_NEAR(glm::length(in_plane), 1.0, 1e-5) << "a normal that leaves the plane through the axis";
        if (count > 0) {
            EXPECT_NEAR(glm::distance(in_plane, found), 0.0, 1e-5);
        }
        found = in_plane;
        ++count;
    }
    EXPECT_EQ(count, 128);
    return found;
}

TEST(PotMesh, HasTheNormalsOfTheCurveThatItCameFrom) {
    // A slice of a sphere of 100 mm about the middle of the height: normals point away from that middle.
    constexpr double kSphereMm = 100.0;
    constexpr double kHeightMm = 100.0;
    std::vector<float> radii_mm;
    for (int i = 0; i < 2000; ++i) {
        const double dy = (i + 0.5) * kHeightMm / 2000.0 - 0.5 * kHeightMm;
        radii_mm.push_back(static_cast<float>(std::sqrt(kSphereMm * kSphereMm - dy * dy)));
    }
    const PotMesh built = build_pot_mesh({kHeightMm, radii_mm});
    int compared = 0;
    for (std::size_t i = 1; i + 1 < built.profile.size(); ++i) {
        const double y_mm = built.profile[i].y_mm;
        if (y_mm < 1.0 || y_mm > kHeightMm - 1.0) continue;  // half an element at each end is upright
        const double up = (y_mm - 0.5 * kHeightMm) / kSphereMm;
        const dvec2 normal = wall_normal_at(built.mesh, y_mm * 1e-3);
        EXPECT_NEAR(normal.y, up, 0.01) << y_mm;  // half a degree
        ++compared;
    }
    EXPECT_GT(compared, 20);
}

TEST(PotMesh, HasAnEdgeWhereTheFlatTopMeetsTheWall) {
    const std::vector<float> radii_mm(100, 50.0F);
    const PotMesh built = build_pot_mesh({80.0, radii_mm});
    // Straight wall: two rings for it, a ring and a centre for each cap.
    EXPECT_EQ(built.profile.size(), 2U);
    EXPECT_EQ(built.mesh.positions_m.size(), 128U * 2 + 129U * 2);
    EXPECT_EQ(built.mesh.triangle_count(), 128U * 2 + 128U * 2);
    int up = 0;
    int sideways = 0;
    for (std::size_t i = 0; i < built.mesh.positions_m.size(); ++i) {
        if (built.mesh.positions_m[i].y < 0.08F) continue;
        up += built.mesh.normals[i] == vec3(0.0F, 1.0F, 0.0F);
        sideways += built.mesh.normals[i].y == 0.0F;
    }
    EXPECT_EQ(up, 129);
    EXPECT_EQ(sideways, 128);
}

TEST(PotMesh, IsTheSameOnEveryMachineAndBuild) {
    const support::PotSample pot = support::pressed_lump(100);
    // Worked out once; any compiler, build type and instruction set must agree.
    StateHash hash;
    for (const vec3& position : build_pot_mesh(pot.shape()).mesh.positions_m) {
        const std::array<float, 3> floats{position.x, position.y, position.z};
        hash.add(std::span<const float>(floats));
    }
    EXPECT_EQ(hash.value(), 831609294693242170ULL);
}

}  // namespace
}  // namespace onggi::share
