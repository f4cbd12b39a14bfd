#include <gtest/gtest.h>

#include <string_view>

#include "engine/asset/image.h"

namespace onggi::asset {
namespace {

Image gradient(int width, int height) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int value : {x * 5, y * 7, x * y, 255 - x}) {
                image.rgba.push_back(static_cast<std::uint8_t>(value));
            }
        }
    }
    return image;
}

std::vector<std::byte> encoded(const Image& image) {
    const Result<std::vector<std::byte>> bytes = encode_png(image);
    EXPECT_TRUE(bytes) << (bytes ? "" : bytes.error().message);
    return bytes ? *bytes : std::vector<std::byte>{};
}

TEST(Png, BringsEveryPixelBack) {
    for (const Image& image : {gradient(1, 1), gradient(37, 19), gradient(640, 480)}) {
        const Result<Image> back = decode_png(encoded(image), "test");
        ASSERT_TRUE(back) << back.error().message;
        EXPECT_EQ(*back, image);
    }
}

TEST(Png, KeepsTransparentPixelsColours) {
    const Image image{2, 1, {200, 100, 50, 0, 1, 2, 3, 128}};
    const Result<Image> back = decode_png(encoded(image), "test");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->rgba, image.rgba);
}

TEST(Png, GivesTheSameBytesForTheSamePictureAndStoresNoTime) {
    const std::vector<std::byte> bytes = encoded(gradient(64, 48));
    EXPECT_EQ(bytes, encoded(gradient(64, 48)));
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    EXPECT_EQ(text.find("tIME"), std::string::npos);
    EXPECT_EQ(text.find("tEXt"), std::string::npos);
}

TEST(Png, RejectsAPictureWhoseBytesDoNotFitItsSize) {
    for (const Image& image :
         {Image{2, 2, std::vector<std::uint8_t>(15)}, Image{0, 4, {}}, Image{-1, 4, {}},
          Image{kMaxImageSide + 1, 1, std::vector<std::uint8_t>((kMaxImageSide + 1) * 4)}}) {
        const Result<std::vector<std::byte>> bytes = encode_png(image);
        ASSERT_FALSE(bytes);
        EXPECT_EQ(bytes.error().kind, ErrorKind::kBadInput);
    }
}

TEST(Png, RejectsOtherFiles) {
    const std::string_view text = "t_s,x_mm,y_mm,z_mm,button,tool_radius_mm\n0,0,0,0,0,10\n";
    const Result<Image> image = decode_png(std::as_bytes(std::span(text)), "gesture.csv");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(image.error().message.rfind("gesture.csv: expected a PNG, found 54 bytes", 0), 0U)
        << image.error().message;
    EXPECT_FALSE(decode_png({}, "nothing"));
}

TEST(Png, RejectsAFileCutAnywhere) {
    const std::vector<std::byte> whole = encoded(gradient(16, 16));
    // The last twelve bytes are the end chunk, which holds nothing that a reader needs.
    for (std::size_t size = 0; size + 12 < whole.size(); ++size) {
        EXPECT_FALSE(decode_png(std::span(whole).first(size), "cut")) << size << " of " << whole.size();
    }
}

TEST(Png, RejectsAFlippedBitInThePixels) {
    std::vector<std::byte> bytes = encoded(gradient(16, 16));
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t pixels = text.find("IDAT");
    ASSERT_NE(pixels, std::string_view::npos);
    bytes[pixels + 20] ^= std::byte{1};
    EXPECT_FALSE(decode_png(bytes, "flipped"));
}

TEST(Png, RejectsAClaimedSizeBeforeItAllocatesForIt) {
    std::vector<std::byte> bytes = encoded(gradient(1, 1));
    // IHDR's width, big-endian, at 16; its checksum, over type and data, must fit or that alone would be
    // refused.
    bytes[16] = std::byte{0x7F};
    std::uint32_t crc = 0xFFFFFFFFU;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= std::to_integer<std::uint32_t>(bytes[i]);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    crc = ~crc;
    for (std::size_t i = 0; i < 4; ++i)
        bytes[29 + i] = std::byte{static_cast<unsigned char>(crc >> (24 - 8 * i))};
    const Result<Image> image = decode_png(bytes, "huge");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().kind, ErrorKind::kBadInput);
}

}  // namespace
}  // namespace onggi::asset
