#include "engine/render/pixels/overlay_paint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace onggi::render {
namespace {

constexpr TileGrid kGrid{.width_px = 10 * kTileWidthPx, .height_px = 20 * kTileHeightPx};
constexpr ui::Colour kPaper{.r = 0.9F, .g = 0.9F, .b = 0.8F, .a = 0.5F};

std::size_t tile(int column, int row) {
    return static_cast<std::size_t>(row * kGrid.across() + column);
}

// A box well inside a tile.
ui::Rect inside(int column, int row) {
    return {.x = static_cast<float>(column * kTileWidthPx + 3),
            .y = static_cast<float>(row * kTileHeightPx + 2),
            .width = 5.0F,
            .height = 3.0F};
}

TEST(OverlayTiles, HashOnlyTheirOwnContents) {
    ui::DrawList list;
    list.add_box({.x = 0.0F, .y = 0.0F, .width = 3.0F * kTileWidthPx, .height = 4.0F}, kPaper);
    list.add_box(inside(1, 0), kPaper);
    list.add_box(inside(5, 9), kPaper);
    OverlayTiles tiles;
    tiles.learn(kGrid, list, {});
    const std::span<const std::uint64_t> content = tiles.content();
    EXPECT_EQ(content[tile(0, 0)], content[tile(2, 0)]) << "the same box alone";
    EXPECT_NE(content[tile(1, 0)], content[tile(0, 0)]) << "with another over it";
    EXPECT_NE(content[tile(5, 9)], 0U);
    EXPECT_EQ(std::count(content.begin(), content.end(), 0U), static_cast<std::ptrdiff_t>(kGrid.count()) - 4);
}

TEST(OverlayTiles, ChangeTheirNumberWithPlaceAndColour) {
    const auto number = [](const ui::Rect& rect, const ui::Colour& colour) {
        ui::DrawList list;
        list.add_box(rect, colour);
        OverlayTiles tiles;
        tiles.learn(kGrid, list, {});
        return tiles.content()[tile(1, 1)];
    };
    const ui::Rect rect = inside(1, 1);
    ui::Rect moved = rect;
    moved.x += 0.25F;
    EXPECT_EQ(number(rect, kPaper), number(rect, kPaper));
    EXPECT_NE(number(rect, kPaper), number(moved, kPaper));
    EXPECT_NE(number(rect, kPaper), number(rect, kPaper.with_alpha(0.6F)));
}

TEST(OverlayTiles, ChangeTheirNumberWithTheirPictureAndNoOthers) {
    const auto picture = std::make_shared<const ui::Painting>(
        ui::Painting{.width = 5, .height = 3, .rgba = std::vector<std::uint8_t>(60, 200)});
    ui::DrawList list;
    list.add_picture({40.0F, 10.0F}, {.x = 0.0F, .y = 0.0F, .width = 5.0F, .height = 3.0F}, 1.0F);
    list.add_picture({40.0F, 40.0F}, {.x = 8.0F, .y = 0.0F, .width = 5.0F, .height = 3.0F}, 1.0F);
    OverlayPictures pictures;
    pictures.take(std::vector<ui::Atlas::Upload>{{0, 0, picture}, {8, 0, picture}}, 64);
    OverlayTiles tiles;
    const auto numbers = [&] {
        tiles.learn(kGrid, list, pictures);
        return std::vector<std::uint64_t>(tiles.content().begin(), tiles.content().end());
    };
    const std::vector<std::uint64_t> before = numbers();
    pictures.take(std::vector<ui::Atlas::Upload>{{8, 0, picture}}, 64);
    const std::vector<std::uint64_t> after = numbers();
    EXPECT_EQ(after[tile(1, 1)], before[tile(1, 1)]);
    EXPECT_NE(after[tile(1, 5)], before[tile(1, 5)]);
}

TEST(OverlayTiles, KeepTheirNumberWhereSomethingElseMoves) {
    OverlayTiles tiles;
    const auto numbers = [&](const ui::Rect& moving) {
        ui::DrawList list;
        list.add_box(inside(1, 1), kPaper);
        list.add_box(moving, kPaper);
        tiles.learn(kGrid, list, {});
        return std::vector<std::uint64_t>(tiles.content().begin(), tiles.content().end());
    };
    const std::vector<std::uint64_t> before = numbers(inside(4, 4));
    const std::vector<std::uint64_t> after = numbers(inside(4, 5));
    EXPECT_EQ(after[tile(1, 1)], before[tile(1, 1)]);
    EXPECT_EQ(after[tile(4, 4)], 0U);
    EXPECT_NE(after[tile(4, 5)], 0U);
}

TEST(OverlayTiles, IgnoreShapesOutsideThePicture) {
    ui::DrawList list;
    list.add_box({.x = -50.0F, .y = 10.0F, .width = 20.0F, .height = 20.0F}, kPaper);
    list.add_box({.x = 4.0F, .y = 1e9F, .width = 20.0F, .height = 20.0F}, kPaper);
    OverlayTiles tiles;
    tiles.learn(kGrid, list, {});
    EXPECT_EQ(std::count(tiles.content().begin(), tiles.content().end(), 0U),
              static_cast<std::ptrdiff_t>(kGrid.count()));
}

}  // namespace
}  // namespace onggi::render
