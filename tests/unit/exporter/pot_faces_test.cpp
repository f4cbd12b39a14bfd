#include "game/exporter/pot_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/pot_samples.h"

namespace onggi::exporter {
namespace {

constexpr int kCorners = 128;

Face outside_of(const PotRings& rings) {
    return face_of(rings, Which::kOuter, 0, rings.count(), kCorners);
}

// Heights and radii of the rows.
std::vector<dvec2> outline_of(const Face& face) {
    std::vector<dvec2> outline;
    for (const pot::SurfaceRow& row : face)
        outline.emplace_back(row.y_mm, row.radius_mm);
    return outline;
}

Face face_through(const std::vector<dvec2>& outline) {
    Face face;
    for (const dvec2& point : outline)
        face.push_back({.y_mm = point.x, .radius_mm = point.y, .dents_mm = {}});
    return face;
}

TEST(FaceOf, RunsThroughTheMiddlesAndIsUprightAtTheEnds) {
    const std::vector<float> radii_mm{60.0F, 59.0F, 58.5F, 58.5F};
    const std::vector<dvec2> expected{{0.0, 60.0},  {5.0, 60.0},  {15.0, 59.0},
                                      {25.0, 58.5}, {35.0, 58.5}, {40.0, 58.5}};
    EXPECT_EQ(outline_of(outside_of(rings_of(40.0, radii_mm))), expected);
}

TEST(FaceOf, KeepsAStepThatIsOneAsALedge) {
    const std::vector<float> radii_mm{60.0F, 10.0F};
    const std::vector<dvec2> expected{{0.0, 60.0}, {1.0, 60.0}, {2.0, 60.0},
                                      {2.0, 10.0}, {3.0, 10.0}, {4.0, 10.0}};
    EXPECT_EQ(outline_of(outside_of(rings_of(4.0, radii_mm))), expected);
}

// Linear between rows; at a ledge the upper side.
double radius_on(const Face& face, double y_mm) {
    const auto above = std::upper_bound(face.begin(), face.end(), y_mm,
                                        [](double y, const pot::SurfaceRow& row) { return y < row.y_mm; });
    if (above == face.end()) return face.back().radius_mm;
    const pot::SurfaceRow& a = *(above - 1);
    const double fraction = (y_mm - a.y_mm) / (above->y_mm - a.y_mm);
    return (1.0 - fraction) * a.radius_mm + fraction * above->radius_mm;
}

TEST(Thinned, StaysWithinItsToleranceOfEveryRow) {
    for (const support::PotSample& pot : support::all_pot_samples()) {
        if (!pot.hand_made) continue;
        const Face full = outside_of(pot.rings());
        for (const double tolerance_mm : {0.008, 0.064}) {
            const Face thin = thinned(full, tolerance_mm);
            EXPECT_EQ(thin.front().y_mm, 0.0);
            EXPECT_EQ(thin.back().y_mm, pot.height_mm);
            for (const pot::SurfaceRow& row : full) {
                if (&row != &full.back() && (&row + 1)->y_mm == row.y_mm) continue;  // a ledge's lower side
                ASSERT_NEAR(radius_on(thin, row.y_mm), row.radius_mm, tolerance_mm + 1e-9)
                    << pot.name << " at " << row.y_mm;
            }
        }
    }
}

TEST(Thinned, NeedsFewRowsForSmoothWallsAndTwoForStraightOnes) {
    const Face straight = face_through({{0.0, 60.0}, {50.0, 60.0}, {120.0, 60.0}, {200.0, 60.0}});
    EXPECT_EQ(outline_of(thinned(straight, 0.008)), (std::vector<dvec2>{{0.0, 60.0}, {200.0, 60.0}}));
    const Face cone = face_through({{0.0, 10.0}, {50.0, 20.0}, {100.0, 30.0}});
    EXPECT_EQ(outline_of(thinned(cone, 0.008)), (std::vector<dvec2>{{0.0, 10.0}, {100.0, 30.0}}));
    EXPECT_LT(thinned(outside_of(support::vase(200000).rings()), 0.008).size(), 200U);
}

TEST(Thinned, KeepsCornersAndLedges) {
    const std::vector<dvec2> stepped{{0.0, 60.0}, {50.0, 60.0}, {50.0, 30.0}, {100.0, 30.0}, {150.0, 60.0}};
    EXPECT_EQ(outline_of(thinned(face_through(stepped), 0.008)), stepped);
}

TEST(Halved, KeepsTheClayOfEachHeightWhereItMerges) {
    const std::vector<float> radii_mm{10.0F, 20.0F, 30.0F};
    const PotRings merged = halved(rings_of(6.0, radii_mm), Halving::kMerged);
    ASSERT_EQ(merged.count(), 2);
    EXPECT_EQ(merged.edge_mm, (std::vector<double>{0.0, 4.0, 6.0}));
    EXPECT_NEAR(merged.outer_mm[0], std::sqrt(0.5 * (100.0 + 400.0)), 1e-12);
    EXPECT_EQ(merged.outer_mm[1], 30.0) << "no partner";
    for (const support::PotSample& pot : support::all_pot_samples()) {
        PotRings rings = pot.rings();
        while (rings.count() > 1)
            rings = halved(rings, Halving::kMerged);
        EXPECT_NEAR(M_PI * rings.outer_mm[0] * rings.outer_mm[0] * rings.height_mm(), pot.rings().volume_mm3,
                    1e-9 * pot.rings().volume_mm3)
            << pot.name;
    }
}

TEST(Halved, TakesTheLowerOfTwoWhereItLeavesOut) {
    const std::vector<float> radii_mm{10.0F, 20.0F, 30.0F};
    const PotRings fewer = halved(rings_of(6.0, radii_mm), Halving::kEverySecond);
    EXPECT_EQ(fewer.edge_mm, (std::vector<double>{0.0, 4.0, 6.0}));
    EXPECT_EQ(fewer.outer_mm, (std::vector<double>{10.0, 30.0}));
}

TEST(Halved, LeavesSolidAndHollowRingsApart) {
    PotRings cup = rings_of(8.0, std::vector<float>(4, 40.0F));
    cup.inner_mm = {0.0, 30.0, 32.0, 34.0};
    const PotRings merged = halved(cup, Halving::kMerged);
    ASSERT_EQ(merged.count(), 3);
    EXPECT_FALSE(merged.is_hollow(0));
    EXPECT_NEAR(merged.inner_mm[1], std::sqrt(0.5 * (900.0 + 1024.0)), 1e-12);
    EXPECT_EQ(merged.inner_mm[2], 34.0);
}

}  // namespace
}  // namespace onggi::exporter
