#include "engine/asset/webp_film.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/webp_frames.h"
#include "tests/unit/asset/moving_square.h"

namespace onggi::asset {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;

Image picture(int index) {
    return moving_square(index, kWidth, kHeight);
}

std::vector<std::byte> film(double quality, int pictures = 6) {
    auto made = WebpFilm::create({.width = kWidth, .height = kHeight, .quality = quality});
    EXPECT_TRUE(made);
    for (int i = 0; i < pictures; ++i)
        EXPECT_TRUE(made->add(picture(i), 80));
    auto file = made->finish();
    EXPECT_TRUE(file);
    return std::move(file).value();
}

TEST(WebpFilm, WithoutLossGivesBackEveryPixel) {
    const test::WebpFrames frames = test::webp_frames(film(100.0));
    ASSERT_EQ(frames.images.size(), 6U);
    for (int i = 0; i < 6; ++i) {
        EXPECT_EQ(frames.images[static_cast<std::size_t>(i)], picture(i)) << i;
        EXPECT_EQ(frames.ends_ms[static_cast<std::size_t>(i)], 80 * (i + 1));
    }
    EXPECT_EQ(frames.plays, 1);
}

// libwebp alone would make a still of it.
TEST(WebpFilm, LastsWhereAllPicturesAreEqual) {
    auto made = WebpFilm::create({.width = kWidth, .height = kHeight, .quality = 100.0});
    ASSERT_TRUE(made);
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(made->add(picture(0), 81));
    const auto file = made->finish();
    ASSERT_TRUE(file) << file.error().message;
    const test::WebpFrames frames = test::webp_frames(*file);
    ASSERT_FALSE(frames.images.empty());
    for (const Image& image : frames.images)
        EXPECT_EQ(image, picture(0));
    EXPECT_EQ(frames.ends_ms.back(), 243);
    EXPECT_EQ(frames.plays, 1);
}

TEST(WebpFilm, WithLossIsSmallerAndLooksTheSame) {
    const auto fine = film(90.0);
    const auto coarse = film(10.0);
    EXPECT_LT(coarse.size(), fine.size());
    const test::WebpFrames frames = test::webp_frames(fine);
    ASSERT_EQ(frames.images.size(), 6U);
    for (int i = 0; i < 6; ++i)
        EXPECT_LT(test::mean_difference(frames.images[static_cast<std::size_t>(i)], picture(i)), 6.0) << i;
}

TEST(WebpFilm, IsTheSameBytesEveryTime) {
    EXPECT_EQ(film(75.0), film(75.0));
}

TEST(WebpFilm, OfOnePictureIsAFilm) {
    EXPECT_EQ(test::webp_frames(film(100.0, 1)).images.size(), 1U);
}

TEST(WebpFilm, RejectsInvalidInput) {
    for (const WebpFilmDesc& desc :
         {WebpFilmDesc{.width = 0}, WebpFilmDesc{.height = kMaxImageSide + 1}, WebpFilmDesc{.quality = -1.0},
          WebpFilmDesc{.quality = 101.0}, WebpFilmDesc{.quality = std::nan("")}}) {
        const auto made = WebpFilm::create(desc);
        ASSERT_FALSE(made);
        EXPECT_EQ(made.error().kind, ErrorKind::kBadInput);
        EXPECT_NE(made.error().message.find("expected"), std::string::npos);
    }
    auto made = WebpFilm::create({.width = kWidth, .height = kHeight});
    ASSERT_TRUE(made);
    EXPECT_FALSE(made->finish());
    Image other = picture(0);
    EXPECT_FALSE(made->add(other, 0));
    other.rgba.pop_back();
    EXPECT_FALSE(made->add(other, 80));
    EXPECT_FALSE(made->add({.width = 1, .height = 1, .rgba = {0, 0, 0, 255}}, 80));
}

}  // namespace
}  // namespace onggi::asset
