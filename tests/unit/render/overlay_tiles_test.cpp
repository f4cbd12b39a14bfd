#include "engine/render/overlay_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>

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

struct Drawn {
    std::vector<std::uint32_t> indices;
    std::vector<ClippedRun> runs;
};

Drawn drawn(OverlayTiles& tiles, const ui::DrawList& list, std::initializer_list<std::size_t> wanted_tiles) {
    std::vector<std::uint8_t> wanted(kGrid.count(), 0);
    for (const std::size_t wanted_tile : wanted_tiles)
        wanted[wanted_tile] = 1;
    Drawn taken;
    tiles.take(list, wanted, taken.indices, taken.runs);
    return taken;
}

TEST(OverlayTiles, NumberWhatLiesOnEachAndNothingElse) {
    ui::DrawList list;
    list.add_box({.x = 0.0F, .y = 0.0F, .width = 3.0F * kTileWidthPx, .height = 4.0F}, kPaper);
    list.add_box(inside(1, 0), kPaper);
    list.add_box(inside(5, 9), kPaper);
    OverlayTiles tiles;
    tiles.learn(kGrid, list, list.hash(), 1);
    const std::span<const std::uint64_t> content = tiles.content();
    EXPECT_EQ(content[tile(0, 0)], content[tile(2, 0)]) << "the same box alone";
    EXPECT_NE(content[tile(1, 0)], content[tile(0, 0)]) << "with another over it";
    EXPECT_NE(content[tile(5, 9)], 0U);
    EXPECT_EQ(std::count(content.begin(), content.end(), 0U), static_cast<std::ptrdiff_t>(kGrid.count()) - 4);
}

TEST(OverlayTiles, AreDrawnInsideThoseThatAreWanted) {
    ui::DrawList list;
    list.add_box({.x = 0.0F, .y = 0.0F, .width = 3.0F * kTileWidthPx, .height = 4.0F}, kPaper);
    list.add_box(inside(1, 0), kPaper);
    list.add_picture(inside(5, 9), {.x = 0.0F, .y = 0.0F, .width = 5.0F, .height = 3.0F}, 1.0F);
    OverlayTiles tiles;
    tiles.learn(kGrid, list, list.hash(), 1);
    const Drawn one = drawn(tiles, list, {tile(2, 0)});
    ASSERT_EQ(one.runs.size(), 1U);
    EXPECT_EQ(one.runs[0].inside, (PixelRect{2 * kTileWidthPx, 0, kTileWidthPx, kTileHeightPx}));
    EXPECT_EQ(one.indices.size(), 6U);
    const Drawn both = drawn(tiles, list, {tile(1, 0), tile(5, 9)});
    ASSERT_EQ(both.runs.size(), 2U);
    EXPECT_EQ(both.runs[0].run.index_count, 12U);
    EXPECT_FALSE(both.runs[0].run.from_atlas);
    EXPECT_EQ(both.runs[1].run.first_index, 12U);
    EXPECT_TRUE(both.runs[1].run.from_atlas);
    EXPECT_TRUE(drawn(tiles, list, {tile(3, 3)}).runs.empty());
}

TEST(OverlayTiles, ChangeTheirNumberWithPlaceColourAndAtlas) {
    const auto number = [](const ui::Rect& rect, const ui::Colour& colour, std::uint64_t atlas_state) {
        ui::DrawList list;
        list.add_box(rect, colour);
        OverlayTiles tiles;
        tiles.learn(kGrid, list, list.hash(), atlas_state);
        return tiles.content()[tile(1, 1)];
    };
    const ui::Rect rect = inside(1, 1);
    ui::Rect moved = rect;
    moved.x += 0.25F;
    EXPECT_EQ(number(rect, kPaper, 3), number(rect, kPaper, 3));
    EXPECT_NE(number(rect, kPaper, 3), number(moved, kPaper, 3));
    EXPECT_NE(number(rect, kPaper, 3), number(rect, kPaper.with_alpha(0.6F), 3));
    EXPECT_NE(number(rect, kPaper, 3), number(rect, kPaper, 4));
}

TEST(OverlayTiles, KeepTheirNumberWhereSomethingElseMoves) {
    OverlayTiles tiles;
    const auto numbers = [&](const ui::Rect& moving) {
        ui::DrawList list;
        list.add_box(inside(1, 1), kPaper);
        list.add_box(moving, kPaper);
        tiles.learn(kGrid, list, list.hash(), 3);
        return std::vector<std::uint64_t>(tiles.content().begin(), tiles.content().end());
    };
    const std::vector<std::uint64_t> before = numbers(inside(4, 4));
    const std::vector<std::uint64_t> after = numbers(inside(4, 5));
    EXPECT_EQ(after[tile(1, 1)], before[tile(1, 1)]);
    EXPECT_EQ(after[tile(4, 4)], 0U);
    EXPECT_NE(after[tile(4, 5)], 0U);
}

TEST(OverlayTiles, LeaveOutWhatLiesBesideThePicture) {
    ui::DrawList list;
    list.add_box({.x = -50.0F, .y = 10.0F, .width = 20.0F, .height = 20.0F}, kPaper);
    list.add_box({.x = 4.0F, .y = 1e9F, .width = 20.0F, .height = 20.0F}, kPaper);
    OverlayTiles tiles;
    tiles.learn(kGrid, list, list.hash(), 1);
    EXPECT_EQ(std::count(tiles.content().begin(), tiles.content().end(), 0U),
              static_cast<std::ptrdiff_t>(kGrid.count()));
}

}  // namespace
}  // namespace onggi::render
