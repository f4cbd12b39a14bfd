#include "engine/render/shapes/detail_texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace onggi::render {
namespace {

TEST(DetailTexture, HasAMeanNearTheMiddle) {
    const auto& texels = detail_texture();
    ASSERT_EQ(texels.size(), std::size_t{4} * kDetailTexels * kDetailTexels);
    for (std::size_t channel = 0; channel < 4; ++channel) {
        double sum = 0.0;
        for (std::size_t i = channel; i < texels.size(); i += 4)
            sum += texels[i];
        EXPECT_NEAR(sum / (kDetailTexels * kDetailTexels), 127.5, 14.0) << channel;
    }
}

TEST(DetailTexture, RepeatsWithoutASeam) {
    const auto& texels = detail_texture();
    const auto at = [&](int x, int y) {
        return static_cast<int>(texels[static_cast<std::size_t>((y * kDetailTexels + x) * 4)]);
    };
    int across_seam = 0;
    int inside = 0;
    for (int y = 0; y < kDetailTexels; ++y) {
        across_seam += std::abs(at(kDetailTexels - 1, y) - at(0, y));
        inside += std::abs(at(255, y) - at(256, y));
    }
    EXPECT_LT(across_seam, 2 * inside);
}

TEST(DetailTexture, RunsLongRoundThePotAndThinUpIt) {
    const auto& texels = detail_texture();
    const auto at = [&](int x, int y) {
        return static_cast<int>(texels[static_cast<std::size_t>((y * kDetailTexels + x) * 4)]);
    };
    long along = 0;
    long up = 0;
    for (int y = 0; y < kDetailTexels - 8; ++y) {
        for (int x = 0; x < kDetailTexels - 8; ++x) {
            along += std::abs(at(x, y) - at(x + 8, y));
            up += std::abs(at(x, y) - at(x, y + 8));
        }
    }
    EXPECT_GT(up, 2 * along);
}

TEST(DetailTexture, KeepsItsMeanAndItsStreaksWithFewerTexels) {
    const auto& texels = detail_texture();
    EXPECT_EQ(coarser_detail(texels, kDetailTexels, kDetailTexels), texels);
    constexpr int kAcross = 256;
    constexpr int kUp = 128;
    const auto coarse = coarser_detail(texels, kAcross, kUp);
    ASSERT_EQ(coarse.size(), std::size_t{4} * kAcross * kUp);
    const auto at = [](const std::vector<std::uint8_t>& from, int across, int x, int y, int channel) {
        return static_cast<int>(from[static_cast<std::size_t>((y * across + x) * 4 + channel)]);
    };
    for (int channel = 0; channel < 4; ++channel) {
        // The sum over a block two across and four up.
        int sum = 0;
        for (int i = 0; i < 8; ++i)
            sum += at(texels, kDetailTexels, 2 * 100 + i % 2, 4 * 70 + i / 2, channel);
        EXPECT_NEAR(at(coarse, kAcross, 100, 70, channel), sum / 8.0, 0.5) << channel;
    }
}

TEST(DetailTexture, HasLevelsThatEachAverageTwiceAsManyAboveOneAnother) {
    constexpr int kAcross = 256;
    constexpr int kUp = 128;
    const auto texels = coarser_detail(detail_texture(), kAcross, kUp);
    const auto levels = streak_levels(texels, kAcross, kUp);
    ASSERT_EQ(levels.size(), kStreakLevels * texels.size());
    EXPECT_TRUE(std::equal(texels.begin(), texels.end(), levels.begin())) << "the first is as it is";
    const auto tone = [&](int level, int x, int y) {
        return static_cast<int>(
            levels[static_cast<std::size_t>(4 * ((level * kUp + y % kUp) * kAcross + x))]);
    };
    // The mean difference between neighbouring pixels of `texels_a_pixel` texels.
    const auto steps = [&](int level, int texels_a_pixel) {
        long sum = 0;
        for (int y = 0; y < kUp; ++y) {
            for (int x = 0; x < kAcross; ++x)
                sum += std::abs(tone(level, x, y) - tone(level, x, y + texels_a_pixel));
        }
        return sum;
    };
    for (int level = 1; level < kStreakLevels; ++level)
        EXPECT_LT(steps(level, 1 << level), steps(0, 1 << level)) << level;
    int sum = 0;
    for (int y = 46; y < 54; ++y)
        sum += tone(0, 70, y);
    EXPECT_NEAR(tone(3, 70, 50), sum / 8.0, 0.6);
}

}  // namespace
}  // namespace onggi::render
