// The flash meter must detect flashes.
#include "tests/support/flash_meter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace onggi::support {
namespace {

TEST(RelativeLuminance, IsTheGuidelines) {
    EXPECT_NEAR(relative_luminance(std::array<std::uint8_t, 3>{255, 255, 255}), 1.0, 1e-12);
    EXPECT_EQ(relative_luminance(std::array<std::uint8_t, 3>{0, 0, 0}), 0.0);
    EXPECT_NEAR(relative_luminance(std::array<std::uint8_t, 3>{119, 119, 119}), 0.1845, 1e-3);
}

// Changes within a second of a brightness that goes up and down between two values.
int changes_of(double low, double high, double flashes_a_second) {
    FlashCount count;
    for (int look = 0; look < 300; ++look) {
        const double now_s = look / 60.0;
        const double wave = 0.5 + 0.5 * std::sin(6.283185307 * flashes_a_second * now_s);
        count.see(now_s, low + (high - low) * wave);
    }
    return count.most_changes();
}

TEST(FlashCount, CountsOpposingChangesOfATenth) {
    EXPECT_LE(changes_of(0.2, 0.5, 0.9), 3);
    EXPECT_GE(changes_of(0.2, 0.5, 0.9), 2);
    EXPECT_LE(changes_of(0.2, 0.5, 2.8), FlashMeter::kMostChanges) << "just allowed";
    EXPECT_GT(changes_of(0.2, 0.5, 4.0), FlashMeter::kMostChanges);
    EXPECT_GE(changes_of(0.2, 0.5, 8.0), 15);
    EXPECT_EQ(changes_of(0.2, 0.29, 5.0), 0) << "less than a tenth";
    EXPECT_EQ(changes_of(0.82, 1.0, 5.0), 0) << "bright and brighter";
}

TEST(FlashCount, TakesASlopeForOneChange) {
    FlashCount count;
    for (int look = 0; look <= 60; ++look)
        count.see(look / 60.0, 0.9 * look / 60.0);
    EXPECT_EQ(count.most_changes(), 1);
}

TEST(FlashMeter, FindsATileThatFlashesInAPictureThatDoesNot) {
    FlashMeter calm;
    FlashMeter harmful;
    asset::Image picture{.width = 64, .height = 48, .rgba = {}};
    for (int look = 0; look < 120; ++look) {
        picture.rgba.assign(std::size_t{64} * 48 * 4, 100);
        calm.see(look / 60.0, picture);
        if (look / 6 % 2 == 0)
            for (std::size_t y = 8; y < 16; ++y)
                for (std::size_t x = 8; x < 16; ++x)
                    for (std::size_t i = 0; i < 3; ++i)
                        picture.rgba[4 * (y * 64 + x) + i] = 200;
        harmful.see(look / 60.0, picture);
    }
    EXPECT_TRUE(calm.is_calm()) << calm.in_words();
    EXPECT_FALSE(harmful.is_calm()) << harmful.in_words();
    EXPECT_LT(harmful.largest_step(), 0.05);
}

}  // namespace
}  // namespace onggi::support
