#include "engine/render/pixels/photograph_layers.h"

#include <gtest/gtest.h>

#include <span>
#include <vector>

namespace onggi::render {
namespace {

constexpr int kLaidAcross = 320;
constexpr int kLaidDown = 60;

// Red rises smoothly to the right and green downwards; the unlit photograph has half the values, except for a
// column in which compression has made the lit one darker.
constexpr int kBadColumn = 100;
HostPhotograph photograph(bool is_lit, ByteOrder order = ByteOrder::kRedFirst) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < kLaidDown; ++y) {
        for (int x = 0; x < kLaidAcross; ++x) {
            const int scale = is_lit ? 2 : 1;
            const int blue = x == kBadColumn ? (is_lit ? 40 : 41) : 20 * scale;
            for (const int value : {x / 4 * scale, y * scale, blue, 255})
                rgba.push_back(static_cast<std::uint8_t>(value));
        }
    }
    return {kLaidAcross, kLaidDown, rgba, order};
}

class LaidPhotographs : public testing::Test {
  protected:
    void lay(vec4 window, int width, int height) {
        width_ = width;
        with_key_.assign(static_cast<std::size_t>(width * height), 0U);
        without_key_.assign(with_key_.size(), 0x55000000U);
        const PhotographedRoom room{&background_, window, width};
        for (int row = 0; row < height; ++row)
            take(room, row, 0, width, with_key_, without_key_);
    }
    static void take(const PhotographedRoom& room, int row, int first, int end,
                     std::span<std::uint32_t> with_key, std::span<std::uint32_t> without_key) {
        const auto begin = static_cast<std::size_t>(row * room.width_px + first);
        const auto count = static_cast<std::size_t>(end - first);
        lay_photographs(room, row, first, with_key.subspan(begin, count), without_key.subspan(begin, count));
    }
    static int byte(std::uint32_t texel, unsigned at) {
        return static_cast<int>((texel >> (8U * at)) & 255U);
    }
    [[nodiscard]] std::uint32_t lit(int x, int y) const {
        return with_key_.at(static_cast<std::size_t>(y * width_ + x));
    }
    [[nodiscard]] std::uint32_t unlit(int x, int y) const {
        return without_key_.at(static_cast<std::size_t>(y * width_ + x));
    }
    HostBackground background_{photograph(true), photograph(false)};
    int width_ = 0;
    std::vector<std::uint32_t> with_key_;
    std::vector<std::uint32_t> without_key_;
};

TEST_F(LaidPhotographs, AreThemselvesInAPictureOfTheirSize) {
    lay(vec4(1.0F / kLaidAcross, 1.0F / kLaidDown, 0.0F, 0.0F), kLaidAcross, kLaidDown);
    for (int y = 0; y < kLaidDown; ++y) {
        for (int x = 0; x < kLaidAcross; ++x) {
            ASSERT_EQ(byte(lit(x, y), 0), x / 4 * 2) << x << ", " << y;
            ASSERT_EQ(byte(lit(x, y), 1), y * 2) << x << ", " << y;
            ASSERT_EQ(byte(lit(x, y), 2), x == kBadColumn ? 41 : 40) << "the key light takes nothing away";
            ASSERT_EQ(byte(lit(x, y), 3), 255);
            ASSERT_EQ(byte(unlit(x, y), 0), x / 4) << x << ", " << y;
            ASSERT_EQ(byte(unlit(x, y), 1), y) << x << ", " << y;
            ASSERT_EQ(byte(unlit(x, y), 3), 0x55) << "what lies there stays";
        }
    }
}

TEST_F(LaidPhotographs, AreStretchedOverALargerPicture) {
    constexpr int kWidth = kLaidAcross * 3 / 2;
    constexpr int kHeight = kLaidDown * 3 / 2;
    lay(vec4(1.0F / kWidth, 1.0F / kHeight, 0.0F, 0.0F), kWidth, kHeight);
    for (int y = 2; y + 2 < kHeight; ++y) {
        for (int x = 8; x + 8 < kWidth; ++x) {
            const double row = (y + 0.5) / 1.5 - 0.5;
            const double column = (x + 0.5) / 1.5 - 0.5;
            ASSERT_NEAR(byte(lit(x, y), 1), 2.0 * row, 1.01) << x << ", " << y;
            ASSERT_NEAR(byte(lit(x, y), 0), 2.0 * (column / 4.0 - 0.375), 2.0) << x << ", " << y;
        }
    }
}

TEST_F(LaidPhotographs, GoOnDarkerAsTheirMirrorImageBesideTheirBorder) {
    // A picture half as wide again, the photograph in its middle.
    constexpr int kWidth = kLaidAcross * 3 / 2;
    constexpr float kStart = -0.25F;
    lay(vec4(1.0F / kLaidAcross, 1.0F / kLaidDown, kStart, 0.0F), kWidth, kLaidDown);
    constexpr int kLeft = kLaidAcross / 4;
    EXPECT_EQ(byte(lit(kLeft + 40, 30), 0), 20);
    EXPECT_EQ(byte(lit(kLeft + 40, 30), 1), 60);
    EXPECT_NEAR(byte(lit(kLeft - 2, 30), 1), 60, 2) << "at the border it is hardly darker";
    EXPECT_LT(byte(lit(kLeft - 30, 30), 1), 40);
    EXPECT_LT(byte(lit(2, 30), 1), byte(lit(kLeft - 30, 30), 1));
}

// As they are, stretched and beside the photographs; parts begin and end within and across the pieces of a
// row.
TEST_F(LaidPhotographs, AreTheSameInParts) {
    constexpr int kWidth = 700;
    for (const vec4 window : {vec4(1.0F / kLaidAcross, 1.0F / kLaidDown, 0.0F, 0.0F),
                              vec4(0.9F / kWidth, 1.0F / kLaidDown, 0.05F, 0.0F),
                              vec4(1.4F / kWidth, 1.0F / kLaidDown, -0.2F, 0.1F)}) {
        lay(window, kWidth, kLaidDown);
        const PhotographedRoom room{&background_, window, kWidth};
        std::vector<std::uint32_t> with_key(with_key_.size(), 0U);
        std::vector<std::uint32_t> without_key(with_key_.size(), 0x55000000U);
        for (int row = 0; row < kLaidDown; ++row) {
            int first = 0;
            for (const int end : {1, 37, 255, 300, 513, kWidth}) {
                take(room, row, first, end, with_key, without_key);
                first = end;
            }
        }
        EXPECT_EQ(with_key, with_key_);
        EXPECT_EQ(without_key, without_key_);
    }
}

TEST_F(LaidPhotographs, KeepTheirByteOrder) {
    background_ = {photograph(true, ByteOrder::kBlueFirst), photograph(false, ByteOrder::kBlueFirst)};
    lay(vec4(1.0F / kLaidAcross, 1.0F / kLaidDown, 0.0F, 0.0F), kLaidAcross, kLaidDown);
    EXPECT_EQ(byte(lit(200, 10), 2), 100);
    EXPECT_EQ(byte(lit(200, 10), 1), 20);
    EXPECT_EQ(byte(lit(200, 10), 0), 40);
    EXPECT_EQ(byte(unlit(200, 10), 2), 50);
}

}  // namespace
}  // namespace onggi::render
