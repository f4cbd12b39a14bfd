#include "engine/render/pixels/shade_tiles.h"

#include <gtest/gtest.h>

#include <memory>

namespace onggi::render {
namespace {

constexpr int kShadedWidth = 40;
constexpr int kShadedHeight = 24;

// Three places far from each other in the mask.
constexpr std::uint32_t place_of(std::uint32_t u, std::uint32_t v) {
    return (v * shaders::kMaskTexels + u) << 16U;
}
constexpr std::uint32_t kHead = place_of(30, 30);
constexpr std::uint32_t kBench = place_of(60, 50);
constexpr std::uint32_t kGap = place_of(45, 80);

class ShadeEdgesOf : public testing::Test {
  protected:
    ShadeEdgesOf() { mask_->fill(kUnshaded); }
    void put_in_shade(std::uint32_t place) { (*mask_)[place >> 16U] = kUnshaded & 0xFFFF0000U; }
    std::uint32_t& place(int x, int y) { return places_[static_cast<std::size_t>(y * kShadedWidth + x)]; }
    std::uint32_t& pixel(int x, int y) { return picture_[static_cast<std::size_t>(y * kShadedWidth + x)]; }
    void smooth(const PixelRect& rect = {0, 0, kShadedWidth, kShadedHeight}) {
        edges_.find(kShadedWidth, places_);
        edges_.smooth(*mask_, std::span(&rect, 1), picture_);
    }
    static std::uint32_t grey(std::uint32_t level) { return 0xFF000000U | level * 0x010101U; }

    std::unique_ptr<ShadowMask> mask_ = std::make_unique<ShadowMask>();
    std::vector<std::uint32_t> places_ =
        std::vector<std::uint32_t>(std::size_t{kShadedWidth} * kShadedHeight, kBench);
    std::vector<std::uint32_t> picture_ =
        std::vector<std::uint32_t>(std::size_t{kShadedWidth} * kShadedHeight, grey(210));
    ShadeEdges edges_;
};

TEST_F(ShadeEdgesOf, TwoThingsMixThemWhereOneIsInShade) {
    // The wheel head has a vertical silhouette; the pixels beside it mix head and bench, as in a photograph.
    for (int y = 0; y < kShadedHeight; ++y) {
        for (int x = 0; x < 20; ++x) {
            place(x, y) = kHead;
            pixel(x, y) = grey(90);
        }
        pixel(19, y) = grey(10);
        pixel(20, y) = grey(250);
    }
    const std::vector<std::uint32_t> photograph = picture_;
    smooth();
    EXPECT_EQ(picture_, photograph) << "in the light it is as it was taken";
    put_in_shade(kHead);
    smooth({0, 8, kShadedWidth, 8});
    for (int y = 8; y < 16; ++y) {
        EXPECT_EQ(pixel(18, y), grey(90));
        EXPECT_EQ(pixel(19, y), grey(130));
        EXPECT_EQ(pixel(20, y), grey(170));
        EXPECT_EQ(pixel(21, y), grey(210));
    }
    EXPECT_EQ(pixel(19, 7), grey(10)) << "not shaded this time";
    EXPECT_EQ(pixel(19, 16), grey(10));
}

TEST_F(ShadeEdgesOf, AGapHideItsDarkBetweenTwoThingsInTheLight) {
    for (int x = 0; x < kShadedWidth; ++x) {
        for (int y = 0; y < 12; ++y) {
            place(x, y) = kHead;
            pixel(x, y) = grey(120);
        }
        place(x, 12) = kGap;
        pixel(x, 12) = grey(5);
    }
    put_in_shade(kGap);
    smooth();
    for (int x = 4; x < kShadedWidth - 4; ++x) {
        for (int y = 8; y < 16; ++y)
            EXPECT_GE(pixel(x, y) & 0xFFU, 120U) << x << ", " << y;
    }
}

TEST_F(ShadeEdgesOf, AStairGoEvenlyFromStepToStep) {
    for (int x = 0; x < kShadedWidth; ++x) {
        for (int y = 0; y < 8 + x / 5; ++y) {
            place(x, y) = kHead;
            pixel(x, y) = grey(90);
        }
    }
    put_in_shade(kHead);
    smooth();
    for (int x = 4; x < kShadedWidth - 4; ++x) {
        for (int y = 4; y < 20; ++y) {
            const auto level = static_cast<int>(pixel(x, y) & 0xFFU);
            const auto below = static_cast<int>(pixel(x, y + 1) & 0xFFU);
            EXPECT_LE(level, below) << x << ", " << y;
            EXPECT_LE(below - level, 81) << x << ", " << y;
        }
    }
}

TEST_F(ShadeEdgesOf, NoPlacesAreEmpty) {
    put_in_shade(kBench);
    const std::vector<std::uint32_t> photograph = picture_;
    smooth();
    EXPECT_EQ(picture_, photograph) << "one surface";
    // Pixels that no shadow reaches map to the mask's border.
    std::fill(places_.begin(), places_.end(), place_of(95, 40));
    for (int y = 0; y < kShadedHeight; ++y)
        place(20, y) = place_of(0, 40);
    mask_->fill(kUnshaded);
    smooth();
    EXPECT_EQ(picture_, photograph);
    ShadeEdges small;
    small.find(3, std::span(places_).first(9));
    small.smooth(*mask_, std::array{PixelRect{0, 0, 3, 3}}, std::span(picture_).first(9));
    small.find(0, {});
    small.smooth(*mask_, {}, {});
    EXPECT_EQ(picture_, photograph);
}

}  // namespace
}  // namespace onggi::render
