// tests/golden/backends_agree_test.cpp compares with the shader; here, the layout of a section drawing.
#include "engine/render/pixels/section_pixels.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace onggi::render {
namespace {

constexpr int kSectionWidth = 120;
constexpr int kSectionHeight = 90;
constexpr float kSectionAwayMm = 500.0F;

// A wall that is cut open, a millimetre to ten pixels: x from 0 to 12 mm from the axis, y from 0 to 9 mm up,
// its inner face on the left.
class SectionPixels : public testing::Test {
  protected:
    void draw(float load_below, float load_above, bool shows_load, float depth = 0.5F) {
        const auto corner = [&](float x_mm, float y_mm, float load, float through) {
            constexpr float kNear = 1.0F / kSectionAwayMm;
            return SectionCorner{
                .at_px = {10.0F * x_mm, static_cast<float>(kSectionHeight) - 10.0F * y_mm},
                .away_mm = kSectionAwayMm,
                .depth = depth,
                .values = {x_mm * kNear, y_mm * kNear, load * kNear, through * kNear, kNear}};
        };
        const SectionCorner low_left = corner(0.0F, 0.0F, load_below, 1.0F);
        const SectionCorner low_right = corner(12.0F, 0.0F, load_below, 0.0F);
        const SectionCorner high_left = corner(0.0F, 9.0F, load_above, 1.0F);
        const SectionCorner high_right = corner(12.0F, 9.0F, load_above, 0.0F);
        // One goes clockwise and the other does not: a cut is seen from either side.
        const std::array corners{low_left, low_right, high_left, low_right, high_left, high_right};
        draw_section(corners, {.colour = vec3(0.3F), .shows_load = shows_load},
                     {.size = {kSectionWidth, kSectionHeight}, .pixels = pixels_, .depth = depth_});
    }
    [[nodiscard]] int channel(float x_mm, float y_mm, unsigned shift) const {
        const auto x = static_cast<std::size_t>(10.0F * x_mm);
        const auto y = static_cast<std::size_t>(kSectionHeight) - 1 - static_cast<std::size_t>(10.0F * y_mm);
        return static_cast<int>(pixels_[y * kSectionWidth + x] >> shift & 255U);
    }
    [[nodiscard]] int red(float x_mm, float y_mm) const { return channel(x_mm, y_mm, 0); }

    std::vector<std::uint32_t> pixels_ =
        std::vector<std::uint32_t>(std::size_t{kSectionWidth} * kSectionHeight, 0);
    std::vector<float> depth_ = std::vector<float>(std::size_t{kSectionWidth} * kSectionHeight, 1.0F);
};

TEST_F(SectionPixels, AreHatchedAtFortyFiveDegreesEveryThreeMillimetres) {
    draw(0.0F, 0.0F, false);
    // A line is where x and y together are a whole number of hatches and a half.
    const int line = red(3.0F, 4.5F);
    const int between = red(4.5F, 4.5F);
    EXPECT_LT(line, between - 10);
    EXPECT_NEAR(red(4.0F, 3.5F), line, 2) << "along the line";
    EXPECT_NEAR(red(6.0F, 4.5F), line, 2) << "the next one";
    EXPECT_NEAR(red(5.5F, 3.5F), between, 2);
    EXPECT_EQ(channel(4.5F, 4.5F, 8), between) << "as grey as the clay";
}

TEST_F(SectionPixels, HaveALineWhereTheWallEnds) {
    draw(0.0F, 0.0F, false);
    for (const float end_mm : {0.0F, 11.95F})
        EXPECT_LT(red(end_mm, 4.5F), red(6.0F, 4.5F) - 15) << end_mm;
    EXPECT_LT(red(6.0F, 0.0F), red(6.0F, 4.5F) - 15) << "and a mark of the scale every ten millimetres";
}

TEST_F(SectionPixels, AreHiddenByNearerSurfaces) {
    std::fill(depth_.begin(), depth_.begin() + 45 * kSectionWidth, 0.25F);
    draw(0.0F, 0.0F, false);
    EXPECT_EQ(pixels_[std::size_t{44} * kSectionWidth + 60], 0U);
    EXPECT_NE(pixels_[std::size_t{45} * kSectionWidth + 60], 0U);
    EXPECT_EQ(depth_[std::size_t{45} * kSectionWidth + 60], 0.5F);
}

TEST_F(SectionPixels, ReddenTowardsWhereTheClayGivesWayIfAsked) {
    draw(0.0F, 1.0F, false);
    EXPECT_NEAR(channel(4.5F, 8.5F, 16), red(4.5F, 8.5F), 1);
    draw(0.0F, 1.0F, true);
    EXPECT_NEAR(channel(4.5F, 4.5F, 16), red(4.5F, 4.5F), 1) << "six tenths are no warning";
    EXPECT_GT(red(4.6F, 8.7F), channel(4.6F, 8.7F, 16) + 60) << "where the hatch leaves it";
    // A pale line where the warning begins: higher than the clay is.
    EXPECT_GT(red(4.5F, 5.4F), red(4.5F, 4.5F) + 40);
}

TEST_F(SectionPixels, AreSkippedBehindTheEye) {
    shaders::FrameData frame{};
    frame.view_projection = mat4(0.0F);
    frame.view_projection[3][3] = -1.0F;
    std::vector<SectionCorner> corners;
    place_section(std::vector<shaders::VertexData>(3), frame, corners);
    ASSERT_EQ(corners.size(), 3U);
    draw_section(corners, {}, {.size = {kSectionWidth, kSectionHeight}, .pixels = pixels_, .depth = depth_});
    for (const std::uint32_t pixel : pixels_)
        ASSERT_EQ(pixel, 0U);
}

}  // namespace
}  // namespace onggi::render
