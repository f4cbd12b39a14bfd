#include "engine/render/pixels/overlay_paint.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <random>

namespace onggi::render {
namespace {

constexpr int kOverlayWidth = 61;  // not a multiple of the vector width
constexpr int kOverlayHeight = 23;
constexpr PixelRect kAll{0, 0, kOverlayWidth, kOverlayHeight};
constexpr ui::Colour kGlass{.r = 0.8F, .g = 0.4F, .b = 0.2F, .a = 0.5F};

using Pixels = std::vector<std::uint32_t>;

Pixels painted(const ui::DrawList& list, const PixelRect& inside = kAll, const OverlayPictures& pictures = {},
               ByteOrder order = ByteOrder::kRedFirst) {
    Pixels pixels(static_cast<std::size_t>(kOverlayWidth * kOverlayHeight), 0xDEADBEEF);
    paint_overlay({list, pictures, order}, inside, kOverlayWidth, pixels);
    return pixels;
}

std::uint32_t at(const Pixels& pixels, int x, int y) {
    return pixels[static_cast<std::size_t>(y * kOverlayWidth + x)];
}

int byte_of(std::uint32_t pixel, int byte) {
    return static_cast<int>(pixel >> (8 * byte) & 0xFFU);
}

TEST(OverlayPaint, ClearsTheRectangleAndLeavesItsSurroundings) {
    constexpr PixelRect kInside{5, 3, 17, 4};
    const Pixels pixels = painted({}, kInside);
    for (int y = 0; y < kOverlayHeight; ++y) {
        for (int x = 0; x < kOverlayWidth; ++x) {
            const bool is_inside = x >= 5 && x < 22 && y >= 3 && y < 7;
            ASSERT_EQ(at(pixels, x, y), is_inside ? 0U : 0xDEADBEEFU) << x << ", " << y;
        }
    }
}

TEST(OverlayPaint, CoversThePixelsWhoseMiddleABoxHolds) {
    ui::DrawList list;
    list.add_box({.x = 3.5F, .y = 2.51F, .width = 20.0F, .height = 5.0F}, kGlass);
    const Pixels pixels = painted(list);
    for (int y = 0; y < kOverlayHeight; ++y) {
        for (int x = 0; x < kOverlayWidth; ++x) {
            const bool is_held = x >= 3 && x < 23 && y >= 3 && y < 8;
            ASSERT_EQ(at(pixels, x, y), is_held ? ui::packed(kGlass) : 0U) << x << ", " << y;
        }
    }
}

// Blending a pixel twice or not at all would show along shared edges of triangles.
TEST(OverlayPaint, CoversASidesPixelsOnceWhereTrianglesMeet) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> across(2.0F, kOverlayWidth - 2.0F);
    std::uniform_real_distribution<float> down(2.0F, kOverlayHeight - 2.0F);
    for (int round = 0; round < 200; ++round) {
        const vec2 middle{across(random), down(random)};
        const std::array border{vec2(0.0F), vec2(kOverlayWidth, 0.0F), vec2(kOverlayWidth, kOverlayHeight),
                                vec2(0.0F, kOverlayHeight)};
        ui::DrawList list;
        for (std::size_t i = 0; i < 4; ++i)
            list.add_polygon(std::array{border[i], border[(i + 1) % 4], middle}, kGlass);
        for (const std::uint32_t pixel : painted(list))
            ASSERT_EQ(pixel, ui::packed(kGlass));
    }
}

TEST(OverlayPaint, ShadesABoxBetweenItsCorners) {
    ui::DrawList list;
    const std::array corners{ui::Colour{.r = 1.0F}, ui::Colour{.g = 1.0F}, ui::Colour{.b = 1.0F, .a = 0.5F},
                             ui::Colour{.a = 0.0F}};
    list.add_box({.x = 0.0F, .y = 0.0F, .width = kOverlayWidth, .height = kOverlayHeight}, corners);
    const Pixels pixels = painted(list);
    for (int y = 0; y < kOverlayHeight; ++y) {
        for (int x = 0; x < kOverlayWidth; ++x) {
            const float u = (static_cast<float>(x) + 0.5F) / kOverlayWidth;
            const float v = (static_cast<float>(y) + 0.5F) / kOverlayHeight;
            for (int byte = 0; byte < 4; ++byte) {
                const auto value = [&](std::size_t corner) {
                    return static_cast<float>(byte_of(ui::packed(corners[corner]), byte));
                };
                const float wanted = (value(0) * (1.0F - u) + value(1) * u) * (1.0F - v) +
                                     (value(3) * (1.0F - u) + value(2) * u) * v;
                ASSERT_NEAR(byte_of(at(pixels, x, y), byte), wanted, 0.51F) << x << ", " << y;
            }
        }
    }
}

std::shared_ptr<const ui::Painting> numbered(int width, int height) {
    ui::Painting painting{.width = width, .height = height, .rgba = {}};
    for (int i = 0; i < width * height; ++i) {
        const auto tone = static_cast<std::uint8_t>(i % 200);
        painting.rgba.insert(painting.rgba.end(), {tone, 7, 200, 255});
    }
    return std::make_shared<const ui::Painting>(std::move(painting));
}

TEST(OverlayPaint, PutsAPicturesPixelsWhereTheyBelong) {
    OverlayPictures pictures;
    pictures.take(std::vector<ui::Atlas::Upload>{{100, 40, numbered(9, 5)}}, 256);
    ui::DrawList list;
    list.add_picture({20.4F, 6.0F}, {.x = 100.0F, .y = 40.0F, .width = 9.0F, .height = 5.0F}, 1.0F);
    list.add_picture({-4.0F, 20.0F}, {.x = 100.0F, .y = 40.0F, .width = 9.0F, .height = 5.0F}, 1.0F);
    list.add_picture({2.0F, 2.0F}, {.x = 7.0F, .y = 7.0F, .width = 9.0F, .height = 5.0F}, 1.0F);  // not there
    const Pixels red_first = painted(list, kAll, pictures);
    const Pixels blue_first = painted(list, kAll, pictures, ByteOrder::kBlueFirst);
    for (int y = 0; y < kOverlayHeight; ++y) {
        for (int x = 0; x < kOverlayWidth; ++x) {
            std::uint32_t wanted = 0;
            std::uint32_t turned = 0;
            for (const glm::ivec2 corner : {glm::ivec2(20, 6), glm::ivec2(-4, 20)}) {
                const glm::ivec2 in = glm::ivec2(x, y) - corner;
                if (in.x < 0 || in.x >= 9 || in.y < 0 || in.y >= 5) continue;
                const auto tone = static_cast<std::uint32_t>((in.y * 9 + in.x) % 200);
                wanted = 0xFFC80700U | tone;
                turned = 0xFF0007C8U | tone << 16U;
            }
            ASSERT_EQ(at(red_first, x, y), wanted) << x << ", " << y;
            ASSERT_EQ(at(blue_first, x, y), turned) << x << ", " << y;
        }
    }
}

// Compares the blending with exact arithmetic.
TEST(OverlayPaint, LaysColoursOverEachOtherWithinTwoLevels) {
    std::mt19937 random(9);
    std::uniform_real_distribution<float> fraction(0.0F, 1.0F);
    for (int round = 0; round < 100; ++round) {
        ui::DrawList list;
        std::array<float, 4> wanted{};
        for (int layer = 0; layer < 3; ++layer) {
            const ui::Colour colour{fraction(random), fraction(random), fraction(random), fraction(random)};
            list.add_box({.x = 0.0F, .y = 0.0F, .width = kOverlayWidth, .height = kOverlayHeight}, colour);
            const std::array over{colour.r * colour.a, colour.g * colour.a, colour.b * colour.a, colour.a};
            for (std::size_t i = 0; i < 4; ++i)
                wanted[i] = over[i] * 255.0F + wanted[i] * (1.0F - colour.a);
        }
        const Pixels over = painted(list);
        const std::uint32_t under = static_cast<std::uint32_t>(random()) | 0xFF000000U;
        Pixels laid(over.size(), 0);
        lay_over(over, Pixels(over.size(), under), kAll, kOverlayWidth, laid);
        for (int byte = 0; byte < 4; ++byte) {
            const auto i = static_cast<std::size_t>(byte);
            ASSERT_NEAR(byte_of(over[0], byte), wanted[i], 2.0F);
            const float together =
                wanted[i] + static_cast<float>(byte_of(under, byte)) * (1.0F - wanted[3] / 255.0F);
            ASSERT_NEAR(byte_of(laid.back(), byte), together, 2.5F);
        }
    }
}

TEST(OverlayPaint, IsExactForOpaqueAndTransparentPixels) {
    ui::DrawList list;
    list.add_box({.x = 0.0F, .y = 0.0F, .width = 30.0F, .height = kOverlayHeight},
                 ui::Colour{.r = 0.3F, .g = 1.0F});
    const Pixels over = painted(list);
    Pixels under(over.size());
    std::mt19937 random(2);
    for (std::uint32_t& pixel : under)
        pixel = static_cast<std::uint32_t>(random()) | 0xFF000000U;
    Pixels laid(over.size(), 0);
    lay_over(over, under, kAll, kOverlayWidth, laid);
    for (int y = 0; y < kOverlayHeight; ++y) {
        for (int x = 0; x < kOverlayWidth; ++x)
            ASSERT_EQ(at(laid, x, y), x < 30 ? at(over, x, y) : at(under, x, y));
    }
}

}  // namespace
}  // namespace onggi::render
