#include "engine/asset/mp4_film.h"

#include <gtest/gtest.h>

#include "tests/support/mp4_frames.h"
#include "tests/support/webp_frames.h"
#include "tests/unit/asset/moving_square.h"

namespace onggi::asset {
namespace {

std::vector<std::byte> film(int pictures, int width = 40, int height = 30, int quantiser = 26) {
    auto made = Mp4Film::create({.width = width, .height = height, .picture_ms = 80, .quantiser = quantiser});
    EXPECT_TRUE(made);
    for (int i = 0; i < pictures; ++i) {
        const auto added = made->add(moving_square(i, width, height));
        EXPECT_TRUE(added) << added.error().message;
    }
    auto file = made->finish();
    EXPECT_TRUE(file);
    return std::move(file).value();
}

TEST(Mp4Film, ShowsItsPicturesInTheirOrderAndTime) {
    const test::Mp4Frames frames = test::mp4_frames(film(6));
    ASSERT_EQ(frames.images.size(), 6U);
    for (int i = 0; i < 6; ++i)
        EXPECT_LT(test::mean_difference(frames.images[static_cast<std::size_t>(i)], moving_square(i, 40, 30)),
                  8.0)
            << i;
    EXPECT_EQ(frames.lasts_ms, 480);
    EXPECT_EQ(frames.keys, std::vector<int>{0});
}

TEST(Mp4Film, LeavesOutTheLastColumnAndRowOfAnOddSize) {
    const test::Mp4Frames frames = test::mp4_frames(film(2, 41, 31));
    EXPECT_EQ(frames.images.front().width, 40);
    EXPECT_EQ(frames.images.front().height, 30);
}

TEST(Mp4Film, OfManyPicturesCanBeEnteredInTheMiddle) {
    const test::Mp4Frames frames = test::mp4_frames(film(130));
    EXPECT_EQ(frames.keys, (std::vector<int>{0, 128}));
    EXPECT_EQ(frames.lasts_ms, 10'400);
}

// Coarse pictures of their own would be off by 3 and more.
TEST(Mp4Film, ShowsWhatStandsStillAsFineAsItsKeys) {
    constexpr int kCoarse = 45;
    auto made = Mp4Film::create({.width = 40, .height = 30, .quantiser = kCoarse});
    ASSERT_TRUE(made);
    const Image at_rest = moving_square(200, 40, 30);  // its square is outside
    for (int i = 0; i < 130; ++i)
        ASSERT_TRUE(made->add(at_rest));
    const auto file = made->finish();
    ASSERT_TRUE(file);
    for (const Image& shown : test::mp4_frames(*file).images)
        EXPECT_LT(test::mean_difference(shown, at_rest), 1.5);
}

TEST(Mp4Film, IsTheSameBytesEveryTime) {
    EXPECT_EQ(film(6), film(6));
}

TEST(Mp4Film, PlaysTheSameWithWhatItSaysAboutItself) {
    const std::vector<std::byte> plain = film(6);
    const auto told = picture_about(plain, {.title = {{"en", "Moon jar"}}, .rights = {{"en", "CC BY 4.0"}}});
    ASSERT_TRUE(told) << told.error().message;
    EXPECT_GT(told->size(), plain.size());
    const test::Mp4Frames frames = test::mp4_frames(*told);
    EXPECT_EQ(frames.images, test::mp4_frames(plain).images);
}

TEST(Mp4Film, RejectsInvalidInput) {
    for (const Mp4FilmDesc& desc :
         {Mp4FilmDesc{.width = 1}, Mp4FilmDesc{.width = 15}, Mp4FilmDesc{.height = 14},
          Mp4FilmDesc{.height = -480}, Mp4FilmDesc{.width = kMaxImageSide, .height = kMaxImageSide},
          Mp4FilmDesc{.picture_ms = 0}, Mp4FilmDesc{.picture_ms = 1001}, Mp4FilmDesc{.quantiser = 0},
          Mp4FilmDesc{.quantiser = 52}}) {
        const auto made = Mp4Film::create(desc);
        ASSERT_FALSE(made);
        EXPECT_EQ(made.error().kind, ErrorKind::kBadInput);
        EXPECT_NE(made.error().message.find("expected"), std::string::npos);
    }
    auto made = Mp4Film::create({.width = 40, .height = 30});
    ASSERT_TRUE(made);
    EXPECT_FALSE(made->finish());
    EXPECT_FALSE(made->add(moving_square(0, 42, 30)));
}

TEST(Mp4Film, RejectsToDescribeAnotherFile) {
    std::vector<std::byte> file = film(2);
    for (std::size_t size = 0; size < file.size(); size += 7) {
        const auto told = mp4_with_about(std::span(file).first(size), {.title = {{"en", "Pot"}}});
        if (told) continue;  // the index was whole
        EXPECT_EQ(told.error().kind, ErrorKind::kBadInput);
        EXPECT_NE(told.error().message.find("expected a whole film"), std::string::npos);
    }
    EXPECT_FALSE(mp4_with_about({}, {}));
}

}  // namespace
}  // namespace onggi::asset
