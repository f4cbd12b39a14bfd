// The picture as rectangles of pixels, and as tiles. Any thread; pure functions. Pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/math.h"

namespace onggi::render {

// A rectangle of pixels, clipped to the picture; empty if width or height is 0.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

// Rows of a picture, from the top.
struct RowSpan {
    int first = 0;
    int end = 0;  // one after the last row
};

// The part of a rectangle in these rows; empty if there is none.
[[nodiscard]] constexpr PixelRect within(const PixelRect& rect, const RowSpan& rows) {
    const int top = std::max(rect.y, rows.first);
    return {rect.x, top, rect.width, std::max(std::min(rect.y + rect.height, rows.end) - top, 0)};
}

constexpr int kTileWidthPx = 32;
constexpr int kTileHeightPx = 8;

// The picture's tiles, row by row; tiles at the right and bottom borders may be partial.
struct TileGrid {
    int width_px = 0;
    int height_px = 0;

    [[nodiscard]] int across() const { return (width_px + kTileWidthPx - 1) / kTileWidthPx; }
    [[nodiscard]] int down() const { return (height_px + kTileHeightPx - 1) / kTileHeightPx; }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(across() * down()); }
    friend bool operator==(const TileGrid&, const TileGrid&) = default;
};

// The pixels that a box with these corners, in pixels, touches.
[[nodiscard]] PixelRect rect_about(vec2 low, vec2 high);

// Calls `visit` with the number of each tile that the rectangle touches. The rectangle may extend beyond the
// picture.
template <typename Visit>
void for_tiles(const TileGrid& grid, const PixelRect& rect, Visit visit) {
    if (rect.width <= 0 || rect.height <= 0) return;
    const int left = std::max(rect.x, 0) / kTileWidthPx;
    const int top = std::max(rect.y, 0) / kTileHeightPx;
    const int right = std::min((rect.x + rect.width - 1 + kTileWidthPx) / kTileWidthPx, grid.across());
    const int bottom = std::min((rect.y + rect.height - 1 + kTileHeightPx) / kTileHeightPx, grid.down());
    for (int row = top; row < bottom; ++row) {
        for (int column = left; column < right; ++column)
            visit(static_cast<std::size_t>(row * grid.across() + column));
    }
}

// Marks the tiles that the rectangle touches.
void want_tiles(const TileGrid& grid, const PixelRect& rect, std::span<std::uint8_t> wanted);

// Computes disjoint rectangles that together cover the marked tiles (one entry per tile, 0 or 1).
void rects_of_tiles(const TileGrid& grid, std::span<const std::uint8_t> wanted,
                    std::vector<PixelRect>& rects);

// Copies a rectangle to the same place of another picture; both are width_px wide.
template <typename Pixel>
void copy_rect(std::span<const Pixel> from, const PixelRect& rect, std::size_t width_px,
               std::span<Pixel> into) {
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
        const auto first =
            static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * width_px) + std::ptrdiff_t{rect.x};
        std::copy_n(from.begin() + first, rect.width, into.begin() + first);
    }
}

}  // namespace onggi::render
