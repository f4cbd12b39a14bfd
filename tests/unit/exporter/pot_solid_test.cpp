#include "game/exporter/pot_solid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "engine/core/hash.h"
#include "tests/support/pot_samples.h"

namespace onggi::exporter {
namespace {

PotSolid solid_of(const PotRings& rings) {
    auto solid = build_pot_solid(rings);
    EXPECT_TRUE(solid) << solid.error().message;
    return std::move(solid).value();
}

TEST(PotSolid, OfASmoothPotIsOfTheFinestSetting) {
    for (const support::PotSample& pot : support::all_pot_samples()) {
        const PotSolid built = solid_of(pot.rings());
        EXPECT_LE(built.mesh.triangle_count(), kMaxTriangles) << pot.name;
        if (!pot.hand_made) continue;
        EXPECT_EQ(built.tolerance_mm, 0.008) << pot.name;
        EXPECT_EQ(built.corners, 128) << pot.name;
        EXPECT_EQ(built.rings, pot.rings().count()) << pot.name;
        EXPECT_NEAR(built.across_scale, 1.0002, 1e-4) << pot.name;
    }
}

TEST(PotSolid, OfRoughnessIsCoarserAndKeepsItsClayInPlace) {
    std::vector<float> radii_mm;
    for (int i = 0; i < 2000; ++i)
        radii_mm.push_back(i % 2 == 0 ? 60.0F : 2.0F);
    const PotSolid built = solid_of(rings_of(200.0, radii_mm));
    EXPECT_LE(built.mesh.triangle_count(), kMaxTriangles);
    EXPECT_EQ(built.corners, 48);
    EXPECT_EQ(built.rings, 1000);
    // Every height holds the mean of a wide and a narrow ring; the scale is the polygon's alone.
    for (const vec3& position : built.mesh.positions_m) {
        const double radius_mm = 1e3 * std::hypot(double{position.x}, double{position.z});
        if (radius_mm == 0.0) continue;  // the middle of a disc
        EXPECT_NEAR(radius_mm, built.across_scale * std::sqrt(0.5 * (3600.0 + 4.0)), 1e-4);
    }
    EXPECT_NEAR(built.across_scale, 1.0014, 1e-4);
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

TEST(PotSolid, HasTheNormalsOfTheCurveThatItCameFrom) {
    // A slice of a sphere of 100 mm about the middle of the height: normals point away from that middle.
    constexpr double kSphereMm = 100.0;
    constexpr double kHeightMm = 100.0;
    std::vector<float> radii_mm;
    for (int i = 0; i < 2000; ++i) {
        const double dy = (i + 0.5) * kHeightMm / 2000.0 - 0.5 * kHeightMm;
        radii_mm.push_back(static_cast<float>(std::sqrt(kSphereMm * kSphereMm - dy * dy)));
    }
    const PotSolid built = solid_of(rings_of(kHeightMm, radii_mm));
    int compared = 0;
    std::set<float> heights_m;
    for (const vec3& position : built.mesh.positions_m)
        heights_m.insert(position.y);
    for (const float y_m : heights_m) {
        const double y_mm = 1e3 * double{y_m};
        if (y_mm < 1.0 || y_mm > kHeightMm - 1.0) continue;  // half an element at each end is upright
        const double up = (y_mm - 0.5 * kHeightMm) / kSphereMm;
        const dvec2 normal = wall_normal_at(built.mesh, double{y_m});
        EXPECT_NEAR(normal.y, up, 0.01) << y_mm;  // half a degree
        ++compared;
    }
    EXPECT_GT(compared, 20);
}

TEST(PotSolid, HasAnEdgeWhereTheFlatTopMeetsTheWall) {
    const std::vector<float> radii_mm(100, 50.0F);
    const PotSolid built = solid_of(rings_of(80.0, radii_mm));
    // Straight wall: two rings for it, a ring and a centre for each cap.
    EXPECT_EQ(built.rows, 2U);
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

TEST(PotSolid, IsTheSameOnEveryMachineAndBuild) {
    const support::PotSample pot = support::pressed_lump(100);
    // A fixed value; any compiler, build type and instruction set must agree.
    StateHash hash;
    for (const vec3& position : solid_of(pot.rings()).mesh.positions_m) {
        const std::array<float, 3> floats{position.x, position.y, position.z};
        hash.add(std::span<const float>(floats));
    }
    EXPECT_EQ(hash.value(), 831609294693242170ULL);
}

}  // namespace
}  // namespace onggi::exporter
