#include "engine/render/pixels/host_photograph.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace onggi::render {
namespace {

// Red by column, green by row, blue 200.
std::vector<std::uint8_t> ramp(int width, int height) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int value : {10 * x, 20 * y, 200, 255})
                rgba.push_back(static_cast<std::uint8_t>(value));
        }
    }
    return rgba;
}

TEST(HostPhotograph, HasItsBytesInThePicturesOrder) {
    const HostPhotograph red_first(3, 2, ramp(3, 2), ByteOrder::kRedFirst);
    EXPECT_EQ(red_first.first()[4], 0xFFC8140AU);
    const HostPhotograph blue_first(3, 2, ramp(3, 2), ByteOrder::kBlueFirst);
    EXPECT_EQ(blue_first.first()[4], 0xFF0A14C8U);
}

TEST(HostPhotograph, RepeatsItsFirstAndLastRowBesideIt) {
    const HostPhotograph photograph(3, 2, ramp(3, 2), ByteOrder::kRedFirst);
    for (std::ptrdiff_t x = 0; x < 3; ++x) {
        EXPECT_EQ(photograph.first()[x - 3], photograph.first()[x]);
        EXPECT_EQ(photograph.first()[6 + x], photograph.first()[3 + x]);
    }
    EXPECT_EQ(photograph.first()[-4], photograph.first()[0]);
}

}  // namespace
}  // namespace onggi::render
