#include "engine/render/pixels/edge_pixels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace onggi::render {
namespace {

class SmoothedPixels : public testing::Test {
  protected:
    // Each pixel has a grey of its own, and lies at the same depth.
    SmoothedPixels() {
        for (std::size_t i = 0; i < pixels_.size(); ++i)
            pixels_[i] = 0xFF000000U | 0x010101U * static_cast<std::uint32_t>(i * 7 % 251);
    }
    void smooth(const vec4& from, const vec4& to, const PixelRect& within = {1, 1, kWidth - 2, kHeight - 2}) {
        const OutlinePiece piece{from, to};
        edges_.smooth({&piece, 1}, within, {.size = {kWidth, kHeight}, .pixels = pixels_, .depth = depth_});
    }
    [[nodiscard]] static std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kWidth + x); }
    [[nodiscard]] float grey(std::size_t i) const { return static_cast<float>(pixels_[i] & 255U); }

    static constexpr int kWidth = 40;
    static constexpr int kHeight = 30;
    EdgePixels edges_;
    std::vector<std::uint32_t> pixels_ = std::vector<std::uint32_t>(std::size_t{kWidth} * kHeight);
    std::vector<float> depth_ = std::vector<float>(std::size_t{kWidth} * kHeight, 0.5F);
};

// E. Persson's rule: the neighbour beyond the line fills the part of the pixel beyond the line.
TEST_F(SmoothedPixels, BlendWithTheNeighbourAcrossALevelLine) {
    const auto before = pixels_;
    smooth(vec4(5.0F, 10.2F, 0.4F, 1.0F), vec4(15.0F, 10.2F, 0.4F, 1.0F));
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const auto x = static_cast<int>(i % kWidth);
        if (i / kWidth != 10 || x < 5 || x >= 15) {
            EXPECT_EQ(pixels_[i], before[i]) << x << ", " << i / kWidth;
            continue;
        }
        const auto grey_of = [&](std::size_t of) { return static_cast<float>(before[of] & 255U); };
        EXPECT_NEAR(grey(i), 0.8F * grey_of(i) + 0.2F * grey_of(i - kWidth), 1.0F) << x;
        EXPECT_EQ(pixels_[i] >> 24U, 255U);
    }
}

TEST_F(SmoothedPixels, FollowALineThatIsSteepOrLeans) {
    const auto before = pixels_;
    // From right to left of the pixels' middles, downwards; the direction of a segment has no effect.
    smooth(vec4(20.75F, 20.0F, 0.4F, 1.0F), vec4(20.0F, 5.0F, 0.4F, 1.0F));
    for (int y = 5; y < 20; ++y) {
        const float line = 20.0F + 0.05F * (static_cast<float>(y) + 0.5F - 5.0F);
        const float off = 20.5F - line;
        const std::size_t own = at(20, y);
        const std::size_t beside = off > 0.0F ? own - 1 : own + 1;
        const float fraction = 0.5F - std::abs(off);
        const auto grey_of = [&](std::size_t of) { return static_cast<float>(before[of] & 255U); };
        EXPECT_NEAR(grey(own), (1.0F - fraction) * grey_of(own) + fraction * grey_of(beside), 1.0F) << y;
        EXPECT_EQ(pixels_[own - 1], before[own - 1]);
        EXPECT_EQ(pixels_[own + 1], before[own + 1]);
    }
}

TEST_F(SmoothedPixels, KeepPixelsNearerThanTheLine) {
    const auto before = pixels_;
    depth_[at(8, 10)] = 0.3F;
    // Deeper from left to right: 0.5, that of the picture, in the middle.
    smooth(vec4(5.0F, 10.2F, 0.4F, 1.0F), vec4(15.0F, 10.2F, 0.6F, 1.0F));
    for (int x = 5; x < 15; ++x)
        EXPECT_EQ(pixels_[at(x, 10)] != before[at(x, 10)], x < 10 && x != 8) << x;
}

TEST_F(SmoothedPixels, ReadThePictureAsItWas) {
    const auto before = pixels_;
    const std::array pieces{OutlinePiece{vec4(5.0F, 10.2F, 0.4F, 1.0F), vec4(6.0F, 10.2F, 0.4F, 1.0F)},
                            OutlinePiece{vec4(5.0F, 11.2F, 0.4F, 1.0F), vec4(6.0F, 11.2F, 0.4F, 1.0F)}};
    edges_.smooth(pieces, {1, 1, kWidth - 2, kHeight - 2},
                  {.size = {kWidth, kHeight}, .pixels = pixels_, .depth = depth_});
    const auto grey_of = [&](int y) { return static_cast<float>(before[at(5, y)] & 255U); };
    EXPECT_NEAR(grey(at(5, 11)), 0.8F * grey_of(11) + 0.2F * grey_of(10), 1.0F);
}

TEST_F(SmoothedPixels, StayInsideWhereTheyMayGo) {
    const auto before = pixels_;
    smooth(vec4(-30.0F, 10.2F, 0.4F, 1.0F), vec4(90.0F, 10.2F, 0.4F, 1.0F), {10, 5, 8, 9});
    smooth(vec4(12.3F, -70.0F, 0.4F, 1.0F), vec4(12.3F, 99.0F, 0.4F, 1.0F), {10, 5, 8, 9});
    smooth(vec4(0.0F, 2.5F, 0.4F, 1.0F), vec4(39.0F, 2.5F, 0.4F, 1.0F), {10, 5, 8, 9});
    int changed = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (pixels_[at(x, y)] == before[at(x, y)]) continue;
            ++changed;
            EXPECT_TRUE(x >= 10 && x < 18 && y >= 5 && y < 14) << x << ", " << y;
        }
    }
    EXPECT_EQ(changed, 8 + 9 - 1);
    const auto now = pixels_;
    smooth(vec4(5.0F, 5.0F, 0.4F, 1.0F), vec4(5.0F, 5.0F, 0.4F, 1.0F), {});
    smooth(vec4(0.0F, 5.2F, 0.4F, 1.0F), vec4(9.0F, 5.2F, 0.4F, 1.0F), {1, 1, -2, -2});
    EXPECT_EQ(pixels_, now) << "nowhere";
}

}  // namespace
}  // namespace onggi::render
