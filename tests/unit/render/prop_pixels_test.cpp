#include "engine/render/pixels/prop_pixels.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/unit/render/triangle_pixels.h"

namespace onggi::render {
namespace {

class PropPixels : public TrianglePixels {
  protected:
    void draw(std::span<const PropCorner> corners, std::span<const std::uint32_t> indices) {
        draw_triangles(corners, indices, {.size = {kWidth, kHeight}, .pixels = pixels_, .depth = depth_});
    }
    static PropCorner corner(float x, float y, float depth = 0.5F, std::array<float, 3> colour = {}) {
        return {.at_px = {x, y}, .away_mm = 100.0F, .depth = depth, .values = colour};
    }
    // Two triangles over all of the picture and beyond it.
    static std::vector<PropCorner> sheet(float depth, float grey) {
        const std::array<float, 3> colour{grey, grey, grey};
        return {corner(-50.0F, -50.0F, depth, colour), corner(-50.0F, 200.0F, depth, colour),
                corner(200.0F, -50.0F, depth, colour), corner(200.0F, 200.0F, depth, colour)};
    }

    static constexpr std::array<std::uint32_t, 6> kSheet{0, 1, 2, 2, 1, 3};
};

TEST_F(PropPixels, AreThoseWhoseMiddleATriangleHolds) {
    const int covered = expect_those_inside({}, [&](const std::array<vec2, 3>& at) {
        const std::array corners{corner(at[0].x, at[0].y), corner(at[1].x, at[1].y),
                                 corner(at[2].x, at[2].y)};
        draw(corners, std::array<std::uint32_t, 3>{0, 1, 2});
    });
    EXPECT_GT(covered, 50000);
}

TEST_F(PropPixels, DrawEachPixelBetweenTwoTrianglesOnce) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> off(-0.2F, 0.2F);
    constexpr int kAcross = 30;
    constexpr std::uint32_t kInRow = kAcross + 1;
    std::vector<PropCorner> corners;
    for (int row = 0; row <= kAcross; ++row) {
        for (int column = 0; column <= kAcross; ++column) {
            const float down = (static_cast<float>(row) + off(random)) * 2.0F - 2.0F;
            corners.push_back(corner((static_cast<float>(column) + off(random)) * 3.0F - 2.0F, down));
        }
    }
    std::vector<std::uint32_t> indices;
    for (std::uint32_t row = 0; row < kAcross; ++row) {
        for (std::uint32_t column = 0; column < kAcross; ++column) {
            const std::uint32_t here = row * kInRow + column;
            for (const std::uint32_t index :
                 {here, here + kInRow, here + 1, here + 1, here + kInRow, here + kInRow + 1})
                indices.push_back(index);
        }
    }
    // Each triangle is slightly nearer than the previous one, so a pixel drawn by both would show.
    std::vector<int> times(pixels_.size(), 0);
    for (std::size_t first = 0; first < indices.size(); first += 3) {
        clear();
        draw(corners, std::span(indices).subspan(first, 3));
        for (std::size_t i = 0; i < pixels_.size(); ++i)
            times[i] += pixels_[i] != kUntouched ? 1 : 0;
    }
    for (std::size_t i = 0; i < times.size(); ++i)
        ASSERT_EQ(times[i], 1) << i % kWidth << ", " << i / kWidth;
}

TEST_F(PropPixels, SpreadColoursEvenlyBetweenTheCorners) {
    const std::array corners{corner(0.0F, 0.0F, 0.5F, {0.0F, 0.0F, 200.0F}),
                             corner(0.0F, 40.0F, 0.5F, {0.0F, 160.0F, 200.0F}),
                             corner(60.0F, 0.0F, 0.5F, {240.0F, 0.0F, 200.0F})};
    draw(corners, std::array<std::uint32_t, 3>{0, 1, 2});
    for (const auto& [x, y] : {std::pair{0, 0}, {10, 3}, {25, 20}, {5, 33}, {50, 2}}) {
        const std::uint32_t pixel = at(x, y);
        EXPECT_NEAR(pixel & 255U, 4.0F * (static_cast<float>(x) + 0.5F), 0.51F) << x << ", " << y;
        EXPECT_NEAR(pixel >> 8U & 255U, 4.0F * (static_cast<float>(y) + 0.5F), 0.51F) << x << ", " << y;
        EXPECT_EQ(pixel >> 16U & 255U, 200U);
        EXPECT_EQ(pixel >> 24U, 255U);
    }
}

TEST_F(PropPixels, AreTheSameInBands) {
    std::vector<PropCorner> corners = sheet(0.5F, 50.0F);
    for (PropCorner& own : corners) {
        own.values[0] += 0.7F * own.at_px.x;
        own.values[1] += 0.9F * own.at_px.y;
        own.depth += 0.0011F * own.at_px.x + 0.0007F * own.at_px.y;
    }
    // Over the right border, with slanting edges inside.
    corners[0].at_px = {20.3F, 0.6F};
    corners[1].at_px = {2.1F, 42.2F};
    corners[2].at_px = {150.0F, 20.4F};
    expect_the_same_in_bands(
        [&](const PictureCanvas& canvas) { draw_triangles(corners, std::span(kSheet).first(3), canvas); });
}

TEST_F(PropPixels, ShowTheNearestSurface) {
    draw(sheet(0.6F, 60.0F), kSheet);
    draw(sheet(0.4F, 40.0F), kSheet);
    draw(sheet(0.5F, 50.0F), kSheet);
    EXPECT_EQ(at(30, 20) & 255U, 40U);
    EXPECT_EQ(depth_[0], 0.4F);
    draw(sheet(0.4F, 80.0F), kSheet);
    EXPECT_EQ(at(30, 20) & 255U, 40U) << "the first of two at one place";
    depth_[100] = 0.1F;
    draw(sheet(0.2F, 20.0F), kSheet);
    EXPECT_EQ(pixels_[99] & 255U, 20U);
    EXPECT_EQ(pixels_[100] & 255U, 40U) << "the existing pixel is nearer";
    EXPECT_EQ(depth_[100], 0.1F);
    EXPECT_EQ(pixels_.back() & 255U, 20U) << "to the last pixel";
}

TEST_F(PropPixels, SkipTrianglesBehindTheEyeOrWithoutArea) {
    std::vector<PropCorner> corners = sheet(0.5F, 50.0F);
    corners[1].away_mm = 0.0F;
    draw(corners, kSheet);
    corners = sheet(0.5F, 50.0F);
    corners[1].at_px = corners[2].at_px = corners[0].at_px;
    draw(corners, std::array<std::uint32_t, 3>{0, 1, 2});
    EXPECT_EQ(std::count(pixels_.begin(), pixels_.end(), kUntouched),
              static_cast<std::ptrdiff_t>(pixels_.size()));
}

TEST_F(PropPixels, AreUnchangedOnATinyCanvas) {
    std::array<std::uint32_t, 4> pixels{};
    std::array<float, 4> depth{1.0F, 1.0F, 1.0F, 1.0F};
    draw_triangles(sheet(0.5F, 50.0F), kSheet, {.size = {2, 2}, .pixels = pixels, .depth = depth});
    EXPECT_EQ(pixels[0], 0U);
}

TEST_F(PropPixels, LieInTheTilesThatAreWanted) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-30.0F, 90.0F);
    std::vector<PropCorner> corners;
    for (int i = 0; i < 60; ++i) {
        const float down = place(random);
        corners.push_back(corner(place(random), down));
    }
    const TileGrid grid{kWidth, kHeight};
    for (std::uint32_t first = 0; first < 57; ++first) {
        clear();
        const std::array<std::uint32_t, 3> indices{first, first + 1, first + 2};
        std::vector<std::uint8_t> wanted(grid.count(), 0);
        want_triangles(corners, indices, grid, wanted);
        draw(corners, indices);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const int tile = y / kTileHeightPx * grid.across() + x / kTileWidthPx;
                if (at(x, y) != kUntouched) {
                    ASSERT_EQ(wanted[static_cast<std::size_t>(tile)], 1) << x << ", " << y;
                }
            }
        }
    }
}

}  // namespace
}  // namespace onggi::render
