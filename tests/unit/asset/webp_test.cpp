#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/asset/image.h"
#include "tests/support/webp_frames.h"

namespace onggi::asset {
namespace {

constexpr int kSide = 64;

// A disc on nothing, shaded from left to right.
Image disc() {
    Image image{.width = kSide, .height = kSide, .rgba = {}};
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const bool is_inside = (x - 32) * (x - 32) + (y - 32) * (y - 32) < 24 * 24;
            for (const int value : {120 + x, 160, 130, 255})
                image.rgba.push_back(static_cast<std::uint8_t>(is_inside ? value : 0));
        }
    }
    return image;
}

TEST(Webp, KeepsAlphaToTheBitAndColoursNearly) {
    const Image image = disc();
    const auto bytes = encode_webp(image, 85);
    ASSERT_TRUE(bytes) << bytes.error().message;
    const test::WebpFrames found = test::webp_frames(*bytes);
    ASSERT_EQ(found.images.size(), 1U);
    const Image& back = found.images.front();
    ASSERT_EQ(back.width, kSide);
    int worst = 0;
    for (std::size_t at = 0; at < image.rgba.size(); at += 4) {
        ASSERT_EQ(back.rgba[at + 3], image.rgba[at + 3]) << at;
        for (std::size_t channel = 0; channel < 3 && image.rgba[at + 3] > 0; ++channel)
            worst = std::max(worst, std::abs(back.rgba[at + channel] - image.rgba[at + channel]));
    }
    EXPECT_LE(worst, 24) << "at the edge, where colour is as coarse as two pixels";
    EXPECT_EQ(*bytes, *encode_webp(image, 85));
    EXPECT_LT(bytes->size(), encode_png(image)->size());
}

TEST(Webp, RejectsAnInvalidPicture) {
    EXPECT_FALSE(encode_webp({.width = 0, .height = 4, .rgba = {}}, 80));
    EXPECT_FALSE(encode_webp({.width = 4, .height = 4, .rgba = std::vector<std::uint8_t>(60)}, 80));
    const auto refused = encode_webp(disc(), 101);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("quality of 1 to 100"), std::string::npos);
}

}  // namespace
}  // namespace onggi::asset
