#include "engine/render/pixels/shade_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "engine/render/pixels/shade_pixels.h"

namespace onggi::render {
namespace {

// Neither side a whole number of tiles.
constexpr TileGrid kShadedGrid{.width_px = 5 * kTileWidthPx + 7, .height_px = 6 * kTileHeightPx + 3};

std::size_t pixel(int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(kShadedGrid.width_px) +
           static_cast<std::size_t>(x);
}

// How often each pixel of the picture lies in a rectangle.
std::vector<int> counted(const std::vector<PixelRect>& rects) {
    std::vector<int> times(pixel(0, kShadedGrid.height_px), 0);
    for (const PixelRect& rect : rects) {
        for (int y = rect.y; y < rect.y + rect.height; ++y) {
            for (int x = rect.x; x < rect.x + rect.width; ++x)
                ++times.at(pixel(x, y));
        }
    }
    return times;
}

TEST(Tiles, BecomeRectanglesThatHoldEachWantedPixelOnce) {
    std::mt19937 random(3);
    for (int round = 0; round < 200; ++round) {
        std::vector<std::uint8_t> wanted(kShadedGrid.count());
        for (std::uint8_t& tile : wanted)
            tile = random() % 3 == 0 ? 0 : 1;
        std::vector<PixelRect> rects;
        rects_of_tiles(kShadedGrid, wanted, rects);
        const std::vector<int> times = counted(rects);
        for (int y = 0; y < kShadedGrid.height_px; ++y) {
            for (int x = 0; x < kShadedGrid.width_px; ++x) {
                const int tile = y / kTileHeightPx * kShadedGrid.across() + x / kTileWidthPx;
                ASSERT_EQ(times[pixel(x, y)], wanted[static_cast<std::size_t>(tile)]) << x << ", " << y;
            }
        }
    }
}

TEST(Tiles, OfAWholePictureAreOneRectangle) {
    std::vector<PixelRect> rects;
    rects_of_tiles(kShadedGrid, std::vector<std::uint8_t>(kShadedGrid.count(), 1), rects);
    ASSERT_EQ(rects.size(), 1U);
    EXPECT_EQ(rects[0], (PixelRect{0, 0, kShadedGrid.width_px, kShadedGrid.height_px}));
}

TEST(Tiles, AreWantedWhereARectangleTouchesThemInsideThePicture) {
    std::vector<std::uint8_t> wanted(kShadedGrid.count(), 0);
    want_tiles(kShadedGrid, {kTileWidthPx - 1, -50, 2, 51}, wanted);
    EXPECT_EQ(wanted[0], 1);
    EXPECT_EQ(wanted[1], 1);
    EXPECT_EQ(std::count(wanted.begin(), wanted.end(), 1), 2);
    want_tiles(kShadedGrid, {-1000, -1000, 5000, 5000}, wanted);
    EXPECT_EQ(static_cast<std::size_t>(std::count(wanted.begin(), wanted.end(), 1)), kShadedGrid.count());
    std::fill(wanted.begin(), wanted.end(), 0);
    for (const PixelRect& outside : {PixelRect{-10, 0, 10, 5}, PixelRect{kShadedGrid.width_px + 40, 0, 10, 5},
                                     PixelRect{0, -8, 5, 8}, PixelRect{0, 0, 0, 5}}) {
        want_tiles(kShadedGrid, outside, wanted);
    }
    EXPECT_EQ(std::count(wanted.begin(), wanted.end(), 1), 0);
}

// Every pixel maps into the mask, as for a plane seen obliquely.
class ShadedTiles : public testing::Test {
  protected:
    ShadedTiles() {
        for (int y = 0; y < kShadedGrid.height_px; ++y) {
            for (int x = 0; x < kShadedGrid.width_px; ++x) {
                const auto u = static_cast<std::uint32_t>(x * 300 + y * 50);
                const auto v = static_cast<std::uint32_t>(y * 900);
                places_.push_back(
                    mask_place((u >> 8U) | ((u & 255U) << 8U) | ((v >> 8U) << 16U) | ((v & 255U) << 24U)));
            }
        }
        before_->fill(kUnshaded);
        now_->fill(kUnshaded);
        tiles_.learn(kShadedGrid, places_);
        take();
    }
    void take() { tiles_.take(++number_, rects_); }

    std::uint64_t number_ = 0;
    std::vector<std::uint32_t> places_;
    std::unique_ptr<ShadowMask> before_ = std::make_unique<ShadowMask>();
    std::unique_ptr<ShadowMask> now_ = std::make_unique<ShadowMask>();
    ShadeTiles tiles_;
    std::vector<PixelRect> rects_;
};

TEST_F(ShadedTiles, AreShadedOnceAndThenWhereTheMaskChanges) {
    ASSERT_EQ(rects_.size(), 1U);
    tiles_.note_mask(*before_, *now_);
    take();
    EXPECT_TRUE(rects_.empty());

    std::mt19937 random(7);
    for (int round = 0; round < 50; ++round) {
        *before_ = *now_;
        for (int change = 0; change < 3; ++change)
            (*now_)[random() % now_->size()] = static_cast<std::uint32_t>(random()) & kUnshaded;
        tiles_.note_mask(*before_, *now_);
        take();
        const std::vector<int> times = counted(rects_);
        for (std::size_t at = 0; at < places_.size(); ++at) {
            const std::size_t texel = places_[at] >> 16U;
            const auto differs = [&](std::size_t t) { return (*before_)[t] != (*now_)[t]; };
            const bool reads_a_change = differs(texel) || differs(texel + 1) ||
                                        differs(texel + shaders::kMaskTexels) ||
                                        differs(texel + shaders::kMaskTexels + 1);
            if (reads_a_change) {
                ASSERT_EQ(times[at], 1);
            }
        }
        // And few others: a tile reads a few texels.
        EXPECT_LT(std::count(times.begin(), times.end(), 1), std::ptrdiff_t(times.size() / 2));
    }
}

TEST_F(ShadedTiles, ReadTheFourTexelsAboutTheirPlaceAndNoOthers) {
    constexpr TileGrid kOne{kTileWidthPx, kTileHeightPx};
    constexpr std::uint32_t kAcross = shaders::kMaskTexels;
    for (std::uint32_t texel = 0; texel < kAcross * (kAcross - 1); texel += 31) {
        if (texel % kAcross == kAcross - 1) continue;  // no pixel maps there
        const std::vector<std::uint32_t> places(std::size_t{kTileWidthPx} * kTileHeightPx, texel << 16U);
        const auto is_shaded = [&](std::uint32_t changed) {
            tiles_.learn(kOne, places);
            take();
            *now_ = *before_;
            (*now_)[changed] = 0;
            tiles_.note_mask(*before_, *now_);
            take();
            return !rects_.empty();
        };
        for (const std::uint32_t read : {texel, texel + 1, texel + kAcross, texel + kAcross + 1})
            ASSERT_TRUE(is_shaded(read)) << texel;
        ASSERT_FALSE(texel >= kAcross && is_shaded(texel - kAcross)) << texel;
        ASSERT_FALSE(texel % kAcross > 0 && is_shaded(texel - 1)) << texel;
    }
}

TEST_F(ShadedTiles, WaitAFrameForALittleOtherLightRowByRow) {
    const std::vector<std::uint64_t> before(tiles_.numbers().begin(), tiles_.numbers().end());
    tiles_.note_light(LightChange::kLittle);
    take();
    const std::vector<int> first = counted(rects_);
    take();
    const std::vector<int> second = counted(rects_);
    for (std::size_t at = 0; at < first.size(); ++at)
        ASSERT_EQ(first[at] + second[at], 1) << at;
    EXPECT_EQ(first[pixel(0, 0)], first[pixel(kShadedGrid.width_px - 1, kTileHeightPx - 1)]);
    EXPECT_NE(first[pixel(0, 0)], first[pixel(0, kTileHeightPx)]);
    for (std::size_t tile = 0; tile < before.size(); ++tile)
        EXPECT_NE(tiles_.numbers()[tile], before[tile]) << tile;
    take();
    EXPECT_TRUE(rects_.empty());
    tiles_.note_light(LightChange::kMuch);
    take();
    EXPECT_EQ(rects_.size(), 1U) << "all at once";
}

TEST(ShadowMaskTexels, StayWhereTheyDifferByAStepAndNeverDriftFurther) {
    auto shown = std::make_unique<ShadowMask>();
    shown->fill(100U | (100U << 16U));
    for (std::uint32_t step = 1; step <= 20; ++step) {
        auto now = std::make_unique<ShadowMask>();
        now->fill((100U + step) | ((100U - step) << 16U));
        const ShadowMask wanted = *now;
        keep_what_is_alike(*shown, *now);
        EXPECT_LE((wanted[0] & 0xFFFFU) - ((*now)[0] & 0xFFFFU), 1U);
        EXPECT_LE(((*now)[0] >> 16U) - (wanted[0] >> 16U), 1U);
        if (step == 1) {
            EXPECT_EQ(*now, *shown);
        }
        shown.swap(now);
    }
}

}  // namespace
}  // namespace onggi::render
