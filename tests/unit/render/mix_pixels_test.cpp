#include "engine/render/pixels/mix_pixels.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace onggi::render {
namespace {

constexpr int kMixedAcross = 37;
constexpr int kMixedDown = 5;

std::vector<std::uint32_t> random_picture(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> pixels(std::size_t{kMixedAcross} * kMixedDown);
    for (std::uint32_t& pixel : pixels)
        pixel = static_cast<std::uint32_t>(random());
    return pixels;
}

TEST(MixedPixels, AreEachByteOfBothByTheirShare) {
    const std::vector<std::uint32_t> from = random_picture(1);
    const std::vector<std::uint32_t> to = random_picture(2);
    constexpr PixelRect kInside{.x = 3, .y = 1, .width = 33, .height = 3};
    for (const float fraction : {0.0F, 1.0F / 256.0F, 0.25F, 0.5F, 0.9F, 1.0F}) {
        std::vector<std::uint32_t> into(from.size(), 0xDEADBEEFU);
        mix_pixels(from, to, fraction, kInside, kMixedAcross, into);
        for (int y = 0; y < kMixedDown; ++y) {
            for (int x = 0; x < kMixedAcross; ++x) {
                const auto at = static_cast<std::size_t>(y * kMixedAcross + x);
                const bool is_inside = x >= 3 && x < 36 && y >= 1 && y < 4;
                if (!is_inside) {
                    ASSERT_EQ(into[at], 0xDEADBEEFU) << x << ", " << y;
                    continue;
                }
                for (unsigned shift = 0; shift < 32; shift += 8) {
                    const auto byte = [&](std::uint32_t pixel) {
                        return static_cast<float>(pixel >> shift & 255U);
                    };
                    ASSERT_NEAR(byte(into[at]), byte(from[at]) * (1.0F - fraction) + byte(to[at]) * fraction,
                                1.01)
                        << x << ", " << y << " at " << fraction;
                }
            }
        }
    }
}

TEST(MixedPixels, AreOneOrTheOtherAtTheEnds) {
    const std::vector<std::uint32_t> from = random_picture(3);
    const std::vector<std::uint32_t> to = random_picture(4);
    std::vector<std::uint32_t> into(from.size());
    constexpr PixelRect kAll{.x = 0, .y = 0, .width = kMixedAcross, .height = kMixedDown};
    mix_pixels(from, to, 0.0F, kAll, kMixedAcross, into);
    EXPECT_EQ(into, from);
    mix_pixels(from, to, 1.0F, kAll, kMixedAcross, into);
    EXPECT_EQ(into, to);
    mix_pixels(from, from, 0.3F, kAll, kMixedAcross, into);
    EXPECT_EQ(into, from) << "of two alike";
}

}  // namespace
}  // namespace onggi::render
