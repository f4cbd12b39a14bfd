#include "engine/render/shapes/relief.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace onggi::render {
namespace {

Background background_of(Relief relief) {
    Background background;
    background.width_px = 160;
    background.height_px = 90;
    background.camera = {
        .eye_mm = {0.0F, 285.0F, 805.0F}, .target_mm = {0.0F, 82.0F, 0.0F}, .vertical_fov_rad = 0.471F};
    background.relief = std::move(relief);
    return background;
}

TEST(Relief, PutsEachCornerAsFarAwayAsItSaysAndWhereTheBackgroundShowsIt) {
    const Background background =
        background_of({.columns = 3, .rows = 2, .depth_mm = {500, 900, 1500, 700, 800, 2500}});
    const ReliefMesh mesh = relief_mesh(background);
    ASSERT_EQ(mesh.positions_mm.size(), 5U * 4U) << "a margin of one corner all round";
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 3; ++column) {
            const vec3 corner = mesh.positions_mm[static_cast<std::size_t>((row + 1) * 5 + column + 1)];
            const auto seen = project(background.camera, 160, 90, dvec3(corner));
            ASSERT_TRUE(seen);
            EXPECT_NEAR(seen->pixel.x, 80.0 * column, 1e-2);
            EXPECT_NEAR(seen->pixel.y, 90.0 * row, 1e-2);
            EXPECT_NEAR(
                seen->depth_mm,
                static_cast<double>(background.relief.depth_mm[static_cast<std::size_t>(row * 3 + column)]),
                1e-2);
        }
    }
}

TEST(Relief, HasAMarginOutsideTheBackground) {
    const Background background = background_of({.columns = 2, .rows = 2, .depth_mm = {900, 900, 900, 900}});
    const ReliefMesh mesh = relief_mesh(background);
    const auto first = project(background.camera, 160, 90, dvec3(mesh.positions_mm.front()));
    ASSERT_TRUE(first);
    EXPECT_NEAR(first->pixel.x, -80.0, 0.1);
    EXPECT_NEAR(first->pixel.y, -45.0, 0.1);
}

TEST(Relief, IsFlatWhereNothingIsKnown) {
    const Background background = background_of({});
    for (const vec3& corner : relief_mesh(background).positions_mm) {
        const auto seen = project(background.camera, 160, 90, dvec3(corner));
        ASSERT_TRUE(seen);
        EXPECT_NEAR(seen->depth_mm, 2.0 * 830.2, 0.5);
    }
}

TEST(Relief, IndexesOnlyCornersItHas) {
    const ReliefMesh mesh =
        relief_mesh(background_of({.columns = 4, .rows = 3, .depth_mm = std::vector<float>(12, 800.0F)}));
    EXPECT_EQ(mesh.indices.size(), 5U * 4U * 6U);
    EXPECT_LT(*std::max_element(mesh.indices.begin(), mesh.indices.end()), mesh.positions_mm.size());
}

}  // namespace
}  // namespace onggi::render
