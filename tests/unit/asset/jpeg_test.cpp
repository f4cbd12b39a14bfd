#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "engine/asset/image.h"
#include "tests/support/places.h"

namespace onggi::asset {
namespace {

std::string bytes_of(const std::string& path) {
    std::ifstream file(test::in_checkout(path), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::span<const std::byte> as_bytes(const std::string& text) {
    return std::as_bytes(std::span(text));
}

// 16 x 8: left half red, right half blue, 4:4:4, quality 95.
std::string small() {
    return bytes_of("tests/unit/asset/files/red_blue.jpg");
}

TEST(Jpeg, KeepsColoursWithinItsCompressionError) {
    const std::string file = small();
    const Result<Image> image = decode_jpeg(as_bytes(file), "red_blue.jpg");
    ASSERT_TRUE(image) << image.error().message;
    ASSERT_EQ(image->width, 16);
    ASSERT_EQ(image->height, 8);
    ASSERT_EQ(image->rgba.size(), 16U * 8U * 4U);
    const auto expect_pixel = [&](std::size_t x, std::size_t y, int red, int green, int blue) {
        const std::uint8_t* pixel = image->rgba.data() + (y * 16 + x) * 4;
        EXPECT_NEAR(pixel[0], red, 4);
        EXPECT_NEAR(pixel[1], green, 4);
        EXPECT_NEAR(pixel[2], blue, 4);
        EXPECT_EQ(pixel[3], 255);
    };
    expect_pixel(2, 3, 200, 40, 30);
    expect_pixel(13, 5, 20, 60, 180);
}

TEST(Jpeg, ReadsEveryBackgroundOfTheWorkshop) {
    for (const char* name : {"throw_16x9_key", "throw_16x9_ambient", "look_in_16x9_key"}) {
        const std::string file = bytes_of(std::string("assets/workshop/plates/") + name + ".jpg");
        const Result<Image> image = decode_jpeg(as_bytes(file), name);
        ASSERT_TRUE(image) << image.error().message;
        EXPECT_EQ(image->width * 9, image->height * 16);
    }
}

TEST(Jpeg, RejectsOtherFiles) {
    const std::string text = "t_s,x_mm,y_mm,z_mm,button,tool_radius_mm\n0,0,0,0,0,10\n";
    const Result<Image> image = decode_jpeg(as_bytes(text), "gesture.csv");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(image.error().message, "gesture.csv: expected a JPEG, found 54 bytes of something else");
    EXPECT_FALSE(decode_jpeg({}, "nothing"));
}

TEST(Jpeg, RejectsAFileCutAnywhere) {
    const std::string whole = small();
    ASSERT_GT(whole.size(), 100U);
    // The last two bytes are the end marker, which holds nothing that a reader needs.
    for (std::size_t size = 0; size + 2 < whole.size(); ++size) {
        EXPECT_FALSE(decode_jpeg(as_bytes(whole).first(size), "cut")) << size << " of " << whole.size();
    }
}

TEST(Jpeg, RejectsAClaimedSizeBeforeItAllocatesForIt) {
    std::string bytes = small();
    // The frame header: FF C0, length (2 bytes), precision, then height and width, big-endian.
    const std::size_t frame = bytes.find("\xFF\xC0");
    ASSERT_NE(frame, std::string::npos);
    bytes[frame + 5] = '\x7F';
    const Result<Image> image = decode_jpeg(as_bytes(bytes), "huge");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(image.error().message.find("at most 8192"), std::string::npos) << image.error().message;
}

TEST(Jpeg, ReportsErrorsInOneLineWithTheFile) {
    const std::string whole = small();
    const Result<Image> image = decode_jpeg(as_bytes(whole).first(whole.size() - 6), "plates/a.jpg");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().message.rfind("plates/a.jpg: expected a whole JPEG", 0), 0U);
    EXPECT_EQ(image.error().message.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace onggi::asset
