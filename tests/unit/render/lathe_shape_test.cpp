#include "engine/render/lathe_shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::render {
namespace {

Lathe lathe_of(std::span<const float> radii, float rounding_mm = 0.0F) {
    return {.radii_mm = radii, .element_height_mm = 0.1F, .edge_rounding_mm = rounding_mm};
}

std::vector<shaders::RingData> rings_of(const Lathe& lathe) {
    const LatheOutline outline = outline_of(lathe);
    std::vector<shaders::RingData> rings;
    lathe_rings(outline, lathe.element_height_mm, choose_rings(outline.wall, {.max_step = 100}), rings);
    return rings;
}

TEST(LatheShape, ReachesFromTheBaseToTheTopWithoutRounding) {
    const std::vector<float> radii(2000, 60.0F);
    const auto rings = rings_of(lathe_of(radii));
    EXPECT_EQ(rings.front().y_mm, 0.0F);
    EXPECT_NEAR(rings.back().y_mm, 200.0F, 1e-3F);
    for (std::size_t i = 1; i < rings.size(); ++i) {
        EXPECT_GE(rings[i].y_mm, rings[i - 1].y_mm);
        EXPECT_GE(rings[i].profile_u, rings[i - 1].profile_u);
    }
    EXPECT_EQ(rings.front().profile_u, 0.5F / shaders::kProfileTexels);
    EXPECT_FLOAT_EQ(rings.back().profile_u, (shaders::kProfileWallTexels - 0.5F) / shaders::kProfileTexels);
}

TEST(LatheShape, EndsTheWallWhereTheRoundingBegins) {
    const std::vector<float> radii(2000, 60.0F);
    const LatheOutline outline = outline_of(lathe_of(radii, 2.5F));
    EXPECT_FLOAT_EQ(outline.rounding_mm, 2.5F);
    EXPECT_FLOAT_EQ(outline.wall_height_mm, 197.5F);
    EXPECT_EQ(outline.wall.size(), 1975U);
    EXPECT_FLOAT_EQ(rings_of(lathe_of(radii, 2.5F)).back().y_mm, 197.5F);
}

TEST(LatheShape, RoundsNoMoreThanThereIsRoomFor) {
    std::vector<float> radii(2000, 60.0F);
    radii.back() = 2.0F;
    EXPECT_FLOAT_EQ(outline_of(lathe_of(radii, 2.5F)).rounding_mm, 1.0F);
    const std::vector<float> one{60.0F};
    EXPECT_EQ(outline_of(lathe_of(one, 2.5F)).wall.size(), 1U);
    EXPECT_GE(rings_of(lathe_of(one)).size(), 2U);
}

TEST(LatheShape, SeesTheWholeSkyFromAStraightWallAndHalfFromTheFootOfALedge) {
    const std::vector<float> straight(2000, 60.0F);
    for (const auto& ring : rings_of(lathe_of(straight)))
        EXPECT_EQ(ring.open_sky, 1.0F);

    std::vector<float> ledge(2000, 30.0F);
    std::fill(ledge.begin() + 1000, ledge.end(), 60.0F);
    const auto rings = rings_of(lathe_of(ledge));
    const auto under =
        std::find_if(rings.begin(), rings.end(), [](const auto& ring) { return ring.element == 999; });
    ASSERT_NE(under, rings.end());
    EXPECT_NEAR(under->open_sky, 0.5F, 0.01F);  // nothing above, all below
    EXPECT_GT(rings.front().open_sky, 0.9F);
}

TEST(LatheShape, PacksTheNormalsOfWallEdgeAndTop) {
    std::vector<float> radii;
    for (int i = 0; i < 2000; ++i)
        radii.push_back(60.0F - 0.1F * 0.5F * static_cast<float>(i) * 0.5F);  // leans in: slope -0.25
    NormalTexels texels{};
    lathe_normals(outline_of(lathe_of(radii, 2.0F)), 0.1F, 0.5F, texels);
    const auto normal = [&](int texel) {
        const auto& packed = texels[static_cast<std::size_t>(texel)];
        return vec2(packed[0], packed[1]) / 32767.0F;
    };
    const vec2 expected = glm::normalize(vec2(1.0F, 0.25F));
    for (const int texel : {0, 1, 500, shaders::kProfileWallTexels - 1}) {
        EXPECT_NEAR(normal(texel).x, expected.x, 2e-3F) << texel;
        EXPECT_NEAR(normal(texel).y, expected.y, 2e-3F) << texel;
    }
    EXPECT_EQ(texels[shaders::kProfileWallTexels], (std::array<std::int16_t, 2>{32767, 0}));
    EXPECT_EQ(texels[shaders::kProfileWallTexels + shaders::kProfileEdgeTexels - 1][1], 32767);
    EXPECT_EQ(texels[shaders::kProfileTexels - 1], (std::array<std::int16_t, 2>{0, 32767}));
}

TEST(LatheShape, FadesGroovesFinerThanAPixel) {
    std::vector<float> radii;
    for (int i = 0; i < 2000; ++i)
        radii.push_back(i / 2 % 2 == 0 ? 60.0F : 60.3F);  // 0.4 mm from groove to groove
    const auto steepest = [&](float footprint_mm) {
        NormalTexels texels{};
        lathe_normals(outline_of(lathe_of(radii)), 0.1F, footprint_mm, texels);
        int most = 0;
        for (int i = 8; i < shaders::kProfileWallTexels - 8; ++i)
            most = std::max(most, std::abs(static_cast<int>(texels[static_cast<std::size_t>(i)][1])));
        return static_cast<float>(most) / 32767.0F;
    };
    EXPECT_GT(steepest(0.2F), 0.5F);
    EXPECT_LT(steepest(4.0F), 0.1F);
}

}  // namespace
}  // namespace onggi::render
