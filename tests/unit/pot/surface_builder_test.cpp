#include "game/pot/surface_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

namespace onggi::pot {
namespace {

constexpr int kCorners = 48;

TEST(UnitCircle, AgreesWithLibm) {
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

// A cup: a wall that leans out, a flat rim, an inside down to a floor.
Walk cups_walk() {
    Walk walk;
    for (int i = 0; i <= 10; ++i)
        walk.rows.push_back({.y_mm = 8.0 * i, .radius_mm = 30.0 + i});
    for (int i = 10; i >= 1; --i)
        walk.rows.push_back({.y_mm = 8.0 * i, .radius_mm = 24.0 + i, .inside = true});
    return walk;
}

SurfaceBuilder surface_of(const Walk& walk, bool unwraps) {
    SurfaceBuilder surface(kCorners, unwraps);
    surface.add_walk(walk);
    surface.finish_normals();
    return surface;
}

SurfaceBuilder cup(bool unwraps) {
    return surface_of(cups_walk(), unwraps);
}

TEST(SurfaceBuilder, ClosesTheSurfaceByPosition) {
    for (const bool unwraps : {false, true}) {
        const SurfaceBuilder surface = cup(unwraps);
        using Place = std::tuple<double, double, double>;
        std::map<std::pair<Place, Place>, int> edges;
        const auto place = [&](std::size_t i) {
            const dvec3& p = surface.positions_mm[surface.indices[i]];
            return Place{p.x + 0.0, p.y + 0.0, p.z + 0.0};
        };
        for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
            for (std::size_t k = 0; k < 3; ++k)
                ++edges[{place(i + k), place(i + (k + 1) % 3)}];
        }
        for (const auto& [edge, count] : edges) {
            ASSERT_EQ(count, 1);
            ASSERT_TRUE(edges.contains({edge.second, edge.first}));
        }
    }
}

TEST(SurfaceBuilder, EnclosesTheFrustumsOfItsRows) {
    // The area of a regular polygon of kCorners corners on the unit circle.
    const double area = 0.5 * kCorners * std::sin(2.0 * std::numbers::pi / kCorners);
    const auto frustum = [&](double low, double high, double height) {
        return area * height / 3.0 * (low * low + low * high + high * high);
    };
    EXPECT_NEAR(cup(false).volume_mm3(), frustum(30.0, 40.0, 80.0) - frustum(25.0, 34.0, 72.0), 1e-6);
    EXPECT_NEAR(cup(true).volume_mm3(), cup(false).volume_mm3(), 1e-6);
}

TEST(SurfaceBuilder, SaysWhereEachVertexLiesAboutTheAxis) {
    const SurfaceBuilder surface = cup(true);
    std::size_t vertices = 0;
    for (const SurfaceBuilder::Strip& strip : surface.strips()) {
        for (std::uint32_t k = 0; k < strip.count; ++k, ++vertices) {
            const double angle = 2.0 * std::numbers::pi * surface.turns(strip, k);
            const dvec2 outward = surface.outward(strip, k);
            ASSERT_NEAR(outward.x, std::cos(angle), 1e-12);
            ASSERT_NEAR(outward.y, std::sin(angle), 1e-12);
            const dvec3& p = surface.positions_mm[strip.first + k];
            ASSERT_NEAR(p.x, strip.radius_mm * outward.x, 1e-12);
            ASSERT_NEAR(p.z, -strip.radius_mm * outward.y, 1e-12) << "+Z is towards who sees X to the right";
            ASSERT_EQ(p.y, strip.y_mm);
        }
        if (strip.is_middle) continue;
        EXPECT_EQ(surface.turns(strip, strip.count - 1), 1.0);
    }
    EXPECT_EQ(vertices, surface.positions_mm.size());
}

TEST(SurfaceBuilder, IsSmoothAlongAWallAndPartedAtAnEdge) {
    const SurfaceBuilder surface = cup(false);
    std::map<double, int> rows_at;  // of the outside's and the inside's together
    for (const SurfaceBuilder::Strip& strip : surface.strips())
        rows_at[strip.y_mm] += strip.is_middle ? 0 : 1;
    EXPECT_EQ(rows_at[40.0], 2) << "one of each face";
    EXPECT_EQ(rows_at[80.0], 4) << "each face's own, and the rim's two";
    for (const SurfaceBuilder::Strip& strip : surface.strips()) {
        const dvec3& normal = surface.normals[strip.first];
        EXPECT_NEAR(glm::length(normal), 1.0, 1e-12);
        if (strip.y_mm != 40.0) continue;
        EXPECT_EQ(normal.x > 0.0, !strip.inside);
    }
}

TEST(SurfaceBuilder, RoundsEdges) {
    const Walk sharp = cups_walk();
    const Walk round = rounded(sharp, {.within_mm = 0.6, .apart_mm = 0.3}, kCorners);
    EXPECT_EQ(round.rows.size(), sharp.rows.size() + 10) << "two more an edge, and the discs' rings";
    const SurfaceBuilder surface = surface_of(round, false);
    EXPECT_NEAR(surface.volume_mm3() / cup(false).volume_mm3(), 1.0, 1e-3);
    int on_the_rim = 0;
    for (const SurfaceBuilder::Strip& strip : surface.strips()) {
        const dvec3& normal = surface.normals[strip.first];
        if (strip.y_mm > 79.5 && strip.y_mm < 80.0) {
            ++on_the_rim;
            EXPECT_NEAR(normal.y, std::sqrt(0.5), 0.1) << "half way round the edge";
        }
    }
    EXPECT_EQ(on_the_rim, 2) << "one row an edge";
    EXPECT_EQ(rounded(sharp, {.within_mm = 0.6, .apart_mm = 2.0}, kCorners).rows.size(), sharp.rows.size())
        << "no room for more rows";
}

// The largest angle between a face of the surface and the normal of one of its corners, degrees.
double most_off_degrees(const SurfaceBuilder& surface) {
    double least = 1.0;
    for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return surface.indices[i + k]; };
        const dvec3& a = surface.positions_mm[corner(0)];
        const dvec3 face = glm::normalize(
            glm::cross(surface.positions_mm[corner(1)] - a, surface.positions_mm[corner(2)] - a));
        for (std::size_t k = 0; k < 3; ++k)
            least = std::min(least, glm::dot(face, surface.normals[corner(k)]));
    }
    return std::acos(least) * 180.0 / std::numbers::pi;
}

// A client draws a dark pixel where a shared normal points away from the eye and its face does not.
TEST(SurfaceBuilder, RoundsAnEdgeThatHasRowsBesideIt) {
    constexpr Rounding kGlaze{.within_mm = 1.2, .apart_mm = 0.3};
    const Walk plain = cups_walk();
    Walk crowded = plain;
    const SurfaceRow beside{.y_mm = 79.6, .radius_mm = 33.95, .inside = true};  // 0.4 mm below the rim
    crowded.rows.insert(crowded.rows.begin() + 12, beside);
    Walk thin = plain;  // a rim that two roundings divide
    for (SurfaceRow& row : thin.rows)
        if (row.inside) row.radius_mm += 4.0;
    for (const Walk& walk : {plain, crowded, thin}) {
        const Walk round = rounded(walk, kGlaze, kCorners);
        EXPECT_LT(most_off_degrees(surface_of(round, false)), 35.0);
        for (std::size_t i = 1; i < round.rows.size(); ++i)
            EXPECT_GE(distance_mm(round.rows[i - 1], round.rows[i]), kGlaze.apart_mm);
    }
}

}  // namespace
}  // namespace onggi::pot
