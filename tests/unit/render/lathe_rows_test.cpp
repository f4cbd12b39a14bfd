#include "engine/render/shapes/lathe_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/render/lathe_samples.h"

namespace onggi::render {
namespace {

LatheRows rows_of(const LatheProfile& profile, const RowBudget& budget = {}) {
    return choose_rows(profile, profile.points.size(), budget);
}

TEST(LatheRows, WalkTheWholeOutlineInOrderWithoutALeap) {
    const LatheProfile profile = Cylinder().profile();
    const LatheRows chosen = rows_of(profile);
    EXPECT_EQ(chosen.points.front(), 0U);
    EXPECT_EQ(chosen.points.back(), profile.points.size() - 1);
    for (std::size_t i = 1; i < chosen.points.size(); ++i) {
        EXPECT_GT(chosen.points[i], chosen.points[i - 1]);
        const ProfilePoint& before = profile.points[chosen.points[i - 1]];
        const ProfilePoint& here = profile.points[chosen.points[i]];
        EXPECT_LT(std::abs(here.y_mm - before.y_mm), 9.5F);
    }
}

TEST(LatheRows, NeverAreMoreThanTheCapHoweverRoughBothFaces) {
    Cylinder pot;
    for (std::size_t i = 0; i < pot.outer.size(); ++i) {
        const auto noise = static_cast<float>((i * 2654435761U >> 7U) % 100U) * 0.02F;
        pot.outer[i] += noise;
        if (pot.inner[i] > 0.0F) pot.inner[i] -= noise;
    }
    const LatheProfile profile = pot.profile();
    for (const int cap : {32, 48, 64, 96, 128, 256}) {
        const LatheRows chosen = rows_of(profile, {.tolerance_mm = 0.01F, .max_rows = cap});
        EXPECT_LE(chosen.points.size(), static_cast<std::size_t>(cap));
        EXPECT_GT(chosen.points.size(), 24U);
        EXPECT_GT(chosen.tolerance_mm, 0.01F);
    }
}

TEST(LatheRows, OmitTheInsideForACameraBelowTheRim) {
    const LatheProfile profile = Cylinder().profile();
    EXPECT_EQ(points_seen(profile, {0.0F, 60.0F, 800.0F}, 0.0F), profile.inside);
    EXPECT_EQ(points_seen(profile, {0.0F, 800.0F, 10.0F}, 0.0F), profile.points.size())
        << "from straight above the floor shows";
}

TEST(LatheRows, ReachAsFarDownInsideAsTheLineOverTheNearRim) {
    const LatheProfile profile = Cylinder().profile();
    // From 45 degrees the line over the near rim meets the far wall 90 mm across, 90 mm down minus the rim.
    const std::size_t seen = points_seen(profile, {0.0F, 100.0F + 700.0F, 45.0F + 700.0F}, 0.0F);
    EXPECT_GT(seen, profile.inside);
    const float steep = points_seen(profile, {0.0F, 100.0F + 200.0F, 45.0F + 700.0F}, 0.0F) > 0
                            ? profile.points[points_seen(profile, {0.0F, 300.0F, 745.0F}, 0.0F) - 1].y_mm
                            : 0.0F;
    // Two in seven: 90 * 2 / 7 = 25.7 mm down from the inner rim, and the margin.
    EXPECT_NEAR(steep, 100.0F - 25.7F, 6.0F);
    EXPECT_LT(steep, 100.0F - 25.7F + 2.5F) << "nothing that shows may be left out";
}

TEST(LatheRows, IncludeTheInsideVisibleThroughANeck) {
    Cylinder pot;
    for (std::size_t i = 0; i < pot.outer.size(); ++i) {
        if (pot.top[i] > 85.0F) {
            pot.outer[i] = 25.0F;
            pot.inner[i] = 20.0F;
        }
    }
    const LatheProfile profile = pot.profile();
    const vec3 eye{0.0F, 300.0F, 700.0F};
    const std::size_t seen = points_seen(profile, eye, 0.0F);
    EXPECT_LT(seen, points_seen(Cylinder().profile(), eye, 0.0F));
    EXPECT_GT(profile.points[seen - 1].y_mm, 75.0F);
}

TEST(LatheRows, BringWaterAndLoadOfTheirRings) {
    Cylinder pot;
    std::vector<float> film(pot.outer.size(), 0.0F);
    std::fill(film.begin() + 500, film.end(), 0.8F);
    std::vector<float> load(pot.outer.size(), 0.25F);
    Lathe lathe = pot.lathe();
    lathe.film = film;
    lathe.load = load;
    lathe.material.wetness = 0.4F;
    const LatheProfile profile = pot.profile();
    std::vector<shaders::RowData> rows;
    fill_rows(lathe, profile, samples_of(profile), rows_of(profile), rows);
    for (const shaders::RowData& row : rows) {
        EXPECT_FLOAT_EQ(row.water.x, 0.4F) << "no column: the material's";
        EXPECT_FLOAT_EQ(row.water.y, row.place.y > 50.0F ? 0.8F : 0.0F) << row.place.y;
        EXPECT_FLOAT_EQ(row.water.z, 0.25F);
        EXPECT_GE(row.light.z, 0.0F);
        EXPECT_LE(row.light.z, 1.0F);
    }
}

TEST(LatheRows, AreDarkerDeepInsideThanAtTheRim) {
    const Cylinder pot;
    const LatheProfile profile = pot.profile();
    std::vector<shaders::RowData> rows;
    const LatheRows chosen = rows_of(profile);
    fill_rows(pot.lathe(), profile, samples_of(profile), chosen, rows);
    const float at_rim = rows[chosen.inside].light.z;
    float deepest = 1.0F;
    for (std::size_t i = chosen.inside; i < rows.size(); ++i)
        deepest = std::min(deepest, rows[i].light.z);
    EXPECT_GT(at_rim, 0.35F);
    EXPECT_LT(deepest, 0.6F * at_rim);
    EXPECT_EQ(rows[chosen.inside - 1].light.w, 0.0F);
    EXPECT_EQ(rows[chosen.inside].light.w, 1.0F);
}

}  // namespace
}  // namespace onggi::render
